// Who may know whom (ARCHITECTURE.md): an include that points the other way fails here.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>

namespace {

namespace fs = std::filesystem;

/// Folder to the folders it may include; every folder may include itself.
const std::map<std::string, std::set<std::string>>& allowed()
{
    static const std::map<std::string, std::set<std::string>> table{
        {"renderer/core", {}},
        {"renderer/metrics", {"renderer/core"}},
        {"renderer/scene", {"renderer/core"}},
        {"renderer/gpu", {"renderer/core"}},
        {"renderer/graph", {"renderer/core", "renderer/gpu", "shaders"}},
        {"renderer/materials", {"renderer/core", "renderer/scene", "shaders"}},
        {"renderer/techniques",
         {"renderer/core", "renderer/scene", "renderer/gpu", "renderer/graph", "renderer/materials", "shaders"}},
        {"renderer",
         {"renderer/core", "renderer/scene", "renderer/gpu", "renderer/graph", "renderer/materials",
          "renderer/techniques", "shaders"}},
        {"assetconv", {"renderer/core", "renderer/scene"}},
        {"app",
         {"app/gui", "renderer", "renderer/core", "renderer/metrics", "renderer/scene", "renderer/gpu",
          "renderer/graph", "renderer/materials", "renderer/techniques", "shaders"}},
        {"app/gui", {"app", "renderer", "renderer/core", "renderer/scene", "shaders"}},
        {"shaders", {"renderer/core", "shaders"}},
    };
    return table;
}

/// The folder of the table in which a path lies; empty for files of no layer.
std::string layer_of(const std::string& path)
{
    std::string best;
    for (const auto& [folder, unused] : allowed()) {
        if (path.starts_with(folder + "/") && folder.size() > best.size()) best = folder;
    }
    return best;
}

TEST(layers, includes_point_downwards)
{
    const fs::path root = ATRIUM_SOURCE;
    const std::regex include("^\\s*#include \"([^\"]+)\"");
    std::size_t looked_at = 0;
    for (const auto& [folder, may] : allowed()) {
        for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
            const std::string extension = entry.path().extension().string();
            if (extension != ".hpp" && extension != ".cpp" && extension != ".h") continue;
            const std::string path = fs::relative(entry.path(), root).string();
            if (layer_of(path) != folder) continue; // a folder of its own inside this one
            std::ifstream in(entry.path());
            std::string line;
            while (std::getline(in, line)) {
                std::smatch match;
                if (!std::regex_search(line, match, include)) continue;
                const std::string target = layer_of(match[1].str());
                if (target.empty() || target == folder) continue;
                ++looked_at;
                EXPECT_TRUE(may.contains(target)) << path << " includes " << match[1];
            }
        }
    }
    EXPECT_GT(looked_at, 100u);
}

TEST(layers, no_technique_includes_another_technique_s_sources_but_the_shared_ones)
{
    // Techniques pass images to each other in frame.cpp. Several of them may use common, culling and the G-buffer.
    const std::set<std::string> shared{"common", "culling", "gbuffer", "lighting"};
    const fs::path root = fs::path(ATRIUM_SOURCE) / "renderer" / "techniques";
    const std::regex include("#include \"renderer/techniques/([a-z_]+)/");
    std::size_t looked_at = 0;
    for (const auto& entry : fs::recursive_directory_iterator(root)) {
        if (entry.path().extension() != ".cpp" && entry.path().extension() != ".hpp") continue;
        const std::string own = entry.path().parent_path().filename().string();
        std::ifstream in(entry.path());
        std::string line;
        while (std::getline(in, line)) {
            std::smatch match;
            if (!std::regex_search(line, match, include)) continue;
            const std::string other = match[1];
            ++looked_at;
            EXPECT_TRUE(other == own || shared.contains(other)) << entry.path() << " includes " << other;
        }
    }
    EXPECT_GT(looked_at, 20u);
}

} // namespace
