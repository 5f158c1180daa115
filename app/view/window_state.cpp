#include "app/view/window_state.hpp"

#include "app/toml_text.hpp"
#include "renderer/core/atomic_file.hpp"
#include "renderer/core/error.hpp"
#include "renderer/core/log.hpp"
#include "renderer/scene/toml_reader.hpp"

#include <fmt/format.h>

#include <cstdlib>

namespace atrium::app {
namespace {

constexpr Range screen_range{-32768, 32767};

int whole(const TomlReader& reader, const char* key, int otherwise)
{
    return static_cast<int>(reader.number(key, screen_range).value_or(static_cast<float>(otherwise)));
}

Camera read_camera(const TomlReader& reader)
{
    Camera camera;
    camera.eye = reader.vector("eye", world_range).value_or(camera.eye);
    camera.target = reader.vector("target", world_range).value_or(camera.target);
    camera.fov = reader.number("fov", {1, 170}).value_or(camera.fov);
    check_camera(camera, ExitCode::input, reader.where());
    return camera;
}

WindowState parse_state(const std::filesystem::path& file)
{
    const toml::table table = parse_toml(file);
    const TomlReader reader(file, table, "the window's state",
                            {"x", "y", "width", "height", "maximised", "scene", "eye", "target", "fov", "settings_file",
                             "bookmark", "recent"});
    WindowState s;
    s.place.position = {whole(reader, "x", -1), whole(reader, "y", -1)};
    s.place.size = {whole(reader, "width", s.place.size.x), whole(reader, "height", s.place.size.y)};
    s.place.maximised = reader.on_off("maximised").value_or(false);
    s.scene = reader.text("scene").value_or("");
    s.camera = read_camera(reader);
    s.settings_file = reader.text("settings_file").value_or(s.settings_file);
    for (const toml::table* bookmark : reader.tables("bookmark")) {
        const TomlReader in(file, *bookmark, "a bookmark", {"scene", "name", "eye", "target", "fov"});
        s.bookmarks[in.required_text("scene")].emplace_back(in.required_text("name"), read_camera(in));
    }
    for (const toml::table* recent : reader.tables("recent"))
        s.recent.emplace_back(TomlReader(file, *recent, "a recent scene", {"scene"}).required_text("scene"));
    return s;
}

/// Whether a TOML file can hold the text. Names of files may be no UTF-8, and what is told of those is left out.
bool can_be_kept(const std::string& text)
{
    try {
        static_cast<void>(parse_toml_text("text = " + toml_string(text), {}));
        return true;
    } catch (const Error&) {
        return false;
    }
}

/// Renames a damaged file, so that it is not written over when the window closes. Returns what the user can do then.
std::string put_aside(const std::filesystem::path& file)
{
    std::filesystem::path aside = file;
    aside += ".damaged";
    std::error_code error;
    std::filesystem::rename(file, aside, error);
    if (error) return fmt::format("copy it before the window closes: it is written anew then ({})", error.message());
    return fmt::format("it is kept as {}: mend it, and rename it back while no window is open", aside.string());
}

} // namespace

std::filesystem::path user_file(const std::string& name)
{
    const std::filesystem::path file = std::filesystem::path("atrium") / name;
    if (const char* xdg = std::getenv("XDG_CONFIG_HOME"); xdg && *xdg) return xdg / file;
    if (const char* home = std::getenv("HOME"); home && *home) return std::filesystem::path(home) / ".config" / file;
    return {};
}

WindowState read_window_state(const std::filesystem::path& file)
{
    if (file.empty() || !std::filesystem::exists(file)) return {};
    try {
        return parse_state(file);
    } catch (const Error& error) {
        throw Error(error.code(), error.what(), error.where(), error.why(), put_aside(file));
    }
}

void write_window_state(const std::filesystem::path& file, const WindowState& s)
{
    if (file.empty()) return;
    std::string text =
        fmt::format("x = {}\ny = {}\nwidth = {}\nheight = {}\nmaximised = {}\nsettings_file = {}\nscene = {}\n{}",
                    s.place.position.x, s.place.position.y, s.place.size.x, s.place.size.y, s.place.maximised,
                    toml_string(can_be_kept(s.settings_file) ? s.settings_file : WindowState{}.settings_file),
                    toml_string(can_be_kept(s.scene.string()) ? s.scene.string() : ""), toml_camera(s.camera));
    for (const auto& [scene, bookmarks] : s.bookmarks) {
        if (!can_be_kept(scene)) continue;
        for (const auto& [name, camera] : bookmarks) {
            text += fmt::format("\n[[bookmark]]\nscene = {}\nname = {}\n{}", toml_string(scene), toml_string(name),
                                toml_camera(camera));
        }
    }
    for (const std::filesystem::path& scene : s.recent)
        if (can_be_kept(scene.string())) text += fmt::format("\n[[recent]]\nscene = {}\n", toml_string(scene.string()));
    try {
        std::error_code ignored; // writing tells
        std::filesystem::create_directories(file.parent_path(), ignored);
        write_text_file(file, text);
    } catch (const Error& error) {
        log_info(error.text());
    }
}

} // namespace atrium::app
