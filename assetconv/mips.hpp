#pragma once
// Mip chains, each kind of texture averaged in the space where averages mean something.

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

/// The whole chain down to 1 x 1. Each level is the exact area average of the one before, at odd sizes too. With
/// `keep_coverage` (four channels) every level has as large a share of texels at or above mask_code as level 0, to the
/// nearest texel: alpha is scaled (Castaño 2010, "Computing Alpha Mipmaps") and ties at the cutoff are broken by the
/// neighbourhood. Levels whose larger side exceeds `max_size` are left out, the last never.
[[nodiscard]] std::vector<MipLevel> build_mips(const PackedImage& image, MipSpace space, bool keep_coverage,
                                               std::uint32_t max_size);

/// Share of texels at or above mask_code in the fourth channel.
[[nodiscard]] double mask_coverage(std::span<const std::uint8_t> rgba);

} // namespace atrium
