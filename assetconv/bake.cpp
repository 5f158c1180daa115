#include "assetconv/bake.hpp"

#include "assetconv/bake_meshes.hpp"
#include "renderer/core/log.hpp"

#include <fmt/format.h>

#include <chrono>

namespace atrium {
namespace {

/// Tells how long each step took, with --verbose.
class Steps {
public:
    void done(const char* step)
    {
        const auto now = std::chrono::steady_clock::now();
        log_verbose(fmt::format("{}: {:.2f} s", step, std::chrono::duration<double>(now - last_).count()));
        last_ = now;
    }

private:
    std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

/// Names come from outside and may be longer than a bake allows.
void shorten(std::string& text)
{
    constexpr std::size_t longest = 1000;
    if (text.size() > longest) text.resize(longest);
}

void shorten_names(Scene& scene)
{
    for (Material& m : scene.materials) shorten(m.name);
    for (Texture& t : scene.textures) shorten(t.file);
    for (Mesh& m : scene.meshes) shorten(m.name);
    for (BakeWarning& w : scene.warnings) shorten(w.first);
    shorten(scene.source);
}

} // namespace

BakeData bake_scene(const BakeOptions& options, InputRecord* inputs)
{
    InputRecord none(false);
    InputRecord& record = inputs != nullptr ? *inputs : none;
    Warnings warnings(options.strict);
    BakeData out;
    Steps steps;

    record.add_file(options.input);
    const ObjFile obj = read_obj(options.input, warnings);
    steps.done("OBJ");
    const MaterialSet set = read_materials(obj, options, warnings, record);
    steps.done("materials and images");
    bake_meshes(obj, set, options, out, warnings);
    steps.done("meshes");
    bake_textures(set, options, out);
    steps.done("textures");

    out.scene.source = options.input.filename().string();
    out.scene.warnings = warnings.list();
    shorten_names(out.scene);
    return out;
}

void parse_scene(const BakeOptions& options)
{
    Warnings warnings(options.strict);
    InputRecord none(false);
    static_cast<void>(read_materials(read_obj(options.input, warnings), options, warnings, none));
}

} // namespace atrium
