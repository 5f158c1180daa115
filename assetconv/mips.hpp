#pragma once
// Mip chains, each kind of texture averaged in the space where averages mean something.

#include "assetconv/mask_mips.hpp"
#include "assetconv/texture_recipe.hpp"

namespace atrium {

/// How texels are averaged.
enum class MipSpace : std::uint8_t {
    srgb_color, ///< rgb in linear light; alpha as it is
    data,       ///< as they are
    normals,    ///< two channels: as unit vectors, renormalised
};

struct MipLevel {
    std::uint32_t width = 0, height = 0;
    std::vector<std::uint8_t> texels;
};

/// The whole chain down to 1 x 1. Each level is the exact area average of the one before, at odd sizes too. With a
/// `mask` (four channels) the alpha of every level covers the same area as the finest one (fit_mask), and the chain
/// ends before the size at which the mask is too flat to keep its area. Levels whose larger side exceeds `max_size` are
/// left out, but one is always kept.
[[nodiscard]] std::vector<MipLevel> build_mips(const PackedImage& image, MipSpace space,
                                               const std::optional<MaskTest>& mask, std::uint32_t max_size);

} // namespace atrium
