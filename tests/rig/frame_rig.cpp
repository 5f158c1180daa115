#include "tests/rig/frame_rig.hpp"

#include "app/child_process.hpp"
#include "renderer/core/error.hpp"
#include "tests/rig/device_rig.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <stdexcept>

namespace atrium::rig {
namespace {

std::unique_ptr<Engine> g_engine;      // NOLINT: one for the program
std::filesystem::path g_folder;        // NOLINT
std::size_t g_validation_messages = 0; // NOLINT: of engines already gone

class Ending : public testing::Environment {
    void TearDown() override
    {
        reset_engine();
        EXPECT_EQ(g_validation_messages, 0u) << "the validation layer complained; see above";
        std::error_code ignored;
        if (!g_folder.empty()) std::filesystem::remove_all(g_folder, ignored);
    }
};
testing::Environment* const g_ending = testing::AddGlobalTestEnvironment(new Ending); // NOLINT

void run(const std::vector<std::string>& command)
{
    if (const int code = app::ChildProcess(command).wait(); code != 0)
        throw std::runtime_error(command[0] + " " + command[1] + " failed");
}

std::string converter()
{
    return (app::this_program().parent_path() / "assetconv").string();
}

} // namespace

Engine& engine()
{
    if (!g_engine) {
        EngineOptions options;
        options.validate = true;
        options.shaders = find_shader;
        g_engine = std::make_unique<Engine>(options);
    }
    return *g_engine;
}

void reset_engine()
{
    if (g_engine) g_validation_messages += g_engine->validation_messages();
    g_engine.reset();
}

std::filesystem::path temporary_folder()
{
    if (g_folder.empty()) {
        std::string name = (std::filesystem::temp_directory_path() / "atrium-frames-XXXXXX").string();
        if (!mkdtemp(name.data())) throw std::runtime_error("no temporary folder");
        g_folder = name;
    }
    return g_folder;
}

const std::filesystem::path& courtyard_bake()
{
    static const std::filesystem::path bake = [] {
        const std::filesystem::path folder = temporary_folder() / "courtyard", file = folder / "courtyard.atrium";
        run({converter(), "courtyard", folder.string(), "--detail", "low", "--quiet"});
        run({converter(), "bake", (folder / "courtyard.obj").string(), "-o", file.string(), "--quiet"});
        return file;
    }();
    return bake;
}

std::filesystem::path bake_of(const std::filesystem::path& obj)
{
    std::filesystem::path file = temporary_folder() / (obj.stem().string() + ".atrium");
    run({converter(), "bake", obj.string(), "-o", file.string(), "--quiet"});
    return file;
}

std::optional<std::filesystem::path> real_scenes()
{
    const char* folder = std::getenv("ATRIUM_SCENES");
    if (!folder || !*folder) return std::nullopt;
    return std::filesystem::path(folder);
}

std::optional<std::filesystem::path> sponza_bake()
{
    if (!real_scenes()) return std::nullopt;
    static const std::filesystem::path bake = [] {
        const std::filesystem::path file = temporary_folder() / "sponza.atrium";
        run({converter(), "bake", (*real_scenes() / "sponza" / "sponza_nobanner.obj").string(), "-o", file.string(),
             "--scale", "0.01", "--quiet"});
        return file;
    }();
    return bake;
}

FrameRig::FrameRig(const BakeData& scene)
{
    static int count = 0;
    folder_ = temporary_folder() / ("scene" + std::to_string(count++));
    std::filesystem::create_directories(folder_);
    write_bake(folder_ / "scene.atrium", scene);
    bake_ = std::make_unique<BakeFile>(folder_ / "scene.atrium");
    begin();
}

FrameRig::FrameRig(const std::filesystem::path& bake) : bake_(std::make_unique<BakeFile>(bake))
{
    begin();
}

FrameRig::~FrameRig()
{
    if (folder_.empty()) return;
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
}

void FrameRig::begin()
{
    SceneDescription scene;
    scene.bakes.push_back(bake_.get());
    scene.instances.push_back({0, std::nullopt, mat4(1)});
    engine().load(scene);
    request.size = {320, 180};
    SettingList list;
    describe(list, request.settings);
    if (engine().device().report().is_cpu) list.apply_cpu_defaults();
    request.settings.texture.anisotropy = 1;
    request.settings.ao.method = AoMethod::off; // tests of ambient occlusion turn it on
    request.settings.ao.half_resolution = false;
    request.settings.tonemap.tone_operator = ToneOperator::linear;
    request.want_picture = false;
}

FrameResult FrameRig::render() const
{
    return engine().render(request);
}

std::vector<ImageF> FrameRig::aovs(const std::vector<std::string>& names) const
{
    FrameRequest with = request;
    for (const std::string& name : names) with.aovs.push_back(parse_aov(name, with.lights));
    return engine().render(with).aovs;
}

ImageF FrameRig::aov(const std::string& name) const
{
    return std::move(aovs({name}).front());
}

void FrameRig::set(const std::string& key, const std::string& value)
{
    Settings settings;
    SettingList list;
    describe(list, settings);
    settings = request.settings;
    list.set(key, value, ExitCode::internal, "test");
    request.settings = settings;
}

void FrameRig::look(const vec3& eye, const vec3& target, float fov)
{
    request.camera = {eye, target, fov};
    request.previous_camera = request.camera;
}

void FrameRig::light(const std::string& spec)
{
    request.lights.push_back(parse_light(spec));
    name_lights(request.lights);
}

} // namespace atrium::rig
