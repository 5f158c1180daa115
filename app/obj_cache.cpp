// OBJ files given as SCENE: baked once by assetconv, in a process of its own, so that a hostile file cannot take this
// program down; kept in the cache until the file or anything beside it changes.

#include "app/child_process.hpp"
#include "app/scene_input.hpp"

#include "renderer/core/error.hpp"
#include "renderer/core/hash.hpp"
#include "renderer/core/log.hpp"
#include "renderer/scene/bake_format.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <vector>

namespace atrium::app {
namespace {

constexpr std::size_t max_files_looked_at = 10000; ///< an OBJ in a crowded folder must not take seconds to look around

/// Changes when a file in the OBJ's folder or below (MTL, textures) does.
std::string folder_state(const std::filesystem::path& folder)
{
    std::vector<std::string> lines;
    std::error_code ignored;
    for (auto it = std::filesystem::recursive_directory_iterator(
             folder, std::filesystem::directory_options::skip_permission_denied, ignored);
         it != std::filesystem::recursive_directory_iterator() && lines.size() < max_files_looked_at;
         it.increment(ignored)) {
        if (!it->is_regular_file(ignored)) continue;
        const auto time = it->last_write_time(ignored).time_since_epoch().count();
        lines.push_back(fmt::format("{} {} {}\n", it->path().string(), it->file_size(ignored), time));
    }
    std::sort(lines.begin(), lines.end()); // folders list in any order
    std::string state;
    for (const std::string& line : lines) state += line;
    return state;
}

} // namespace

std::filesystem::path cache_folder()
{
    if (const char* xdg = std::getenv("XDG_CACHE_HOME"); xdg && *xdg) return std::filesystem::path(xdg) / "atrium";
    if (const char* home = std::getenv("HOME"); home && *home) return std::filesystem::path(home) / ".cache" / "atrium";
    return {};
}

std::filesystem::path bake_to_cache(const std::filesystem::path& obj, double scale, const std::string& up)
{
    if (!std::filesystem::is_regular_file(obj)) {
        throw Error(ExitCode::input, fmt::format("scene not found: {}", obj.string()), "", "there is no such file",
                    "check the path");
    }
    const std::filesystem::path cache = cache_folder();
    if (cache.empty()) {
        throw Error(ExitCode::environment, "no folder for the bake of an OBJ", obj.string(),
                    "neither XDG_CACHE_HOME nor HOME is set",
                    "set one, or bake by hand: assetconv bake SCENE.obj -o SCENE.atrium");
    }
    const std::filesystem::path absolute = std::filesystem::canonical(obj);
    const std::string key = fmt::format("{}\n{}\n{}\n{}\n{}\n{}", absolute.string(), scale, up, bake::format_version,
                                        ATRIUM_VERSION, folder_state(absolute.parent_path()));
    std::filesystem::path target =
        cache / "bakes" / fmt::format("{}-{:016x}.atrium", obj.stem().string(), hash64(std::as_bytes(std::span(key))));
    if (std::filesystem::exists(target)) return target;

    const std::filesystem::path converter = this_program().parent_path() / "assetconv";
    if (!std::filesystem::exists(converter)) {
        throw Error(ExitCode::environment, "assetconv is missing", converter.string(),
                    "it bakes OBJ files and stands beside atrium", "build or install both programs together");
    }
    std::filesystem::create_directories(target.parent_path());
    log_info(fmt::format("baking {} to {}", obj.string(), target.string()));
    const int code = ChildProcess({converter.string(), "bake", absolute.string(), "-o", target.string(), "--scale",
                                   fmt::format("{}", scale), "--up", up})
                         .wait();
    if (code != 0) {
        throw Error(code > 0 && code <= 5 ? static_cast<ExitCode>(code) : ExitCode::input,
                    fmt::format("{} could not be baked", obj.string()), converter.string(),
                    code < 0 ? fmt::format("it was stopped by signal {}", -code)
                             : fmt::format("it ended with {}; its message is above", code),
                    "mend the file, or report this when it should work");
    }
    return target;
}

} // namespace atrium::app
