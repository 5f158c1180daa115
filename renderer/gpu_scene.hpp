#pragma once
// A scene resident on the device: geometry, textures, tables, and the tasks of its draws in material order.

#include "renderer/gpu/descriptors.hpp"
#include "renderer/scene/bake_file.hpp"
#include "renderer/scene/instance.hpp"
#include "renderer/scene/scene_file.hpp"
#include "renderer/scene_upload.hpp"
#include "renderer/techniques/common/draw_list.hpp"
#include "renderer/techniques/culling/culling.hpp"
#include "shaders/shared/culling.h"
#include "shaders/shared/scene.h"

#include <compare>
#include <span>
#include <string>
#include <vector>

namespace atrium {

/// Sizes in bytes of the buffers that culling of single triangles uses, each through one binding.
struct TriangleBytes {
    std::uint64_t vertices = 0, indices = 0;
    std::uint64_t task_indices = 0; ///< a copy of the indices of every instance
};

/// In one line, why the device cannot cull single triangles of such a scene; empty if it can.
[[nodiscard]] std::string triangle_culling_refusal(const gpu::DeviceReport& device, const TriangleBytes& bytes);

class GpuScene {
public:
    /// Uploads `bakes`, which must outlive the call only. Throws Error(environment) when memory or the descriptor table
    /// is exhausted or the device cannot sample the bake's texture formats.
    GpuScene(const gpu::Device& device, gpu::Descriptors& descriptors, std::span<const BakeFile* const> bakes,
             std::span<const Instance> instances, std::span<const MaterialOverride> overrides,
             UploadPath path = UploadPath::automatic);
    ~GpuScene();
    GpuScene(const GpuScene&) = delete;
    GpuScene& operator=(const GpuScene&) = delete;

    [[nodiscard]] Geometry geometry() const { return {&vertices_, &indices_, !device_.report().is_cpu}; }
    [[nodiscard]] DrawTasks tasks() const
    {
        return {task_count_, ranges_, task_indices_, subgroup_size_, device_.report().subpixel_bits};
    }
    /// Arranges the draw order for a camera: within a material, near clusters first, so that they hide far ones before
    /// those are shaded. Between frames only.
    void sort_for(const vec3& eye);
    /// The draw order: indices of tasks, as the device wants them.
    void write_order(std::span<std::uint32_t> out) const;
    [[nodiscard]] std::span<const shared::GpuRecord> records() const { return record_table_; }
    [[nodiscard]] std::span<const shared::GpuMaterial> packed_materials() const { return packed_; }
    /// Another number, never 0, after each change of records() or packed_materials().
    [[nodiscard]] std::uint64_t version() const { return version_; }
    /// One command per mesh of each record in file order, nothing culled: opaque ones first, from 0, then those with
    /// holes. What floor.gbuffer draws.
    [[nodiscard]] const gpu::Buffer& whole_meshes() const { return whole_meshes_; }
    [[nodiscard]] std::span<const DrawRange> whole_mesh_ranges() const { return whole_ranges_; }

    /// In one line, which setting has no effect with this scene on this device, and why; empty if all have.
    [[nodiscard]] const std::string& note() const { return note_; }

    [[nodiscard]] const Bounds& bounds() const { return bounds_; } ///< of all instances, world
    /// As bakes and the scene's overrides have them. Their index is the AOV `material`.
    [[nodiscard]] std::span<const Material> materials() const { return materials_; }
    /// In the table of textures; shared::no_texture_slot where it has none.
    [[nodiscard]] std::uint32_t base_color_slot(std::size_t material) const
    {
        return packed_[material].slots.x & shared::no_texture_slot;
    }
    /// Shows materials() with further overrides, instead of those of the last call. Whether that may change which
    /// pixels a surface covers. Between frames only.
    bool override_materials(std::span<const MaterialOverride> overrides);
    /// Sets where instances were in the previous frame; all others, also those of the last call, have not moved. Costs
    /// nothing if none has moved. Call it after override_materials(), and only between frames.
    void set_previous_instances(std::span<const PreviousInstance> moved);
    [[nodiscard]] std::uint32_t material_of_task(std::uint32_t ordered) const
    {
        return tasks_on_host_[order_[ordered].task].material;
    }

private:
    GpuScene(const gpu::Device& device, gpu::Descriptors& descriptors) : device_(device), descriptors_(descriptors) {}
    struct Task {
        shared::DrawTask draw{};
        vec3 centre{0}; ///< of its bounding sphere, world
        float radius = 0;
        std::uint32_t material = 0;
        std::uint32_t range = 0; ///< class and sidedness, in draw order
    };
    /// What the draw order is sorted by. Ties go by task: never by chance.
    struct DrawKey {
        std::uint64_t group = 0;    ///< range, layer of distance (logarithmic), material; the first counts most
        std::uint32_t distance = 0; ///< from the eye to the far end of its sphere, m; bits of the float
        std::uint32_t task = 0;     ///< index in the task table
        auto operator<=>(const DrawKey&) const = default;
    };
    struct WholeMesh {
        shared::DrawCommand command{};
        bool two_sided = false; ///< whatever its material
    };
    struct Bases;
    [[nodiscard]] static std::vector<Bases> bases_of(std::span<const BakeFile* const> bakes);
    void load_bulk(std::span<const BakeFile* const> bakes, UploadPath path);
    void make_tables(std::span<const BakeFile* const> bakes, std::span<const Instance> instances,
                     std::span<const MaterialOverride> overrides);
    void add_materials(const Scene& scene, std::uint32_t first_texture, std::span<const MaterialOverride> overrides);
    void add_record(const Scene& scene, std::uint32_t mesh_index, const Instance& instance,
                    std::uint32_t instance_index, const Bases& base);
    void write_tables(std::span<const shared::GpuCluster> clusters);
    /// Packs what is shown of each material.
    void pack_materials();
    /// Sorts records, tasks and whole meshes by the class and sidedness of what is shown.
    void classify();
    void find_ranges();

    const gpu::Device& device_;
    gpu::Descriptors& descriptors_;
    gpu::Buffer vertices_, indices_, clusters_, tasks_, whole_meshes_;
    std::vector<gpu::Image> images_;
    std::vector<gpu::TextureSlot> texture_slots_;
    std::vector<Material> materials_, shown_; ///< shown_: with override_materials()
    std::vector<MaterialOverride> overrides_; ///< of shown_
    std::vector<shared::GpuMaterial> packed_; ///< of shown_
    std::vector<shared::GpuRecord> record_table_;
    bool any_moved_ = false; ///< record_table_ has records that moved
    std::uint64_t version_ = 1;
    std::vector<WholeMesh> meshes_; ///< by record
    std::vector<shared::DrawCommand> whole_commands_;
    std::vector<DrawRange> ranges_, whole_ranges_;
    std::vector<Task> tasks_on_host_;
    std::vector<DrawKey> order_; ///< as sort_for() left it
    std::uint32_t task_count_ = 0;
    std::uint64_t task_indices_ = 0;
    std::uint32_t subgroup_size_ = 0;
    std::string note_;
    Bounds bounds_;
};

} // namespace atrium
