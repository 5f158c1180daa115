#pragma once
// What one frame saw, for the next one to begin with.

#include "renderer/techniques/culling/culling.hpp"

namespace atrium {

/// Declares the buffers of visible triangles: those of this frame, to be written, and those of the view's last frame.
/// They belong to one scene: call graph::Runner::forget() when the scene changes. Source: Haar & Aaltonen 2015,
/// "GPU-Driven Rendering Pipelines", there with clusters.
[[nodiscard]] SeenInFrame declare_seen(graph::Graph& g, const DrawTasks& tasks);

} // namespace atrium
