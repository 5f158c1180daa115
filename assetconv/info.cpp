#include "assetconv/info.hpp"

#include "assetconv/warnings.hpp"
#include "renderer/scene/bake_format.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace atrium {
namespace {

using Json = nlohmann::ordered_json;

Json vector_json(const vec3& v)
{
    return {v.x, v.y, v.z};
}

Json bounds_json(const Bounds& b)
{
    return {{"min", vector_json(b.min)}, {"max", vector_json(b.max)}};
}

Json mesh_json(const Mesh& m)
{
    return {{"name", m.name},
            {"material", m.material},
            {"triangles", m.index_count / 3},
            {"two_sided", m.two_sided},
            {"vertices", m.vertex_count},
            {"clusters", m.cluster_count},
            {"bounds", bounds_json(m.bounds)}};
}

Json material_json(const Material& m)
{
    const auto texture = [](std::int32_t t) { return t == no_texture ? Json() : Json(t); };
    return {{"name", m.name},
            {"class", to_string(m.cls)},
            {"two_sided", m.two_sided},
            {"base_color", vector_json(m.base_color)},
            {"opacity", m.opacity},
            {"alpha_cutoff", m.alpha_cutoff},
            {"roughness", m.roughness},
            {"metallic", m.metallic},
            {"specular", m.specular},
            {"emission", vector_json(m.emission)},
            {"base_color_texture", texture(m.base_color_texture)},
            {"normal_texture", texture(m.normal_texture)},
            {"surface_texture", texture(m.surface_texture)},
            {"emission_texture", texture(m.emission_texture)}};
}

Json texture_json(const Texture& t)
{
    return {{"file", t.file}, {"width", t.width}, {"height", t.height}, {"format", to_string(t.format)},
            {"mips", t.mips}, {"clamp", t.clamp}, {"bytes", t.size}};
}

std::uint64_t texel_bytes(const Scene& scene)
{
    std::uint64_t bytes = 0;
    for (const Texture& t : scene.textures) bytes += t.size;
    return bytes;
}

std::string megabytes(std::uint64_t bytes)
{
    return fmt::format("{:.1f} MiB", static_cast<double>(bytes) / (1024.0 * 1024.0));
}

std::string texture_label(std::int32_t t)
{
    return t == no_texture ? "-" : fmt::format("{}", t);
}

} // namespace

nlohmann::ordered_json info_json(const Scene& scene, std::uint64_t file_size)
{
    Json meshes = Json::array(), materials = Json::array(), textures = Json::array(), warnings = Json::array();
    for (const Mesh& m : scene.meshes) meshes.push_back(mesh_json(m));
    for (const Material& m : scene.materials) materials.push_back(material_json(m));
    for (const Texture& t : scene.textures) textures.push_back(texture_json(t));
    for (const BakeWarning& w : scene.warnings)
        warnings.push_back({{"kind", w.kind}, {"count", w.count}, {"first", w.first}});
    return {{"format_version", bake::format_version},
            {"source", scene.source},
            {"bounds", bounds_json(scene.bounds)},
            {"vertices", scene.vertex_count},
            {"triangles", scene.index_count / 3},
            {"clusters", scene.clusters.size()},
            {"sizes",
             {{"file", file_size},
              {"vertices", scene.vertex_count * sizeof(Vertex)},
              {"indices", scene.index_count * sizeof(std::uint32_t)},
              {"texels", texel_bytes(scene)}}},
            {"meshes", std::move(meshes)},
            {"materials", std::move(materials)},
            {"textures", std::move(textures)},
            {"warnings", std::move(warnings)}};
}

std::string to_text(const nlohmann::ordered_json& json)
{
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string info_text(const Scene& scene, std::uint64_t file_size)
{
    const vec3 size = scene.bounds.extent(), low = scene.bounds.min, high = scene.bounds.max;
    std::string out = fmt::format("{}, format {}, {}\n", scene.source, bake::format_version, megabytes(file_size));
    out += fmt::format("bounds     {:.3f} {:.3f} {:.3f} to {:.3f} {:.3f} {:.3f}  ({:.2f} x {:.2f} x {:.2f} m)\n", low.x,
                       low.y, low.z, high.x, high.y, high.z, size.x, size.y, size.z);
    out += fmt::format("geometry   {} triangles, {} vertices, {} clusters, {}\n", scene.index_count / 3,
                       scene.vertex_count, scene.clusters.size(),
                       megabytes(scene.vertex_count * sizeof(Vertex) + scene.index_count * sizeof(std::uint32_t)));
    out += fmt::format("textures   {}, {}\n", scene.textures.size(), megabytes(texel_bytes(scene)));

    out += fmt::format(
        "\nmaterials ({}): class, base colour, roughness, metallic, specular; textures base normal surface emission\n",
        scene.materials.size());
    for (std::size_t i = 0; i < scene.materials.size(); ++i) {
        const Material& m = scene.materials[i];
        out += fmt::format("{:5}  {:24} {:8} {:.3f} {:.3f} {:.3f}  r {:.4f}  m {:.2f}  s {:.4f}  {} {} {} {}{}\n", i,
                           m.name, to_string(m.cls), m.base_color.x, m.base_color.y, m.base_color.z, m.roughness,
                           m.metallic, m.specular, texture_label(m.base_color_texture), texture_label(m.normal_texture),
                           texture_label(m.surface_texture), texture_label(m.emission_texture),
                           m.two_sided ? "  two-sided" : "");
    }
    out += fmt::format("\ntextures ({})\n", scene.textures.size());
    for (std::size_t i = 0; i < scene.textures.size(); ++i) {
        const Texture& t = scene.textures[i];
        out += fmt::format("{:5}  {:5} x {:<5} {:2} mips  {:11} {}{}\n", i, t.width, t.height, t.mips,
                           to_string(t.format), t.file, t.clamp ? "  clamped" : "");
    }
    out += fmt::format("\nmeshes ({}): material, triangles, clusters\n", scene.meshes.size());
    for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
        const Mesh& m = scene.meshes[i];
        out += fmt::format("{:5}  {:24} {:4} {:8} {:6}  {}\n", i, m.name, m.material, m.index_count / 3,
                           m.cluster_count, m.two_sided ? "two-sided" : "one-sided");
    }
    if (!scene.warnings.empty()) out += "\nwarnings of the bake\n";
    for (const std::string& line : warning_lines(scene)) out += line + "\n";
    return out;
}

std::vector<std::string> warning_lines(const Scene& scene)
{
    std::vector<std::string> lines;
    for (const BakeWarning& w : scene.warnings) {
        const auto kinds = warning_kinds();
        const auto kind =
            std::find_if(kinds.begin(), kinds.end(), [&](const WarningKind& k) { return k.name == w.kind; });
        std::string line =
            fmt::format("{} x {}: {}; first: {}", w.count, w.kind, kind == kinds.end() ? "" : kind->meaning, w.first);
        // The place quotes an untrusted file: no control characters may reach the terminal.
        std::replace_if(
            line.begin(), line.end(), [](char c) { return (c >= 0 && c < ' ') || c == '\x7f'; }, '?');
        lines.push_back(std::move(line));
    }
    return lines;
}

} // namespace atrium
