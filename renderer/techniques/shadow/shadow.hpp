#pragma once
// Shadows: settings, and visibility of lights from their shadow maps. README.md beside this file.

#include "renderer/core/setting.hpp"
#include "renderer/graph/graph.hpp"
#include "renderer/scene/light.hpp"
#include "renderer/techniques/shadow/shadow_faces.hpp"

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace atrium {

enum class ShadowFilter : std::uint8_t { off, hard, pcf, pcss, reference };
constexpr auto enum_names(ShadowFilter)
{
    return std::array{"off", "hard", "pcf", "pcss", "reference"};
}

struct ShadowSettings {
    ShadowFilter filter = ShadowFilter::pcss;
    int resolution = 2048;
    int samples = 32;
    int blocker_samples = 16;
    bool blur = true;
    float softness = 1;
    float radius = 2;
    float bias_normal = 0.1f;
    float bias_slope = 0.1f;
    bool bias_plane = true;
    int cascades = 4;
    bool cache = true;
    int max_lights = 4;
    int budget = 512;
    int reference_points = 256;
};

template <class V>
void describe(V& v, ShadowSettings& s)
{
    v.group("shadow", "Shadows");
    v("filter", s.filter,
      "Off, one hard edge, a disc of one size (pcf), as wide as the light makes them (pcss), or the mean of hard "
      "shadows from many points of the light",
      Keys{"P", "", "pcss", "hard"});
    v("resolution", s.resolution, "Side of a light's map; of each cascade and each side of a cube", Range{64, 4096},
      "texels", Cpu{1024});
    v("samples", s.samples, "Comparisons at each pixel, pcf and pcss", Range{4, 64}, "", Cpu{24});
    v("blocker_samples", s.blocker_samples, "pcss: texels read at each pixel to find what blocks", Range{4, 64}, "",
      Cpu{12});
    v("blur", s.blur,
      "pcss: where a penumbra is wide in the picture, do with two thirds of the comparisons and take the noise out "
      "with 4 x 4 pixels; where it is narrow, take more");
    v("softness", s.softness, "pcss and reference: multiplies the size of every light", Range{0, 10}, "",
      Keys{"Page up", "Page down"});
    v("radius", s.radius, "pcf: of the disc", Range{0, 64}, "texels");
    v("bias_normal", s.bias_normal, "Moves the shaded point off its surface", Range{0, 8}, "texels");
    v("bias_slope", s.bias_slope, "Moves it towards the light, by what its surface's slope rises in so many texels",
      Range{0, 8}, "texels");
    v("bias_plane", s.bias_plane,
      "Compares with the surface's plane around the shaded point, not with its depth alone");
    v("cascades", s.cascades, "Maps of a sun, from near to far", Range{1, 6}, "");
    v("cache", s.cache, "Keep maps of lights that did not move");
    v("max_lights", s.max_lights, "Lights that cast shadows, the first ones", Range{0, 16}, "");
    v("budget", s.budget, "Memory for maps; beyond it all get a smaller resolution", Range{1, 16384}, "MiB");
    v("reference_points", s.reference_points, "reference: points of each light; fewer where many lights share a frame",
      Range{1, 1024}, "");
}

/// How many lights may cast shadows, for make_light_set().
[[nodiscard]] std::size_t most_shadowed_lights(const ShadowSettings& s);

/// A light's shadow map in a frame's graph.
struct ShadowMap {
    std::uint32_t light = 0; ///< by its index in the LightSet
    graph::Tex map;          ///< D32, tiles side by side
    graph::Buf ranges;       ///< nearest and farthest depth under cells of texels
    std::uint32_t side = 0, cells = 0;
    std::uint32_t first_face = 0, face_count = 0;
    bool perspective = true;
    float depth_scale = 0, near = 0, scale = 0; ///< LightFaces
};

/// All of a frame's.
struct ShadowMapSet {
    std::vector<ShadowMap> maps;
    graph::Buf faces;                        ///< ShadowFace of all maps
    graph::Buf disc_samples, square_samples; ///< sets of samples: shared::set_…
};

/// What is looked at of a light's shadows: shared::show_….
using ShadowShown = std::uint32_t;

/// Where a pass of visibility draws.
struct VisibilityTarget {
    std::string pass;
    graph::Tex image; ///< R32F
    std::uint32_t layer = 0;
    graph::Load load = graph::Load::discard; ///< else added to, times `weight`
    float weight = 1;
    std::optional<vec3> centre; ///< m, world: of the light that this one is a point of; it reaches as far
    bool blurred = false;       ///< written for a blur: 2 shared::blur_… are added
    bool beyond_scene = false;  ///< ShadowReceivers
};

/// The surfaces for which visibility is computed.
struct ShadowReceivers {
    std::string prefix;        ///< put before the names of passes and images
    bool beyond_scene = false; ///< they may be farther from a sun than all shadow casters
};

/// Reads  depth and geometric normals (lib/depth_normal.glsl), one map.  Writes  a layer of the target.
void add_visibility(graph::Graph& g, graph::Tex depth, graph::Tex normal, const ShadowMapSet& set, const ShadowMap& map,
                    const Light& light, const ShadowSettings& s, ShadowShown shown, const VisibilityTarget& target);

/// An image (R32F) of the depth's size, with one layer per light.
[[nodiscard]] graph::Tex create_visibility(graph::Graph& g, graph::Tex depth, std::size_t lights,
                                           const std::string& name = "visibility");

/// Visibility of every light of the set: layer i of the image is that of maps[i]. Passes
/// `visibility.L`, `visibility.L.blur`. Graph::constant_array(1) where the set is empty.
[[nodiscard]] graph::Tex add_all_visibility(graph::Graph& g, graph::Tex depth, graph::Tex normal,
                                            const ShadowMapSet& set, std::span<const Light> lights,
                                            const ShadowSettings& s, const ShadowReceivers& receivers = {});

/// What can be looked at of a light's shadows, as an image (R32F): the map as distances along its faces' axes, m (the
/// map's size); its layer of visibility; or what the filter found. Empty where the light, by user's index, casts none.
[[nodiscard]] graph::Tex add_shadow_image(graph::Graph& g, graph::Tex depth, graph::Tex normal, const ShadowMapSet& set,
                                          std::span<const Light> lights, graph::Tex visibility, const ShadowSettings& s,
                                          std::uint32_t light, ShadowShown shown, const std::string& pass);

} // namespace atrium
