#pragma once
// Counts what the window tells of its scene.

#include "app/gui/scene_facts.hpp"
#include "renderer/engine.hpp"

namespace atrium::app {

/// Of a scene that is loaded as described, whose bakes are still mapped.
[[nodiscard]] gui::SceneFacts gather_facts(const SceneDescription& description, const GpuScene& scene, double load_ms);

/// Where the engine keeps the materials' textures: to be asked again when it has loaded the scene once more.
void find_images(gui::SceneFacts& facts, const GpuScene& scene);

} // namespace atrium::app
