#include "app/view/scene_facts.hpp"

namespace atrium::app {
namespace {

std::vector<gui::TextureFacts> textures_of(const Material& material, const Scene& scene)
{
    std::vector<gui::TextureFacts> out;
    const auto add = [&](const char* use, std::int32_t texture) {
        if (texture == no_texture) return;
        const Texture& t = scene.textures[static_cast<std::size_t>(texture)];
        out.push_back({use, t.file, to_string(t.format), {t.width, t.height}, t.size});
    };
    add("base color", material.base_color_texture);
    add("normal", material.normal_texture);
    add("surface", material.surface_texture);
    add("emission", material.emission_texture);
    return out;
}

void count(const Mesh& mesh, std::size_t first_material, gui::SceneFacts& out)
{
    const std::uint64_t triangles = mesh.index_count / 3;
    gui::MaterialFacts& material = out.materials[first_material + mesh.material];
    ++material.meshes;
    material.triangles += triangles;
    ++out.meshes;
    out.triangles += triangles;
    out.vertices += mesh.vertex_count;
}

} // namespace

gui::SceneFacts gather_facts(const SceneDescription& description, const GpuScene& scene, double load_ms)
{
    gui::SceneFacts out;
    out.bounds = scene.bounds();
    out.load_ms = load_ms;
    std::vector<std::size_t> first_materials;
    for (const BakeFile* bake : description.bakes) {
        first_materials.push_back(out.materials.size());
        for (const Material& material : bake->scene().materials) {
            gui::MaterialFacts facts;
            facts.textures = textures_of(material, bake->scene());
            out.materials.push_back(std::move(facts));
        }
        for (const Texture& texture : bake->scene().textures) out.texture_bytes += texture.size;
        out.textures += bake->scene().textures.size();
    }
    out.instances = description.instances.size();
    for (const Instance& instance : description.instances) {
        const std::vector<Mesh>& meshes = description.bakes[instance.bake]->scene().meshes;
        for (std::size_t i = 0; i < meshes.size(); ++i)
            if (!instance.mesh || *instance.mesh == i) count(meshes[i], first_materials[instance.bake], out);
    }
    find_images(out, scene);
    return out;
}

void find_images(gui::SceneFacts& facts, const GpuScene& scene)
{
    for (std::size_t i = 0; i < facts.materials.size(); ++i) {
        const std::uint32_t slot = scene.base_color_slot(i);
        if (slot != shared::no_texture_slot) facts.materials[i].image = shared::ui_textures + slot;
    }
}

} // namespace atrium::app
