#include "app/gui/scene_listing.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>
#include <string_view>
#include <system_error>

namespace atrium::gui {
namespace {

namespace fs = std::filesystem;

bool is_scene(const fs::path& file)
{
    std::string ending = file.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
    constexpr std::array<std::string_view, 3> scenes{".atrium", ".toml", ".obj"};
    return std::find(scenes.begin(), scenes.end(), ending) != scenes.end();
}

/// Where the last name of a path begins.
std::size_t name_start(const std::string& typed)
{
    return typed.rfind('/') + 1; // npos + 1 is 0
}

bool is_folder(const std::string& line)
{
    return line.ends_with('/');
}

std::string common_start(const std::vector<std::string>& lines)
{
    std::string common = lines.front();
    for (const std::string& line : lines) {
        const auto differs = std::mismatch(common.begin(), common.end(), line.begin(), line.end());
        common.erase(differs.first, common.end());
    }
    return common;
}

} // namespace

fs::path typed_path(const std::string& typed)
{
    const char* home = std::getenv("HOME");
    if (home && typed.starts_with("~/")) return home + typed.substr(1);
    return typed;
}

std::string with_line(const std::string& typed, const std::string& line)
{
    return typed.substr(0, name_start(typed)) + line;
}

SceneListing list_scenes(const std::string& typed)
{
    SceneListing out;
    const std::string before = typed.substr(0, name_start(typed)), name = typed.substr(name_start(typed));
    std::error_code error;
    out.folder = before.empty() ? fs::current_path(error) : typed_path(before);
    out.completed = typed;
    for (fs::directory_iterator at(out.folder, error), end; !error && at != end; at.increment(error)) {
        const std::string line = at->path().filename().string();
        if (!line.starts_with(name) || (line.starts_with('.') && !name.starts_with('.'))) continue;
        std::error_code unknown; // a link that leads nowhere is none of them
        if (at->is_directory(unknown))
            out.lines.push_back(line + '/');
        else if (at->is_regular_file(unknown) && is_scene(line))
            out.lines.push_back(line);
    }
    std::sort(out.lines.begin(), out.lines.end(), [](const std::string& a, const std::string& b) {
        return is_folder(a) != is_folder(b) ? is_folder(a) : a < b;
    });
    if (!out.lines.empty()) out.completed = with_line(typed, common_start(out.lines));
    return out;
}

} // namespace atrium::gui
