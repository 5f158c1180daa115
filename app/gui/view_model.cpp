#include "app/gui/view_model.hpp"

#include "app/scene_writer.hpp"
#include "app/toml_text.hpp"
#include "renderer/core/atomic_file.hpp"
#include "renderer/core/error.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace atrium::gui {
namespace {

/// None for the picture, and where there is no buffer of that name.
std::optional<Aov> find_buffer(const std::string& name, std::span<const Light> lights)
{
    if (name.empty()) return std::nullopt;
    try {
        return parse_aov(name, lights);
    } catch (const Error&) {
        return std::nullopt;
    }
}

} // namespace

ViewModel::ViewModel()
{
    describe(list, settings);
    last_ = now();
}

void ViewModel::reset(const Settings& new_settings, const Camera& new_camera, std::vector<Light> new_lights)
{
    name_lights(new_lights);
    settings = new_settings;
    camera = start_camera_ = new_camera;
    lights = std::move(new_lights);
    for (Light& light : lights) light.id = next_light_id_++;
    selected.reset();
    past_.clear();
    future_.clear();
    last_ = now();
}

ViewModel::Snapshot ViewModel::now() const
{
    return {settings, lights, materials};
}

bool ViewModel::edited() const
{
    return !same_settings(settings, last_.settings) || lights != last_.lights || materials != last_.materials;
}

void ViewModel::restore(const Snapshot& snapshot)
{
    settings = snapshot.settings;
    lights = snapshot.lights;
    materials = snapshot.materials;
    if (selected && *selected >= lights.size()) selected.reset();
    last_ = snapshot;
}

void ViewModel::checkpoint()
{
    constexpr std::size_t most_steps = 500;
    if (!edited()) return;
    past_.push_back(std::move(last_));
    if (past_.size() > most_steps) past_.pop_front();
    future_.clear();
    last_ = now();
}

bool ViewModel::can_undo() const
{
    return !past_.empty() || edited();
}

bool ViewModel::can_redo() const
{
    return !future_.empty() && !edited();
}

void ViewModel::undo()
{
    checkpoint(); // an edit that is still going on is the step to take back
    if (past_.empty()) return;
    future_.push_back(last_);
    const Snapshot target = std::move(past_.back());
    past_.pop_back();
    restore(target);
}

void ViewModel::redo()
{
    checkpoint();
    if (future_.empty()) return;
    past_.push_back(last_);
    const Snapshot target = std::move(future_.back());
    future_.pop_back();
    restore(target);
}

std::optional<std::string> ViewModel::apply_texts(std::span<const SettingText> texts)
{
    const Settings before = settings;
    try {
        for (const SettingText& t : texts) list.set(t.key, t.value, ExitCode::input, t.where);
    } catch (const Error& e) {
        settings = before;
        return e.text();
    }
    return std::nullopt;
}

void ViewModel::apply_defaults(bool is_cpu)
{
    settings = Settings{};
    if (is_cpu) list.apply_cpu_defaults();
}

std::string ViewModel::settings_toml() const
{
    return app::differing_toml(list) + app::materials_toml(materials);
}

void ViewModel::save_settings(const std::filesystem::path& file) const
{
    write_text_file(file, settings_toml());
}

std::optional<std::string> ViewModel::load_settings(const std::filesystem::path& file)
{
    const Settings before = settings;
    try {
        const FrameConfig config = read_settings_file(file);
        settings = Settings{};
        auto refused = apply_texts(config.settings);
        if (refused) {
            settings = before;
        } else {
            materials = spelled_out(scene_materials, config.materials);
        }
        return refused;
    } catch (const Error& e) {
        return e.text();
    }
}

void ViewModel::save_scene(const std::filesystem::path& file) const
{
    SceneFile scene = scene_file;
    scene.settings = app::portable_settings(list);
    scene.lights = lights;
    scene.materials.insert(scene.materials.end(), materials.begin(), materials.end());
    scene.paths = paths;
    Bookmarks cameras{{"window", camera}};
    for (const NamedCamera& c : scene_file.cameras) {
        if (c.first != "window") cameras.push_back(c);
    }
    for (auto [name, bookmark] : bookmarks) {
        while (add_bookmark(cameras, name, bookmark)) name += "_"; // the scene may have one of that name
    }
    scene.cameras = std::move(cameras);
    app::write_scene_file(file, scene);
}

// ---- lights

void ViewModel::select(std::size_t index)
{
    selected.reset();
    if (!lights.empty()) selected = std::min(index, lights.size() - 1);
}

std::string ViewModel::free_light_name() const
{
    for (std::size_t i = lights.size();; ++i) {
        std::string name = fmt::format("light{}", i);
        if (std::none_of(lights.begin(), lights.end(), [&](const Light& l) { return l.name == name; })) return name;
    }
}

bool ViewModel::add_light(LightType type, const vec3& position)
{
    if (lights.size() >= max_lights) return false;
    Light light = default_light(type);
    light.name = free_light_name();
    light.id = next_light_id_++;
    if (type != LightType::sun) light.position = position; // a sun has none, and a field it has not keeps its default
    lights.push_back(std::move(light));
    select(lights.size() - 1);
    return true;
}

bool ViewModel::duplicate_selected()
{
    if (!selected || *selected >= lights.size() || lights.size() >= max_lights) return false;
    Light copy = lights[*selected];
    copy.name = free_light_name();
    copy.id = next_light_id_++;
    lights.push_back(std::move(copy));
    select(lights.size() - 1);
    return true;
}

void ViewModel::remove_selected()
{
    if (!selected || *selected >= lights.size()) return;
    lights.erase(lights.begin() + static_cast<std::ptrdiff_t>(*selected));
    select(*selected);
    if (shown_buffer().empty()) settings.debug.view.clear(); // it was the light's
}

std::optional<std::string> ViewModel::set_light(std::size_t index, Light light)
{
    if (light.name.empty()) light.name = free_light_name();
    try {
        check_light(light, ExitCode::usage, light.name);
    } catch (const Error& e) {
        return fmt::format("{}: {}", e.what(), e.why());
    }
    for (std::size_t i = 0; i < lights.size(); ++i) {
        if (i != index && lights[i].name == light.name) return fmt::format("another light is called {}", light.name);
    }
    if (light.name != lights.at(index).name) rename_buffers(index, light.name);
    light.id = lights[index].id;
    lights[index] = std::move(light);
    return std::nullopt;
}

std::vector<std::string> ViewModel::offered_buffers() const
{
    std::vector<std::string> names = aov_names(lights);
    std::erase_if(names, [&](const std::string& name) {
        const Aov aov = parse_aov(name, lights);
        if (aov.info->source == AovSource::ao) return settings.ao.method == AoMethod::off;
        if (aov.info->source != AovSource::shadow) return false;
        return settings.shadow.filter == ShadowFilter::off || !lights[aov.light].shadow;
    });
    names.insert(names.end(), graph_images.begin(), graph_images.end());
    return names;
}

std::string ViewModel::shown_buffer() const
{
    const auto aov = find_buffer(settings.debug.view, lights);
    return aov ? aov_name(*aov, lights) : "";
}

void ViewModel::rename_buffers(std::size_t light, const std::string& name)
{
    const auto rename = [&](std::string& buffer) {
        const auto aov = find_buffer(buffer, lights);
        if (aov && aov->info->per_light && aov->light == light) buffer = fmt::format("{}.{}", aov->info->name, name);
    };
    rename(settings.debug.view);
    for (PinnedBuffer& p : pinned) rename(p.name);
}

void ViewModel::step_buffer(int step)
{
    std::vector<std::string> names = offered_buffers();
    names.insert(names.begin(), ""); // the picture
    const auto count = static_cast<int>(names.size());
    const std::string shown = shown_buffer();
    const auto at = static_cast<int>(std::find(names.begin(), names.end(), shown) - names.begin());
    const bool lost = at == count || (shown.empty() && !settings.debug.view.empty());
    const int next = lost ? 0 : (at + step + count) % count; // to the picture
    settings.debug.view = names[static_cast<std::size_t>(next)];
}

void ViewModel::toggle_pin(const std::string& name)
{
    if (std::erase_if(pinned, [&](const PinnedBuffer& p) { return p.name == name; }) > 0) return;
    if (pinned.size() < max_insets) pinned.push_back({name, {}});
}

void ViewModel::drop_lost_buffers()
{
    std::erase_if(pinned, [&](const PinnedBuffer& p) { return !find_buffer(p.name, lights); });
}

// ---- materials

Material ViewModel::material(std::size_t index) const
{
    return overridden(scene_materials.at(index), materials);
}

void ViewModel::set_material(std::size_t index, const Material& wanted)
{
    MaterialOverride change = difference(scene_materials.at(index), wanted);
    const auto present = std::find_if(materials.begin(), materials.end(),
                                      [&](const MaterialOverride& o) { return o.match == change.match; });
    if (change.values.empty()) {
        if (present != materials.end()) materials.erase(present);
    } else if (present != materials.end()) {
        *present = std::move(change);
    } else {
        materials.push_back(std::move(change));
    }
}

} // namespace atrium::gui
