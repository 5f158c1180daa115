#include "tests/truth/truth_scene.hpp"

#include "renderer/core/error.hpp"
#include "renderer/scene/vertex_packing.hpp"
#include "tests/truth/alpha_map.hpp"
#include "tests/truth/embree.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

namespace atrium::truth {
namespace {

/// What the filters know about a mesh.
struct MeshView {
    const Scene* scene = nullptr;
    const Mesh* mesh = nullptr;
    const Material* material = nullptr;
    const AlphaMap* alpha = nullptr; ///< of a masked material with a texture
    bool one_sided = true;
    std::span<const Vertex> vertices;       ///< of the whole bake
    std::span<const std::uint32_t> indices; ///< of this mesh

    [[nodiscard]] std::array<const Vertex*, 3> triangle(std::uint32_t primitive) const
    {
        const auto corner = [&](std::size_t k) { return &vertices[indices[std::size_t{primitive} * 3 + k]]; };
        return {corner(0), corner(1), corner(2)};
    }
};

/// A query, and what its filters report. Embree hands its first member to them.
struct Query {
    embree::Context context;
    Facing facing;
    double nearest_hole;
};

dvec3 winding_normal(const std::array<const Vertex*, 3>& t)
{
    const dvec3 a(t[0]->position);
    return glm::cross(dvec3(t[1]->position) - a, dvec3(t[2]->position) - a);
}

/// Intersection of the ray with the triangle's plane: distance and the weights of the three corners.
struct PlaneHit {
    double distance;
    dvec3 weights;
};

/// Source: Möller & Trumbore 1997, without its bounds: Embree has decided that the triangle is hit.
std::optional<PlaneHit> intersect_plane(const std::array<const Vertex*, 3>& t, const dvec3& origin,
                                        const dvec3& direction)
{
    const dvec3 a(t[0]->position), ab = dvec3(t[1]->position) - a, ac = dvec3(t[2]->position) - a;
    const dvec3 p = glm::cross(direction, ac);
    const double det = glm::dot(ab, p);
    if (det == 0) return std::nullopt;
    const dvec3 s = origin - a, q = glm::cross(s, ab);
    const double u = glm::dot(s, p) / det, v = glm::dot(direction, q) / det;
    return PlaneHit{glm::dot(ac, q) / det, {1 - u - v, u, v}};
}

dvec2 uv_at(const std::array<const Vertex*, 3>& t, const dvec3& w)
{
    return dvec2(t[0]->uv) * w.x + dvec2(t[1]->uv) * w.y + dvec2(t[2]->uv) * w.z;
}

double opacity(const MeshView& view, const dvec2& uv)
{
    const double factor = static_cast<double>(view.material->opacity);
    return view.alpha != nullptr ? factor * view.alpha->sample(uv) : factor;
}

/// Embree's filter, for closest hits and for occlusion: refuses culled backs and holes.
void filter(const RTCFilterFunctionNArguments* arguments)
{
    if (arguments->valid[0] != -1) return;
    const auto& view = *static_cast<const MeshView*>(arguments->geometryUserPtr);
    auto& query = *reinterpret_cast<Query*>(arguments->context);
    const auto t = view.triangle(RTCHitN_primID(arguments->hit, 1, 0));
    RTCRayN* ray = arguments->ray;
    if (query.facing == Facing::cull && view.one_sided) {
        const dvec3 direction(RTCRayN_dir_x(ray, 1, 0), RTCRayN_dir_y(ray, 1, 0), RTCRayN_dir_z(ray, 1, 0));
        if (glm::dot(winding_normal(t), direction) >= 0) {
            arguments->valid[0] = 0;
            return;
        }
    }
    if (view.material->cls != MaterialClass::masked) return;
    const double u = static_cast<double>(RTCHitN_u(arguments->hit, 1, 0));
    const double v = static_cast<double>(RTCHitN_v(arguments->hit, 1, 0));
    if (opacity(view, uv_at(t, {1 - u - v, u, v})) < static_cast<double>(view.material->alpha_cutoff)) {
        arguments->valid[0] = 0;
        query.nearest_hole = std::min(query.nearest_hole, static_cast<double>(RTCRayN_tfar(ray, 1, 0)));
    }
}

RTCRay to_embree(const Ray& ray)
{
    RTCRay r{};
    r.org_x = static_cast<float>(ray.origin.x);
    r.org_y = static_cast<float>(ray.origin.y);
    r.org_z = static_cast<float>(ray.origin.z);
    r.tnear = static_cast<float>(ray.near);
    r.dir_x = static_cast<float>(ray.direction.x);
    r.dir_y = static_cast<float>(ray.direction.y);
    r.dir_z = static_cast<float>(ray.direction.z);
    r.tfar = static_cast<float>(ray.far);
    r.mask = ~0u;
    return r;
}

Query make_query(Facing facing)
{
    Query query{};
    embree::init(query.context);
    query.facing = facing;
    query.nearest_hole = std::numeric_limits<double>::infinity();
    return query;
}

template <class T>
std::span<const T> as_span(std::span<const std::byte> bytes)
{
    return {reinterpret_cast<const T*>(bytes.data()), bytes.size() / sizeof(T)}; // sections are page-aligned
}

} // namespace

struct TruthScene::State {
    const BakeFile* bake = nullptr;
    RTCDevice device = nullptr;
    RTCScene scene = nullptr;
    std::vector<std::unique_ptr<AlphaMap>> alphas; ///< per texture; null where no mask uses it
    std::vector<MeshView> views;                   ///< per mesh; Embree keeps pointers to them

    ~State()
    {
        if (scene != nullptr) rtcReleaseScene(scene);
        if (device != nullptr) rtcReleaseDevice(device);
    }

    void check() const
    {
        const RTCError error = rtcGetDeviceError(device);
        if (error == RTC_ERROR_NONE) return;
        throw Error(ExitCode::environment, "Embree failed", bake->path().string(),
                    "its error code is " + std::to_string(static_cast<int>(error)), "free memory and try again");
    }

    MeshView view_of(const Mesh& mesh);
    void attach(std::uint32_t index);
};

MeshView TruthScene::State::view_of(const Mesh& mesh)
{
    const Scene& s = bake->scene();
    const Material& material = s.materials[mesh.material];
    MeshView view{&s, &mesh, &material};
    view.one_sided = !mesh.two_sided && !material.two_sided;
    view.vertices = as_span<Vertex>(bake->vertices());
    view.indices = as_span<std::uint32_t>(bake->indices()).subspan(mesh.first_index, mesh.index_count);
    for (const std::uint32_t i : view.indices) {
        if (i < view.vertices.size()) continue;
        throw Error(ExitCode::input, "the bake is damaged", bake->path().string() + ", mesh " + mesh.name,
                    "an index lies beyond the vertices", "bake it again");
    }
    if (material.cls == MaterialClass::masked && material.base_color_texture != no_texture) {
        const auto texture = static_cast<std::size_t>(material.base_color_texture);
        if (!alphas[texture]) alphas[texture] = std::make_unique<AlphaMap>(s.textures[texture], bake->texels());
        view.alpha = alphas[texture].get();
    }
    return view;
}

void TruthScene::State::attach(std::uint32_t index)
{
    MeshView& view = views[index];
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, view.vertices.data(), 0,
                               sizeof(Vertex), view.vertices.size());
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, view.indices.data(), 0,
                               3 * sizeof(std::uint32_t), view.indices.size() / 3);
    rtcSetGeometryUserData(geometry, &view);
    if (view.one_sided || view.material->cls == MaterialClass::masked) {
        rtcSetGeometryIntersectFilterFunction(geometry, filter);
    }
    if (view.material->cls == MaterialClass::masked) rtcSetGeometryOccludedFilterFunction(geometry, filter);
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(scene, geometry, index);
    rtcReleaseGeometry(geometry);
}

TruthScene::TruthScene(const BakeFile& bake) : state_(std::make_unique<State>())
{
    State& s = *state_;
    s.bake = &bake;
    s.device = rtcNewDevice(nullptr);
    s.check();
    s.scene = rtcNewScene(s.device);
    rtcSetSceneFlags(s.scene, RTC_SCENE_FLAG_ROBUST);
    s.alphas.resize(bake.scene().textures.size());
    for (const Mesh& mesh : bake.scene().meshes) s.views.push_back(s.view_of(mesh));
    for (std::uint32_t i = 0; i < s.views.size(); ++i) s.attach(i);
    rtcCommitScene(s.scene);
    s.check();
}

TruthScene::~TruthScene() = default;

const Scene& TruthScene::scene() const
{
    return state_->bake->scene();
}

std::optional<Hit> TruthScene::first_hit(const Ray& ray, Facing facing) const
{
    Query query = make_query(facing);
    RTCRayHit found{};
    found.ray = to_embree(ray);
    found.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    embree::intersect(state_->scene, query.context, found);
    if (found.hit.geomID == RTC_INVALID_GEOMETRY_ID) {
        return std::nullopt;
    }
    const MeshView& view = state_->views[found.hit.geomID];
    const auto t = view.triangle(found.hit.primID);
    const auto plane = intersect_plane(t, ray.origin, ray.direction);
    if (!plane) return std::nullopt;

    Hit hit;
    hit.distance = plane->distance;
    hit.position = ray.origin + plane->distance * ray.direction;
    hit.plane_normal = glm::normalize(winding_normal(t));
    hit.front = glm::dot(hit.plane_normal, ray.direction) < 0;
    const auto normal = [&](int k) { return dvec3(unpack_normal(t[static_cast<std::size_t>(k)]->normal)); };
    const dvec3 w = plane->weights;
    hit.vertex_normal = glm::normalize(normal(0) * w.x + normal(1) * w.y + normal(2) * w.z);
    hit.uv = uv_at(t, w);
    hit.mesh = found.hit.geomID;
    hit.material = view.mesh->material;
    hit.primitive = found.hit.primID;
    const MaterialClass cls = view.material->cls;
    hit.alpha = cls == MaterialClass::masked || cls == MaterialClass::blended ||
                query.nearest_hole <= static_cast<double>(found.ray.tfar);
    return hit;
}

bool TruthScene::occluded(const Ray& ray) const
{
    Query query = make_query(Facing::any);
    RTCRay r = to_embree(ray);
    embree::occluded(state_->scene, query.context, r);
    return r.tfar < 0; // Embree's mark; `near` is never negative
}

} // namespace atrium::truth
