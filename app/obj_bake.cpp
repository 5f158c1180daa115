// In a process of its own, so that a hostile file cannot take this program down.

#include "app/obj_bake.hpp"

#include "app/scene_input.hpp"

#include "renderer/core/error.hpp"
#include "renderer/core/log.hpp"
#include "renderer/scene/bake_format.hpp"

#include <fmt/format.h>

#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace atrium::app {
namespace {

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

ObjBake::ObjBake(const std::filesystem::path& obj, double scale, const std::string& up, Output output)
    : obj_(obj), cached_(obj, fmt::format("{}\n{}\n{}\n{}\n{}", std::filesystem::absolute(obj).string(), scale, up,
                                          bake::format_version, ATRIUM_VERSION))
{
    std::error_code error;
    if (!std::filesystem::is_regular_file(obj, error)) {
        throw Error(ExitCode::input, fmt::format("scene not found: {}", obj.string()), obj.string(),
                    "there is no such file", "check the path");
    }
    if (cache_folder().empty()) {
        throw Error(ExitCode::environment, "no folder for the bake of an OBJ", obj.string(),
                    "neither XDG_CACHE_HOME nor HOME is set",
                    "set one, or bake by hand: assetconv bake SCENE.obj -o SCENE.atrium");
    }
    static_cast<void>(bake_cache_limit()); // report a bad value before minutes of baking
    if (cached_.is_current(inputs_)) {
        cached_.mark_used();
        for (const std::string& note : inputs_.notes) log_warning(note);
        return;
    }

    const std::filesystem::path converter = this_program().parent_path() / "assetconv";
    if (!std::filesystem::exists(converter)) {
        throw Error(ExitCode::environment, "assetconv is missing", converter.string(),
                    "it bakes OBJ files and stands beside atrium", "build or install both programs together");
    }
    const std::filesystem::path folder = cached_.bake.parent_path();
    std::filesystem::create_directories(folder, error);
    if (error) {
        throw Error(ExitCode::environment, "no folder for the bake of an OBJ", folder.string(), error.message(),
                    "set XDG_CACHE_HOME to a folder that can be written");
    }
    log_info(fmt::format("baking {} to {}", obj.string(), cached_.bake.string()));
    // The path with its links unresolved: files next to a link belong to the scene too.
    std::vector<std::string> command{converter.string(),
                                     "bake",
                                     std::filesystem::absolute(obj).string(),
                                     "-o",
                                     cached_.bake.string(),
                                     "--dependencies",
                                     cached_.record.string(),
                                     "--scale",
                                     fmt::format("{}", scale),
                                     "--up",
                                     up};
    if (output == Output::kept)
        scratch_.emplace();
    else if (log_level() != LogLevel::normal)
        command.emplace_back(log_level() == LogLevel::quiet ? "--quiet" : "--verbose");
    child_.emplace(command, scratch_ ? said_file() : std::filesystem::path());
}

bool ObjBake::done()
{
    if (!child_) return true;
    const std::optional<int> code = child_->ended();
    if (code) finish(*code);
    return code.has_value();
}

void ObjBake::wait()
{
    if (child_) finish(child_->wait());
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

void ObjBake::finish(int code)
{
    check(code);
    if (finished_) return;
    finished_ = true;
    inputs_ = InputRecord::from_json(read_text(cached_.record), cached_.record.string());
    if (scratch_) { // otherwise assetconv has printed them itself
        for (const std::string& note : inputs_.notes) log_warning(note);
    }
    trim_bakes(cached_.bake.parent_path(), bake_cache_limit(), cached_);
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
