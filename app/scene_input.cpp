#include "app/scene_input.hpp"

#include "app/bake_cache.hpp"
#include "app/config.hpp"
#include "app/obj_bake.hpp"
#include "app/presets.hpp"
#include "renderer/core/error.hpp"
#include "renderer/core/log.hpp"
#include "renderer/core/nearest_name.hpp"

#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cctype>

namespace atrium::app {
namespace {

std::string lower_extension(const std::filesystem::path& path)
{
    std::string extension = path.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return std::tolower(c); });
    return extension;
}

mat4 world_from_object(const InstanceEntry& entry)
{
    mat4 m = glm::translate(mat4(1), entry.position);
    m = glm::rotate(m, glm::radians(entry.rotation.z), vec3(0, 0, 1));
    m = glm::rotate(m, glm::radians(entry.rotation.y), vec3(0, 1, 0));
    m = glm::rotate(m, glm::radians(entry.rotation.x), vec3(1, 0, 0));
    return glm::scale(m, vec3(entry.scale));
}

std::uint32_t find_mesh(const BakeFile& bake, const std::string& name)
{
    std::vector<std::string> names;
    for (const Mesh& mesh : bake.scene().meshes) {
        if (mesh.name == name) return static_cast<std::uint32_t>(names.size());
        names.push_back(mesh.name);
    }
    throw Error(ExitCode::input, fmt::format("no mesh is called \"{}\"", name), bake.path().string(),
                suggest_name(name, names), "`assetconv info` lists the meshes");
}

/// Index of the bake at `path`, opened when it is the first time.
std::size_t open_bake(SceneInput& in, const std::filesystem::path& path)
{
    for (std::size_t i = 0; i < in.bakes.size(); ++i) {
        if (in.bakes[i]->path() == path) return i;
    }
    in.bakes.push_back(std::make_unique<BakeFile>(path));
    return in.bakes.size() - 1;
}

} // namespace

bool is_obj(const std::filesystem::path& scene)
{
    return lower_extension(scene) == ".obj";
}

SceneDescription SceneInput::description() const
{
    SceneDescription out;
    for (const auto& bake : bakes) out.bakes.push_back(bake.get());
    out.instances = instances;
    out.overrides = file.materials;
    return out;
}

SceneInput read_scene_input(const SceneOptions& o, const FrameOptions& frame)
{
    SceneInput in;
    in.files.push_back(o.scene);
    if (!frame.config.empty()) {
        in.config = read_config(frame.config);
        in.files.push_back(frame.config);
    }
    if (lower_extension(o.scene) == ".toml") {
        in.file = read_scene_file(o.scene);
    } else if (is_obj(o.scene)) {
        ObjBake bake(o.scene, o.bake_scale, o.bake_up, ObjBake::Output::shown);
        bake.wait();
        in.file.bake = bake.bake();
        for (std::filesystem::path& file : bake.inputs()) in.files.push_back(std::move(file));
    } else {
        in.file.bake = o.scene;
    }
    open_bake(in, in.file.bake);
    in.instances.push_back({0, std::nullopt, mat4(1)});
    for (const InstanceEntry& entry : in.file.instances) {
        Instance instance;
        instance.bake = open_bake(in, entry.bake);
        if (!entry.mesh.empty()) instance.mesh = find_mesh(*in.bakes[instance.bake], entry.mesh);
        instance.world_from_object = world_from_object(entry);
        in.instances.push_back(instance);
    }
    for (const auto& bake : in.bakes) in.files.push_back(bake->path());
    find_camera(in, frame);
    return in;
}

SettingChain::SettingChain(const FrameOptions& o, const SceneInput& scene)
    : default_view_(scene.found && !scene.found->inside && o.lights.empty() && !o.no_lights &&
                    scene.file.lights.empty() && !scene.config.lights)
{
    if (!o.preset.empty()) {
        for (SettingText& text : preset_settings(o.preset)) entries_.push_back({std::move(text), ExitCode::internal});
    }
    for (const SettingText& text : scene.file.settings) entries_.push_back({text, ExitCode::input});
    for (const SettingText& text : scene.config.settings) entries_.push_back({text, ExitCode::input});
    for (const std::string& pair : o.set) {
        const std::size_t equals = pair.find('=');
        if (equals == std::string::npos) {
            throw Error(ExitCode::usage, fmt::format("--set takes key=value, not \"{}\"", pair), "--set",
                        "there is no \"=\" in it", "for example --set exposure.ev100=1");
        }
        entries_.push_back({{pair.substr(0, equals), pair.substr(equals + 1), "--set " + pair}, ExitCode::usage});
    }
}

Settings SettingChain::apply(bool cpu_device) const
{
    Settings settings;
    SettingList list;
    describe(list, settings);
    if (cpu_device) list.apply_cpu_defaults();
    for (const Entry& e : entries_) list.set(e.text.key, e.text.value, e.code, e.text.where);
    if (settings.sky.floor == SkyFloor::automatic && default_view_) settings.sky.floor = SkyFloor::on;
    return settings;
}

std::vector<Light> collect_lights(const FrameOptions& o, const SceneInput& scene)
{
    std::vector<Light> lights;
    if (!o.no_lights) lights = scene.config.lights.value_or(scene.file.lights);
    // A picture drawn without lights is drawn again without the default sun.
    const bool none_on_purpose = o.no_lights || scene.config.lights.has_value();
    const bool from_file = !lights.empty();
    for (const std::string& spec : o.lights) lights.push_back(parse_light(spec));
    if (lights.empty() && !none_on_purpose) lights.push_back(parse_light("sun"));
    name_lights(lights, from_file && o.lights.empty() ? ExitCode::input : ExitCode::usage);
    return lights;
}

Camera choose_camera(const FrameOptions& o, const SceneInput& scene)
{
    Camera camera;
    bool drawn_before = false; // a path's camera may have its eye at its target; it is drawn again as it was
    const auto& cameras = scene.file.cameras;
    if (o.eye) {
        camera.eye = *o.eye;
        camera.target = *o.target;
    } else if (!o.camera.empty()) {
        const auto found =
            std::find_if(cameras.begin(), cameras.end(), [&](const auto& c) { return c.first == o.camera; });
        if (found == cameras.end()) {
            std::vector<std::string> names;
            for (const auto& [name, unused] : cameras) names.push_back(name);
            throw Error(ExitCode::usage, fmt::format("no camera is called \"{}\"", o.camera), "--camera",
                        names.empty() ? "the scene names no cameras" : suggest_name(o.camera, names),
                        "name cameras in a scene file ([camera.NAME]), or use --eye and --target");
        }
        camera = found->second;
    } else if (scene.config.camera) {
        camera = *scene.config.camera;
        drawn_before = true;
    } else if (!cameras.empty()) {
        camera = cameras.front().second;
    } else {
        camera = scene.found.value().camera;
    }
    if (o.fov) camera.fov = *o.fov;
    if (camera.eye == camera.target && !drawn_before) {
        throw Error(ExitCode::usage, "the camera looks at the point it stands in", "--eye, --target",
                    "there is no direction between them", "move one of them");
    }
    return camera;
}

uvec2 picture_size(const FrameOptions& o, const SceneInput& scene)
{
    return o.size.value_or(scene.config.size.value_or(uvec2(1280, 720)));
}

void tell_camera(const SceneInput& scene, const FrameOptions& o)
{
    if (scene.found && scene.found->inside && o.from == CameraFrom::anywhere)
        log_info("the camera was placed inside the scene, which is a room; --from outside places it outside");
}

FrameRequest make_request(const FrameOptions& o, const SceneInput& scene, const SettingChain& chain)
{
    FrameRequest request;
    request.settings = chain.apply(false);
    request.size = picture_size(o, scene);
    request.lights = collect_lights(o, scene);
    request.materials = scene.config.materials;
    if (!request.settings.debug.view.empty()) static_cast<void>(parse_aov(request.settings.debug.view, request.lights));
    request.camera = request.previous_camera = choose_camera(o, scene);
    return request;
}

EngineOptions engine_options(const SceneOptions& o)
{
    EngineOptions out;
    out.device = o.device;
    out.validate = o.validate;
    out.cache_folder = cache_folder();
    return out;
}

int verdict(const Engine& engine)
{
    const std::size_t messages = engine.validation_messages();
    if (messages == 0) return 0;
    throw Error(ExitCode::internal, fmt::format("validation reported {} message(s)", messages), "--validate",
                "they are printed above", "please report them with the command line");
}

} // namespace atrium::app
