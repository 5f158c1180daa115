#pragma once
// Counts what the window tells of its scene.

#include "app/gui/scene_facts.hpp"
#include "renderer/engine.hpp"

namespace atrium::app {

/// Of a scene that is loaded as described, whose bakes are still mapped.
[[nodiscard]] gui::SceneFacts gather_facts(const SceneDescription& description, const GpuScene& scene, double load_ms);

} // namespace atrium::app
