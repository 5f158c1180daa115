#include "renderer/scene/scene_file.hpp"

#include "renderer/core/nearest_name.hpp"
#include "renderer/core/text_value.hpp"
#include "renderer/scene/light_reader.hpp"
#include "renderer/scene/toml_reader.hpp"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

namespace atrium {
namespace {

namespace fs = std::filesystem;

constexpr Range share{0.0f, 1.0f}, amount{0.0f, 1e9f}, any_angle{-3600.0f, 3600.0f}, scales{1e-6f, 1e6f};
constexpr Range any_number{std::numeric_limits<float>::lowest(), std::numeric_limits<float>::max()};

fs::path beside(const fs::path& file, const std::string& name)
{
    return (file.parent_path() / name).lexically_normal();
}

// ---- settings

/// A number or word as --set takes it; the settings themselves judge it.
std::optional<std::string> as_set_text(const toml::node& node)
{
    if (auto text = node.value_exact<std::string>()) return text;
    if (const auto value = node.value_exact<bool>()) return to_text(*value);
    if (const auto value = node.value_exact<std::int64_t>()) return fmt::format("{}", *value);
    if (const auto value = node.value_exact<double>()) return fmt::format("{}", *value);
    const toml::array* array = node.as_array();
    if (array == nullptr || array->size() != 3) return std::nullopt;
    std::string text;
    for (const toml::node& component : *array) {
        if (!component.is_number()) return std::nullopt;
        text += fmt::format("{}{}", text.empty() ? "" : ":", *as_set_text(component));
    }
    return text;
}

std::vector<SettingText> read_settings(const fs::path& file, const toml::table& table)
{
    std::vector<SettingText> out;
    for (const TomlEntry& entry : dotted_entries(table)) {
        const std::string where = where_in(file, entry.source);
        auto text = as_set_text(*entry.node);
        if (!text) {
            throw Error(ExitCode::input, fmt::format("bad value of the setting \"{}\"", entry.key), where,
                        fmt::format("expected a string, a number, a boolean or an array of three numbers, found {}",
                                    kind_of(*entry.node)),
                        "\"atrium settings\" lists all settings and their values");
        }
        out.push_back({entry.key, std::move(*text), where});
    }
    return out;
}

// ---- the other tables

Camera read_camera(const TomlReader& in)
{
    Camera camera;
    camera.eye = in.required_vector("eye", world_range);
    camera.target = in.required_vector("target", world_range);
    camera.fov = in.number("fov", any_number).value_or(60.0f);
    check_camera(camera, ExitCode::input, in.where(camera.eye == camera.target ? "target" : "fov"));
    return camera;
}

/// The camera in a picture's metadata: accepted as it was drawn, also where a scene file's camera would be refused.
Camera read_drawn_camera(const TomlReader& in)
{
    constexpr Range any_fov{1.0f, 170.0f};
    return {in.required_vector("eye", any_number), in.required_vector("target", any_number),
            in.number("fov", any_fov).value_or(60.0f)};
}

std::vector<std::string> keys_of(LightType type)
{
    Light light = default_light(type);
    SettingList list;
    describe(list, light);
    std::vector<std::string> keys{"type"};
    for (const Setting& setting : list.all()) keys.push_back(setting.key);
    return keys;
}

/// The keys that the light in `table` may have; without a usable type, those of all types.
std::vector<std::string> light_keys(const toml::table& table)
{
    constexpr std::array types{LightType::sun, LightType::spot, LightType::point, LightType::rect};
    std::vector<std::string> all;
    for (const LightType type : types) {
        std::vector<std::string> keys = keys_of(type);
        if (table["type"].value_or(std::string_view()) == to_string(type)) return keys;
        for (std::string& key : keys) {
            if (std::find(all.begin(), all.end(), key) == all.end()) all.push_back(std::move(key));
        }
    }
    return all;
}

/// The value as a SPEC's text, of the TOML type that the key wants.
std::string spec_text(const TomlReader& in, const Setting& setting)
{
    if (std::holds_alternative<bool*>(setting.field)) return to_text(*in.on_off(setting.key));
    if (std::holds_alternative<float*>(setting.field)) return to_text(*in.number(setting.key, any_number));
    if (std::holds_alternative<vec3*>(setting.field)) return to_text(*in.vector(setting.key, any_number));
    return *in.text(setting.key);
}

Light read_light(const fs::path& file, const toml::table& table)
{
    const TomlReader in(file, table, "a light", light_keys(table));
    const std::string type = in.required_text("type");
    LightReader light(type, ExitCode::input, in.where("type"));
    for (const TomlEntry& entry : in_file_order(table)) {
        if (entry.key == "type") continue;
        light.set(entry.key, spec_text(in, *light.keys().find(entry.key)), in.where(entry.key));
    }
    return light.finish();
}

InstanceEntry read_instance(const fs::path& file, const toml::table& table, const fs::path& scene_bake)
{
    const TomlReader in(file, table, "an instance", {"bake", "mesh", "position", "rotation", "scale"});
    InstanceEntry instance;
    const auto bake = in.text("bake");
    instance.bake = bake ? beside(file, *bake) : scene_bake;
    instance.mesh = in.text("mesh").value_or("");
    instance.position = in.vector("position", world_range).value_or(vec3(0));
    instance.rotation = in.vector("rotation", any_angle).value_or(vec3(0));
    instance.scale = in.number("scale", scales).value_or(1.0f);
    return instance;
}

MaterialOverride read_material(const fs::path& file, const toml::table& table)
{
    Material material;
    SettingList keys("material key", "");
    describe(keys, material);
    std::vector<std::string> names{"match"};
    for (const Setting& key : keys.all()) names.push_back(key.key);
    const TomlReader in(file, table, "a material override", names);
    MaterialOverride o;
    o.match = in.required_text("match");
    for (const TomlEntry& entry : in_file_order(table)) {
        if (entry.key == "match") continue;
        const auto text = as_set_text(*entry.node);
        if (!text)
            in.fail(entry.key, fmt::format("expected a value, found {}", kind_of(*entry.node)), "give one value");
        keys.set(entry.key, *text, ExitCode::input, in.where(entry.key));
        o.values.emplace_back(entry.key, keys.find(entry.key)->get());
    }
    return o;
}

std::vector<MaterialOverride> read_materials(const TomlReader& root)
{
    std::vector<MaterialOverride> materials;
    for (const toml::table* material : root.tables("material"))
        materials.push_back(read_material(root.file(), *material));
    return materials;
}

CameraPath read_path(const fs::path& file, const toml::table& table, const std::string& name)
{
    const TomlReader in(file, table, fmt::format("path \"{}\"", name), {"keys"});
    CameraPath keys;
    for (const toml::table* key_table : in.tables("keys")) {
        const TomlReader key(file, *key_table, fmt::format("a key of path \"{}\"", name), {"time", "eye", "target"});
        keys.push_back({key.required_number("time", any_number), key.required_vector("eye", world_range),
                        key.required_vector("target", world_range)});
        check_camera({keys.back().eye, keys.back().target, 60.0f}, ExitCode::input, key.where("target"));
        if (keys.size() > 1 && !(keys[keys.size() - 2].time < keys.back().time)) {
            key.fail("time", "it is not later than that of the key before", "order the keys by time");
        }
    }
    if (keys.empty()) {
        throw Error(ExitCode::input, fmt::format("path \"{}\" has no keys", name), in.where("keys"),
                    "a path needs at least one", "add keys = [{ time = 0.0, eye = […], target = […] }]");
    }
    return keys;
}

/// A table whose keys are names that the user chose: [camera.NAME], [path.NAME].
template <class F>
void for_each_named(const TomlReader& root, const char* key, F&& read)
{
    const toml::table* table = root.subtable(key);
    if (table == nullptr) return;
    for (const TomlEntry& entry : in_file_order(*table)) {
        const toml::table* inner = entry.node->as_table();
        if (inner == nullptr) {
            throw Error(ExitCode::input, fmt::format("bad value of \"{}\" in \"{}\"", entry.key, key),
                        where_in(root.file(), entry.source),
                        fmt::format("expected a table, found {}", kind_of(*entry.node)),
                        fmt::format("write [{}.NAME] and its keys below", key));
        }
        read(entry.key, *inner);
    }
}

/// All of a settings file but its materials: keys stand alone or below [settings].
std::vector<SettingText> settings_of(toml::table table, const fs::path& file)
{
    table.erase("material");
    std::vector<SettingText> settings = read_settings(file, table);
    for (SettingText& setting : settings) {
        constexpr std::string_view prefix = "settings.";
        if (setting.key.starts_with(prefix)) setting.key.erase(0, prefix.size());
    }
    return settings;
}

} // namespace

SceneFile read_scene_file(const fs::path& file)
{
    const toml::table table = parse_toml(file);
    const TomlReader root(file, table, "the scene file",
                          {"bake", "settings", "camera", "light", "instance", "material", "path"});
    SceneFile scene;
    scene.path = file;
    if (const std::string bake = root.required_text("bake"); !bake.empty()) {
        scene.bake = beside(file, bake);
    } else {
        root.fail("bake", "it is empty", "name the baked scene, relative to this file");
    }
    if (const toml::table* settings = root.subtable("settings")) scene.settings = read_settings(file, *settings);
    for_each_named(root, "camera", [&](const std::string& name, const toml::table& camera) {
        const TomlReader in(file, camera, fmt::format("camera \"{}\"", name), {"eye", "target", "fov"});
        scene.cameras.emplace_back(name, read_camera(in));
    });
    for (const toml::table* light : root.tables("light")) {
        scene.lights.push_back(read_light(file, *light));
    }
    for (const toml::table* instance : root.tables("instance")) {
        scene.instances.push_back(read_instance(file, *instance, scene.bake));
    }
    scene.materials = read_materials(root);
    for_each_named(root, "path", [&](const std::string& name, const toml::table& path) {
        scene.paths[name] = read_path(file, path, name);
    });
    return scene;
}

FrameConfig parse_frame_config(std::string_view text, const fs::path& file)
{
    const toml::table table = parse_toml_text(text, file);
    const TomlReader root(file, table, "the description of a frame",
                          {"width", "height", "time", "lights", "camera", "settings", "material"});
    FrameConfig config;
    if (const toml::table* settings = root.subtable("settings")) config.settings = read_settings(file, *settings);
    if (const toml::table* camera = root.subtable("camera")) {
        config.camera = read_drawn_camera(TomlReader(file, *camera, "the camera", {"eye", "target", "fov"}));
    }
    const Range pixels{1, 16384};
    const auto width = root.number("width", pixels), height = root.number("height", pixels);
    if (width && height) config.size = uvec2(*width, *height);
    config.time = root.real("time");
    if (const toml::array* lights = table["lights"].as_array()) {
        config.lights.emplace();
        for (const toml::node& light : *lights)
            config.lights->push_back(parse_light(light.value_or(std::string_view())));
    }
    config.materials = read_materials(root);
    return config;
}

FrameConfig read_settings_file(const fs::path& file)
{
    const toml::table table = parse_toml(file);
    std::vector<std::string> keys; // settings judge theirs later
    for (const TomlEntry& entry : in_file_order(table)) keys.push_back(entry.key);
    FrameConfig config;
    config.settings = settings_of(table, file);
    config.materials = read_materials(TomlReader(file, table, "the file of settings", keys));
    return config;
}

std::vector<SettingText> parse_settings(std::string_view text, const fs::path& file)
{
    return settings_of(parse_toml_text(text, file), file);
}

} // namespace atrium
