#pragma once
// Floors: what a pass costs at the least, drawn in the same run so that ratios hold on any machine. docs/benchmarks.md.

#include "renderer/engine.hpp"
#include "renderer/scene/bake_file.hpp"

#include <map>
#include <string>

namespace atrium::app {

/// GPU times of the device's floors by name: floor.t16, floor.gbuffer, floor.lighting, and where they apply
/// floor.ao_taps, floor.shadow_taps. One run, timers serialized.
[[nodiscard]] std::map<std::string, double> run_device_floors(Engine& engine, const FrameRequest& request);

/// Where the bulk sections (vertices, indices, texels, which follow each other) lie in a bake's file.
struct BulkRange {
    std::uint64_t offset = 0, size = 0;
};
[[nodiscard]] BulkRange bulk_range(const BakeFile& bake);

/// floor.copy: maps the bake and copies its bulk sections once into memory that was never touched. ms.
[[nodiscard]] double run_copy_floor(const std::filesystem::path& bake, const BulkRange& bulk);

} // namespace atrium::app
