// In a process of its own, so that a hostile file cannot take this program down.

#include "app/obj_bake.hpp"

#include "app/scene_input.hpp"

#include "renderer/core/error.hpp"
#include "renderer/core/hash.hpp"
#include "renderer/core/log.hpp"
#include "renderer/scene/bake_format.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <string_view>
#include <system_error>
#include <utility>
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

/// Cuts the last part of that label off a message, as Error::text() writes it.
std::string cut_part(std::string& message, std::string_view label)
{
    const std::size_t at = message.rfind(label);
    if (at == std::string::npos) return "";
    std::string part = message.substr(at + label.size());
    message.erase(at);
    return part;
}

/// The error with which assetconv ended, from all that it said.
std::optional<Error> said_error(const std::string& said, ExitCode code)
{
    constexpr std::string_view name = "assetconv: ";
    const std::size_t at = said.rfind(name);
    if (at == std::string::npos) return std::nullopt;
    std::string message = said.substr(at + name.size());
    while (message.ends_with('\n')) message.pop_back();
    std::string next = cut_part(message, "\n  next:  "), why = cut_part(message, "\n  why:   ");
    std::string where = cut_part(message, "\n  where: ");
    return Error(code, message, std::move(where), std::move(why), std::move(next));
}

} // namespace

std::filesystem::path cache_folder()
{
    if (const char* xdg = std::getenv("XDG_CACHE_HOME"); xdg && *xdg) return std::filesystem::path(xdg) / "atrium";
    if (const char* home = std::getenv("HOME"); home && *home) return std::filesystem::path(home) / ".cache" / "atrium";
    return {};
}

ObjBake::ObjBake(const std::filesystem::path& obj, double scale, const std::string& up, Output output) : obj_(obj)
{
    std::error_code error;
    if (!std::filesystem::is_regular_file(obj, error)) {
        throw Error(ExitCode::input, fmt::format("scene not found: {}", obj.string()), obj.string(),
                    "there is no such file", "check the path");
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
    bake_ =
        cache / "bakes" / fmt::format("{}-{:016x}.atrium", obj.stem().string(), hash64(std::as_bytes(std::span(key))));
    if (std::filesystem::exists(bake_)) return;

    const std::filesystem::path converter = this_program().parent_path() / "assetconv";
    if (!std::filesystem::exists(converter)) {
        throw Error(ExitCode::environment, "assetconv is missing", converter.string(),
                    "it bakes OBJ files and stands beside atrium", "build or install both programs together");
    }
    std::filesystem::create_directories(bake_.parent_path(), error);
    if (error) {
        throw Error(ExitCode::environment, "no folder for the bake of an OBJ", bake_.parent_path().string(),
                    error.message(), "set XDG_CACHE_HOME to a folder that can be written");
    }
    log_info(fmt::format("baking {} to {}", obj.string(), bake_.string()));
    if (output == Output::kept) scratch_.emplace();
    child_.emplace(std::vector<std::string>{converter.string(), "bake", absolute.string(), "-o", bake_.string(),
                                            "--scale", fmt::format("{}", scale), "--up", up},
                   scratch_ ? said_file() : std::filesystem::path());
}

bool ObjBake::done()
{
    if (!child_) return true;
    const std::optional<int> code = child_->ended();
    if (code) check(*code);
    return code.has_value();
}

void ObjBake::wait()
{
    if (child_) check(child_->wait());
}

std::string ObjBake::progress() const
{
    if (!scratch_) return "";
    std::string said = read_text(said_file());
    while (said.ends_with('\n')) said.pop_back();
    return said.substr(said.rfind('\n') + 1); // all of it where there is one line
}

std::filesystem::path ObjBake::said_file() const
{
    return scratch_->path() / "said";
}

void ObjBake::check(int code) const
{
    if (code == 0) return;
    const ExitCode kind = code > 0 && code <= 5 ? static_cast<ExitCode>(code) : ExitCode::input;
    if (scratch_) {
        if (const auto said = said_error(read_text(said_file()), kind)) throw *said;
    }
    throw Error(kind, fmt::format("{} could not be baked", obj_.string()), obj_.string(),
                code < 0 ? fmt::format("assetconv was stopped by signal {}", -code)
                         : fmt::format("assetconv ended with {}{}", code, scratch_ ? "" : "; its message is above"),
                "mend the file, or report this when it should work");
}

} // namespace atrium::app
