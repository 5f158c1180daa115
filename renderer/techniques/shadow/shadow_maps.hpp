#pragma once
// The maps themselves: drawn by the passes `shadow.L`, kept from frame to frame.

#include "renderer/scene/light_set.hpp"
#include "renderer/scene/view.hpp"
#include "renderer/techniques/culling/culling.hpp"
#include "renderer/techniques/gbuffer/gbuffer.hpp"
#include "renderer/techniques/shadow/shadow.hpp"

namespace atrium {

/// What shadow maps of a frame are drawn from.
struct ShadowCasters {
    DrawTasks tasks;
    Geometry geometry;
    Bounds bounds;
    vec2 texture_state{0}; ///< changes when textures are read differently, and so the holes of masks
};

/// The shadow maps of a scene's lights. The graph keeps them from frame to frame: call graph::Runner::forget() when the
/// scene changes.
class ShadowMaps {
public:
    explicit ShadowMaps(const gpu::Device& device) : device_(device) {}

    /// Brings the maps of the lights that cast shadows into a frame's graph, which must run before the next call. Draws
    /// those faces that are not as they were drawn last: passes `shadow.L.cull`, `shadow.L`, `shadow.L.ranges.N`.
    [[nodiscard]] ShadowMapSet add(graph::Graph& g, const ShadowCasters& casters, const LightSet& lights,
                                   const View& view, const ShadowSettings& s);
    /// Visibility as the mean of hard shadows from many points of each light of the set: a map for each, drawn and
    /// looked at in turn. Passes `shadow.L.reference`, `visibility.L`.
    [[nodiscard]] graph::Tex add_reference(graph::Graph& g, graph::Tex depth, graph::Tex normal,
                                           const ShadowCasters& casters, const LightSet& lights, const View& view,
                                           const ShadowMapSet& set, const ShadowSettings& s);

private:
    void tell(const std::string& text);
    void make_samples(const ShadowSettings& s);

    const gpu::Device& device_;
    std::vector<vec4> disc_samples_, square_samples_;
    std::array<std::uint32_t, 2> sample_counts_{}; ///< as set, of those samples
    std::string told_; ///< what was said last of maps that are smaller or fewer than asked for
};

} // namespace atrium
