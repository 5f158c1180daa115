#pragma once
// What a bump or normal map holds, told from its texels: MTL files do not say.

#include "assetconv/source_image.hpp"

#include <optional>
#include <vector>

namespace atrium {

enum class BumpContent : std::uint8_t {
    normals, ///< a tangent-space normal map
    height,  ///< grey
    colour,  ///< a picture; its luminance has to do as height
};

/// Normals: blue mean above .6, red and green about .5, length about 1 on more than 90 % of the texels. Black texels
/// (outside of the islands) do not count.
[[nodiscard]] BumpContent classify_bump(const SourceImage& image);

/// Normals of one map as the texels have them: x right, y as green says, z out of the surface. Texels that hold no
/// direction (black, or facing inwards) are flat, and marked.
struct NormalField {
    int width = 0, height = 0;
    std::vector<vec3> normals; ///< unit
    std::vector<bool> valid;
};
[[nodiscard]] NormalField read_normals(const SourceImage& image);

enum class GreenAxis : std::uint8_t { up, down };

/// Which way green points, from the rule that a height field has no curl: with p = -x/z and q = +-y/z the right sign
/// makes dp/dy = dq/dx. nullopt when the two signs differ by less than `green_decision`.
[[nodiscard]] std::optional<GreenAxis> green_axis_by_curl(const NormalField& field);
inline constexpr double green_decision = 0.2;

/// The second opinion: the height that the slopes integrate to goes with the brightness of the colour map, since
/// hollows are dark. nullopt when neither sign correlates better by a clear margin.
[[nodiscard]] std::optional<GreenAxis> green_axis_by_colour(const NormalField& field, const SourceImage& colour);

/// Unit normals (green up) of a height image: n = normalize(-s dh/dx, +s dh/dy, 1) with y down and Sobel slopes per
/// texel. `strength` (-bm) 1 makes white 1/bump_texels of the image's width higher than black, whatever its resolution.
[[nodiscard]] std::vector<vec3> normals_from_height(const SourceImage& image, char channel, float strength, bool clamp);
inline constexpr float bump_texels = 128.0f;

} // namespace atrium
