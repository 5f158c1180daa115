#pragma once
// Alpha of the coarser mip levels of a mask, so that its solid area is the same at any distance.

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace atrium {

/// How a mask is tested and read.
struct MaskTest {
    float cutoff = 0.5f; ///< texture alpha below this is a hole
    bool clamp = false;  ///< the sampler clamps to the edge; else it repeats
};

/// One channel of a level, row 0 at the top.
template <class Value>
struct MaskLevel {
    int width = 0, height = 0;
    std::vector<Value> alpha;
};

/// Share of the plane, 0 to 1, where `level`, filtered bilinearly as a sampler does between texel centres, is at or
/// above the cutoff: an area, not a count of texels. Exact but for rounding along rows, by Gauss's rule across them.
[[nodiscard]] double covered_area(const MaskLevel<std::uint8_t>& level, const MaskTest& test);

/// Alpha codes of a coarser level whose covered area is `wanted` (within mask_area_tolerance), made of the area average
/// `mean` (0 to 1) by one contrast and one offset, clamped to 0..255. The contrast restores the spread that averaging
/// removed: `deviation` is the standard deviation of the finest level's alpha. Nothing if no offset gives the area: the
/// mask is flat at this size. Source: Castaño 2010, "Computing Alpha Mipmaps", which scales alpha and counts texel
/// centres; hard masks are then exactly at the cutoff there, and below it between them.
[[nodiscard]] std::optional<MaskLevel<std::uint8_t>> fit_mask(const MaskLevel<float>& mean, const MaskTest& test,
                                                              double wanted, double deviation);

/// Whether blends of two levels, as a trilinear sampler makes them, also cover `wanted` within mixed_area_tolerance:
/// tested at blend factors of 1/4, 1/2 and 3/4, by counting points.
[[nodiscard]] bool mix_well(const MaskLevel<std::uint8_t>& fine, const MaskLevel<std::uint8_t>& coarse,
                            const MaskTest& test, double wanted);

/// Accepted errors of the covered area, in one level and between two levels, relative to the smaller one of the solid
/// and the open share.
inline constexpr double mask_area_tolerance = 0.03, mixed_area_tolerance = 0.1;

/// Standard deviation of the values.
[[nodiscard]] double deviation_of(std::span<const float> alpha);

} // namespace atrium
