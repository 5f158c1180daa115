#include "app/scene_writer.hpp"

#include "app/toml_text.hpp"
#include "renderer/core/atomic_file.hpp"
#include "renderer/core/output_guard.hpp"
#include "renderer/core/text_value.hpp"

#include <fmt/format.h>

#include <array>
#include <system_error>
#include <vector>

namespace atrium::app {
namespace {

namespace fs = std::filesystem;

std::string path_text(const fs::path& path, const fs::path& folder)
{
    std::error_code ignored; // of an empty path, whose file no one can read
    const fs::path whole = fs::absolute(path, ignored).lexically_normal();
    const fs::path relative = whole.lexically_relative(fs::absolute(folder, ignored).lexically_normal());
    const bool below = !relative.empty() && *relative.begin() != "..";
    return toml_string((below ? relative : whole).generic_string());
}

/// Names of the user's own choice may hold what bare keys may not.
std::string heading(const char* table, const std::string& name)
{
    return fmt::format("\n[{}.{}]\n", table, toml_string(name));
}

std::string light_text(const Light& light)
{
    Light described = default_light(light.type);
    SettingList keys;
    describe(keys, described);
    described = light; // only now, so that the list knows the defaults
    std::string out = fmt::format("\n[[light]]\ntype = \"{}\"\n", to_string(light.type));
    for (const Setting& key : keys.all()) {
        const bool needed = key.key == "position" || key.get() != key.default_text;
        if (needed) out += fmt::format("{} = {}\n", key.key, toml_value(key));
    }
    return out;
}

std::string instance_text(const InstanceEntry& instance, const fs::path& folder)
{
    std::string out = fmt::format("\n[[instance]]\nbake = {}\n", path_text(instance.bake, folder));
    if (!instance.mesh.empty()) out += fmt::format("mesh = {}\n", toml_string(instance.mesh));
    return out + fmt::format("position = {}\nrotation = {}\nscale = {}\n", toml_vector(instance.position),
                             toml_vector(instance.rotation), instance.scale);
}

std::string path_keys_text(const CameraPath& path)
{
    std::string out = "keys = [\n";
    for (const CameraKey& key : path)
        out += fmt::format("    {{ time = {}, eye = {}, target = {} }},\n", key.time, toml_vector(key.eye),
                           toml_vector(key.target));
    return out + "]\n";
}

} // namespace

std::string scene_toml(const SceneFile& scene, const fs::path& folder)
{
    std::string out = fmt::format("bake = {}\n\n[settings]\n", path_text(scene.bake, folder));
    for (const SettingText& setting : scene.settings)
        out += fmt::format("{} = {}\n", setting.key, toml_string(setting.value));
    for (const auto& [name, camera] : scene.cameras) out += heading("camera", name) + toml_camera(camera);
    for (const Light& light : scene.lights) out += light_text(light);
    for (const InstanceEntry& instance : scene.instances) out += instance_text(instance, folder);
    out += materials_toml(scene.materials);
    for (const auto& [name, path] : scene.paths) out += heading("path", name) + path_keys_text(path);
    return out;
}

void write_scene_file(const fs::path& file, const SceneFile& scene)
{
    std::vector<fs::path> bakes{scene.bake};
    for (const InstanceEntry& instance : scene.instances) bakes.push_back(instance.bake);
    refuse_overwriting(std::array{OutputFile{"scene file", file}}, bakes);
    write_text_file(file, scene_toml(scene, file.has_parent_path() ? file.parent_path() : "."));
}

std::vector<SettingText> portable_settings(const SettingList& list)
{
    std::vector<SettingText> out;
    for (const Setting& setting : list.all()) {
        const std::string text = setting.get();
        if (text != setting.default_text || text != setting.cpu_default) out.push_back({setting.key, text, ""});
    }
    return out;
}

} // namespace atrium::app
