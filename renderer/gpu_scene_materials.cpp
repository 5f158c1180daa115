// What a GpuScene shows of its materials: how they are packed, and in which order their meshes are drawn.

#include "renderer/gpu_scene.hpp"
#include "renderer/materials/material_class.hpp"

#include <glm/gtc/packing.hpp>

#include <algorithm>
#include <array>
#include <tuple>

namespace atrium {
namespace {

bool covers_alike(const Material& a, const Material& b)
{
    const auto coverage = [](const Material& m) { return std::tie(m.cls, m.two_sided, m.opacity, m.alpha_cutoff); };
    return coverage(a) == coverage(b);
}

} // namespace

bool GpuScene::override_materials(std::span<const MaterialOverride> overrides)
{
    if (std::equal(overrides.begin(), overrides.end(), overrides_.begin(), overrides_.end())) return false;
    overrides_.assign(overrides.begin(), overrides.end());
    bool alike = true;
    for (std::size_t i = 0; i < materials_.size(); ++i) {
        Material now = overridden(materials_[i], overrides);
        alike = alike && covers_alike(now, shown_[i]);
        shown_[i] = std::move(now);
    }
    pack_materials();
    ++version_;
    if (alike) return false;
    classify();
    whole_meshes_.write(std::span<const shared::DrawCommand>(whole_commands_));
    return true;
}

void GpuScene::pack_materials()
{
    for (std::size_t i = 0; i < shown_.size(); ++i) {
        const Material& m = shown_[i];
        shared::GpuMaterial& packed = packed_[i];
        const bool emits = m.emission != vec3(0) || m.emission_texture != no_texture;
        packed.factors = {
            glm::packHalf2x16(vec2(m.base_color.x, m.base_color.y)), glm::packHalf2x16(vec2(m.base_color.z, m.opacity)),
            glm::packHalf2x16(vec2(m.roughness, m.metallic)), glm::packHalf2x16(vec2(m.specular, m.alpha_cutoff))};
        packed.flags = (packed.flags & shared::material_clamps) | (emits ? shared::material_emits : 0u);
        packed.emission = m.emission;
    }
}

void GpuScene::classify()
{
    std::array<std::vector<shared::DrawCommand>, material_class_count> whole; // by draw rank
    std::vector<std::uint32_t> range_of_record;
    for (std::size_t i = 0; i < record_table_.size(); ++i) {
        shared::GpuRecord& record = record_table_[i];
        const Material& material = shown_[record.material];
        const auto rank = static_cast<std::uint32_t>(draw_rank(material.cls));
        const MaterialClassInfo& cls = material_classes[rank];
        const bool two_sided = meshes_[i].two_sided || material.two_sided || cls.sides == Sides::both;
        record.flags = (two_sided ? shared::record_two_sided : 0u) | (cls.has_holes ? shared::record_has_holes : 0u) |
                       (cls.deformed ? shared::record_deformed | shared::record_moves : 0u);
        range_of_record.push_back(2 * rank + (two_sided ? 1u : 0u));
        whole[rank].push_back(meshes_[i].command);
    }
    for (Task& task : tasks_on_host_) task.range = range_of_record[task.draw.record];
    find_ranges();

    whole_commands_.clear();
    whole_ranges_.clear();
    for (std::size_t rank = 0; rank < whole.size(); ++rank) {
        if (whole[rank].empty()) continue;
        whole_ranges_.push_back({material_classes[rank].cls, true, static_cast<std::uint32_t>(whole_commands_.size()),
                                 static_cast<std::uint32_t>(whole[rank].size())});
        whole_commands_.insert(whole_commands_.end(), whole[rank].begin(), whole[rank].end());
    }
}

void GpuScene::find_ranges()
{
    std::vector<std::uint32_t> counts(2 * material_class_count);
    for (const Task& task : tasks_on_host_) ++counts[task.range];
    ranges_.clear();
    std::uint32_t first = 0;
    for (std::uint32_t range = 0; range < counts.size(); ++range) {
        if (counts[range] == 0) continue;
        ranges_.push_back({material_classes[range / 2].cls, (range & 1) != 0, first, counts[range]});
        first += counts[range];
    }
}

} // namespace atrium
