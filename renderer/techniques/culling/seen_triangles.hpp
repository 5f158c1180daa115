#pragma once
// What one frame saw, for the next one to begin with.

#include "renderer/techniques/culling/culling.hpp"

namespace atrium {

/// Declares the triangles that this frame of the view sees, and brings what its last one saw. They belong to one scene:
/// graph::Runner::forget() when it changes. Source: Haar & Aaltonen 2015, "GPU-Driven Rendering Pipelines", who
/// remember clusters.
[[nodiscard]] SeenInFrame declare_seen(graph::Graph& g, const DrawTasks& tasks);

} // namespace atrium
