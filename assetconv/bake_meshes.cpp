#include "assetconv/bake_meshes.hpp"

#include "assetconv/clusters.hpp"
#include "assetconv/normals.hpp"
#include "renderer/core/error.hpp"
#include "renderer/core/jobs.hpp"
#include "renderer/core/progress.hpp"

#include <limits>

namespace atrium {
namespace {

void decide_sides(SourceScene& scene, const MaterialSet& set, TwoSided option)
{
    for (SourceMesh& mesh : scene.meshes) {
        if (option == TwoSided::automatic) {
            mesh.two_sided = set.plans[mesh.material].material.two_sided || winding_is_unreliable(scene, mesh);
        } else {
            mesh.two_sided = option == TwoSided::on;
        }
    }
}

/// Appends one mesh and makes its indices absolute.
void append(const SourceMesh& source, const ClusteredMesh& mesh, BakeData& out)
{
    constexpr std::uint64_t limit = std::numeric_limits<std::uint32_t>::max();
    if (out.indices.size() + mesh.indices.size() > limit || out.vertices.size() + mesh.vertices.size() > limit) {
        throw Error(ExitCode::input, "scene too large", source.name, "more than 4 billion indices",
                    "split it into several files");
    }
    Mesh m;
    m.name = source.name;
    m.material = source.material;
    m.two_sided = source.two_sided;
    m.first_index = static_cast<std::uint32_t>(out.indices.size());
    m.index_count = static_cast<std::uint32_t>(mesh.indices.size());
    m.first_vertex = static_cast<std::uint32_t>(out.vertices.size());
    m.vertex_count = static_cast<std::uint32_t>(mesh.vertices.size());
    m.first_cluster = static_cast<std::uint32_t>(out.scene.clusters.size());
    m.cluster_count = static_cast<std::uint32_t>(mesh.clusters.size());
    for (const std::uint32_t i : mesh.indices) out.indices.push_back(m.first_vertex + i);
    for (Cluster c : mesh.clusters) {
        c.first_index += m.first_index;
        out.scene.clusters.push_back(c);
    }
    for (const Vertex& v : mesh.vertices) m.bounds.add(v.position);
    out.vertices.insert(out.vertices.end(), mesh.vertices.begin(), mesh.vertices.end());
    out.scene.bounds.add(m.bounds);
    out.scene.meshes.push_back(std::move(m));
}

} // namespace

void bake_meshes(const ObjFile& obj, const MaterialSet& set, const BakeOptions& options, BakeData& out,
                 Warnings& warnings)
{
    SourceScene scene =
        build_triangles(obj, set.material_of, set.default_material, options.scale, options.up, warnings);
    drop_duplicates(scene, obj.path, warnings);
    decide_sides(scene, set, options.two_sided);
    drop_reversed_duplicates(scene, obj.path, warnings);
    turn_to_normals(scene, obj.path, warnings);
    if (scene.meshes.empty()) {
        throw Error(ExitCode::input, "nothing to draw", obj.path.string(),
                    obj.faces.empty() ? "the file has no usable face" : "every face is without area",
                    "check that the file is an OBJ with `f` lines, and --scale");
    }
    generate_normals(scene, options.smooth_angle);

    std::vector<ClusteredMesh> meshes(scene.meshes.size());
    Progress progress("building meshes", meshes.size());
    parallel_for(meshes.size(), [&](std::size_t i) {
        const SourceMesh& source = scene.meshes[i];
        meshes[i] = build_clusters(build_vertices(scene, source, set.plans[source.material].uv), source.two_sided);
        progress.advance();
    });
    for (std::size_t i = 0; i < meshes.size(); ++i) append(scene.meshes[i], meshes[i], out);
    out.scene.vertex_count = out.vertices.size();
    out.scene.index_count = out.indices.size();
}

} // namespace atrium
