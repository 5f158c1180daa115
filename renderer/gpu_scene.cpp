#include "renderer/gpu_scene.hpp"

#include "renderer/core/error.hpp"
#include "renderer/core/log.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

namespace atrium {
namespace {

/// Layers of the draw order in a doubling of distance. More hide a little better and change material more often.
constexpr float layers_per_octave = 16;

gpu::Format gpu_format(TextureFormat f)
{
    switch (f) {
    case TextureFormat::rgba8_srgb:
        return gpu::Format::rgba8_srgb;
    case TextureFormat::rgba8_unorm:
        return gpu::Format::rgba8_unorm;
    case TextureFormat::rg8_unorm:
        return gpu::Format::rg8_unorm;
    case TextureFormat::r8_unorm:
        return gpu::Format::r8_unorm;
    case TextureFormat::bc1_srgb:
        return gpu::Format::bc1_srgb;
    case TextureFormat::bc3_srgb:
        return gpu::Format::bc3_srgb;
    case TextureFormat::bc3_unorm:
        return gpu::Format::bc3_unorm;
    case TextureFormat::bc5_unorm:
        return gpu::Format::bc5_unorm;
    }
    return gpu::Format::none;
}

/// A table that shaders read.
template <class T>
gpu::Buffer make_table(const gpu::Device& device, const char* name, std::span<const T> items)
{
    const std::uint64_t bytes = std::max<std::uint64_t>(items.size_bytes(), sizeof(T));
    gpu::Buffer buffer(device, name, bytes, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT,
                       gpu::MemoryUse::upload);
    buffer.write(items);
    return buffer;
}

/// Largest factor by which a matrix stretches: for spheres that must stay conservative.
float max_scale(const mat4& m)
{
    return std::sqrt(std::max(
        {glm::dot(vec3(m[0]), vec3(m[0])), glm::dot(vec3(m[1]), vec3(m[1])), glm::dot(vec3(m[2]), vec3(m[2]))}));
}

std::vector<std::uint32_t> meshes_of(const Scene& scene, const Instance& instance)
{
    if (instance.mesh) return {*instance.mesh};
    std::vector<std::uint32_t> all(scene.meshes.size());
    for (std::uint32_t i = 0; i < all.size(); ++i) all[i] = i;
    return all;
}

} // namespace

std::string triangle_culling_refusal(const gpu::DeviceReport& device, const TriangleBytes& bytes)
{
    constexpr double mebibyte = 1 << 20;
    if (!device.optional.subgroup_ballot)
        return "culling.triangles has no effect: the device has no subgroup ballots in compute shaders";
    for (const auto& [what, size] : {std::pair{"vertices", bytes.vertices}, std::pair{"indices", bytes.indices},
                                     std::pair{"indices of all instances", bytes.task_indices}}) {
        if (size > device.storage_range)
            return fmt::format("culling.triangles has no effect: the scene's {} take {:.0f} MiB, and shaders of this "
                               "device reach {:.0f} MiB of a buffer",
                               what, static_cast<double>(size) / mebibyte,
                               static_cast<double>(device.storage_range) / mebibyte);
    }
    return "";
}

/// Where each bake's items begin in the common tables.
struct GpuScene::Bases {
    std::uint64_t vertices = 0, indices = 0;
    std::uint32_t materials = 0, textures = 0, meshes = 0, clusters = 0;

    [[nodiscard]] Bases after(const Scene& scene) const
    {
        Bases next = *this;
        next.vertices += scene.vertex_count;
        next.indices += scene.index_count;
        next.materials += static_cast<std::uint32_t>(scene.materials.size());
        next.textures += static_cast<std::uint32_t>(scene.textures.size());
        next.meshes += static_cast<std::uint32_t>(scene.meshes.size());
        next.clusters += static_cast<std::uint32_t>(scene.clusters.size());
        return next;
    }
};

std::vector<GpuScene::Bases> GpuScene::bases_of(std::span<const BakeFile* const> bakes)
{
    std::vector<Bases> bases(1);
    for (const BakeFile* bake : bakes) bases.push_back(bases.back().after(bake->scene()));
    return bases;
}

GpuScene::GpuScene(const gpu::Device& device, gpu::Descriptors& descriptors, std::span<const BakeFile* const> bakes,
                   std::span<const Instance> instances, std::span<const MaterialOverride> overrides, UploadPath path)
    : GpuScene(device, descriptors) // so that what follows gives its texture slots back where it fails
{
    load_bulk(bakes, path);
    make_tables(bakes, instances, overrides);
}

GpuScene::~GpuScene()
{
    for (const gpu::TextureSlot slot : texture_slots_) descriptors_.remove_texture(slot);
}

void GpuScene::load_bulk(std::span<const BakeFile* const> bakes, UploadPath path)
{
    const std::vector<Bases> bases = bases_of(bakes);
    if (bases.back().vertices > static_cast<std::uint64_t>(std::numeric_limits<std::int32_t>::max())) {
        throw Error(ExitCode::environment, "the scene has too many vertices", "", "indirect draws address at most 2^31",
                    "split it");
    }
    constexpr VkBufferUsageFlags common = VK_BUFFER_USAGE_TRANSFER_DST_BIT | VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;
    vertices_ = gpu::Buffer(device_, "vertices", std::max<std::uint64_t>(bases.back().vertices, 1) * sizeof(Vertex),
                            VK_BUFFER_USAGE_VERTEX_BUFFER_BIT | common, gpu::MemoryUse::device);
    indices_ = gpu::Buffer(device_, "indices", std::max<std::uint64_t>(bases.back().indices, 1) * 4,
                           VK_BUFFER_USAGE_INDEX_BUFFER_BIT | common, gpu::MemoryUse::device);
    images_.reserve(bases.back().textures);
    std::vector<UploadJob> jobs;
    for (std::size_t b = 0; b < bakes.size(); ++b) {
        const BakeFile& bake = *bakes[b];
        const auto offset_of = [&](std::span<const std::byte> section) {
            return static_cast<std::uint64_t>(section.data() - bake.bytes().data());
        };
        UploadJob job{bake.bytes(), {}, {}};
        job.buffers.push_back(
            {&vertices_, bases[b].vertices * sizeof(Vertex), offset_of(bake.vertices()), bake.vertices().size()});
        job.buffers.push_back({&indices_, bases[b].indices * 4, offset_of(bake.indices()), bake.indices().size()});
        for (const Texture& texture : bake.scene().textures) {
            if (is_block_compressed(texture.format) && !device_.report().optional.block_compression) {
                throw Error(ExitCode::environment, "the device cannot sample block-compressed textures",
                            bake.path().string(),
                            fmt::format("{} has the format {}", texture.file, to_string(texture.format)),
                            "bake the scene again with --textures rgba8");
            }
            images_.emplace_back(device_, texture.file,
                                 gpu::ImageDesc{gpu_format(texture.format), texture.width, texture.height, texture.mips,
                                                1, VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT});
            texture_slots_.push_back(descriptors_.add_texture(images_.back()));
            const auto offsets = mip_offsets(texture.format, texture.width, texture.height, texture.mips);
            for (std::uint32_t mip = 0; mip < texture.mips; ++mip) {
                const std::uint64_t size =
                    mip_bytes(texture.format, std::max(texture.width >> mip, 1u), std::max(texture.height >> mip, 1u));
                job.images.push_back(
                    {&images_.back(), mip, offset_of(bake.texels()) + texture.offset + offsets[mip], size});
            }
        }
        jobs.push_back(std::move(job));
    }
    upload(device_, jobs, path);
}

void GpuScene::make_tables(std::span<const BakeFile* const> bakes, std::span<const Instance> instances,
                           std::span<const MaterialOverride> overrides)
{
    const std::vector<Bases> bases = bases_of(bakes);
    std::vector<shared::GpuCluster> clusters;
    for (std::size_t b = 0; b < bakes.size(); ++b) {
        const Scene& scene = bakes[b]->scene();
        add_materials(scene, bases[b].textures, overrides);
        for (const Cluster& c : scene.clusters) {
            const auto first = static_cast<std::uint32_t>(bases[b].indices) + c.first_index;
            clusters.push_back({c.centre, c.radius, c.cone_axis, c.cone_cutoff, first, c.index_count});
        }
    }
    for (std::uint32_t i = 0; i < instances.size(); ++i) {
        const Scene& scene = bakes[instances[i].bake]->scene();
        for (const std::uint32_t mesh : meshes_of(scene, instances[i])) {
            add_record(scene, mesh, instances[i], i, bases[instances[i].bake]);
        }
    }
    constexpr std::size_t record_capacity = (1u << 24) - 1; // what the G-buffer's id holds
    if (record_table_.size() > record_capacity) {
        throw Error(ExitCode::environment, "the scene has too many meshes times instances", "",
                    fmt::format("{} of at most {}", record_table_.size(), record_capacity), "use fewer instances");
    }
    shown_ = materials_;
    pack_materials();
    classify();
    write_tables(clusters);
}

void GpuScene::add_materials(const Scene& scene, std::uint32_t first_texture,
                             std::span<const MaterialOverride> overrides)
{
    const auto slot = [&](std::int32_t texture) {
        return texture == no_texture ? shared::no_texture_slot
                                     : texture_slots_[first_texture + static_cast<std::uint32_t>(texture)];
    };
    for (const Material& m : scene.materials) {
        const bool clamp =
            m.base_color_texture != no_texture && scene.textures[static_cast<std::size_t>(m.base_color_texture)].clamp;
        shared::GpuMaterial packed{};
        packed.slots = {slot(m.base_color_texture) | slot(m.normal_texture) << 16,
                        slot(m.surface_texture) | slot(m.emission_texture) << 16};
        packed.flags = clamp ? shared::material_clamps : 0u;
        packed_.push_back(packed);
        materials_.push_back(overridden(m, overrides));
    }
}

void GpuScene::add_record(const Scene& scene, std::uint32_t mesh_index, const Instance& instance,
                          std::uint32_t instance_index, const Bases& base)
{
    const Mesh& mesh = scene.meshes[mesh_index];
    const auto index = static_cast<std::uint32_t>(record_table_.size());
    const mat4 rows = glm::transpose(instance.world_from_object);

    shared::GpuRecord record{};
    for (int r = 0; r < 3; ++r) record.world_rows[r] = record.prev_rows[r] = rows[r];
    record.material = base.materials + mesh.material;
    record.mesh = base.meshes + mesh_index;
    record.instance = instance_index;
    record.max_scale = max_scale(instance.world_from_object);
    record.vertex_offset = static_cast<std::int32_t>(base.vertices);
    record_table_.push_back(record);
    meshes_.push_back({{mesh.index_count, 1, static_cast<std::uint32_t>(base.indices) + mesh.first_index,
                        record.vertex_offset, index},
                       mesh.two_sided});

    for (std::uint32_t c = mesh.first_cluster; c < mesh.first_cluster + mesh.cluster_count; ++c) {
        Task task;
        task.draw = {index, base.clusters + c, static_cast<std::uint32_t>(task_indices_)};
        task_indices_ += scene.clusters[c].index_count;
        task.centre = vec3(instance.world_from_object * vec4(scene.clusters[c].centre, 1));
        task.radius = scene.clusters[c].radius * record.max_scale;
        task.material = record.material;
        tasks_on_host_.push_back(task);
    }
    bounds_.add(transformed(mesh.bounds, instance.world_from_object));
}

void GpuScene::write_tables(std::span<const shared::GpuCluster> clusters)
{
    std::vector<shared::DrawTask> tasks;
    for (const Task& task : tasks_on_host_) tasks.push_back(task.draw);
    if (tasks.size() * sizeof(shared::DrawCommand) > device_.report().storage_range) {
        throw Error(ExitCode::environment, "the scene has too many clusters times instances", "",
                    fmt::format("{} draw commands exceed what shaders of this device reach of a buffer", tasks.size()),
                    "use fewer instances");
    }
    task_count_ = static_cast<std::uint32_t>(tasks.size());
    clusters_ = make_table<shared::GpuCluster>(device_, "clusters", clusters);
    tasks_ = make_table<shared::DrawTask>(device_, "draw tasks", tasks);
    whole_meshes_ = make_table<shared::DrawCommand>(device_, "whole meshes", whole_commands_);
    descriptors_.set_frame_buffer(gpu::FrameBinding::clusters, clusters_);
    descriptors_.set_frame_buffer(gpu::FrameBinding::draw_tasks, tasks_);
    note_ = triangle_culling_refusal(device_.report(),
                                     {vertices_.size(), indices_.size(), task_indices_ * sizeof(std::uint32_t)});
    if (!note_.empty()) {
        log_warning(note_);
    } else {
        subgroup_size_ = device_.report().subgroup_size;
        descriptors_.set_frame_buffer(gpu::FrameBinding::vertices, vertices_);
        descriptors_.set_frame_buffer(gpu::FrameBinding::indices, indices_);
    }
}

void GpuScene::set_previous_instances(std::span<const PreviousInstance> moved)
{
    if (moved.empty() && !any_moved_) return;
    any_moved_ = !moved.empty();
    for (shared::GpuRecord& record : record_table_) {
        const auto found = std::find_if(moved.begin(), moved.end(), [&](const PreviousInstance& previous) {
            return previous.instance == record.instance;
        });
        record.flags &= ~shared::record_moves;
        std::copy_n(record.world_rows, 3, record.prev_rows);
        if (found == moved.end()) continue;
        const mat4 rows = glm::transpose(found->world_from_object);
        for (int r = 0; r < 3; ++r) record.prev_rows[r] = rows[r];
        record.flags |= shared::record_moves;
    }
    ++version_;
}

void GpuScene::sort_for(const vec3& eye)
{
    if (order_.size() != tasks_on_host_.size()) {
        order_.resize(tasks_on_host_.size());
        for (std::uint32_t i = 0; i < order_.size(); ++i) order_[i].task = i;
    }
    for (DrawKey& key : order_) { // in the last order, which is close to the next
        const Task& task = tasks_on_host_[key.task];
        // By its far end: a wall that passes close by must not be drawn before what stands in front of most of it.
        const float distance = glm::length(task.centre - eye) + task.radius;
        constexpr int lowest = 1024; // below floor(layers_per_octave * log2(1e-6))
        const int layer =
            static_cast<int>(std::floor(layers_per_octave * std::log2(std::max(distance, 1e-6f)))) + lowest;
        key.group = std::uint64_t{task.range} << 48 | static_cast<std::uint64_t>(layer) << 32 | task.material;
        key.distance = std::bit_cast<std::uint32_t>(distance);
    }
    std::sort(order_.begin(), order_.end());
}

void GpuScene::write_order(std::span<std::uint32_t> out) const
{
    for (std::size_t i = 0; i < order_.size(); ++i) out[i] = order_[i].task;
}

} // namespace atrium
