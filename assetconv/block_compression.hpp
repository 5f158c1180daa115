#pragma once
// BC1, BC3 and BC5 blocks, for --textures bc: plain encoders, good enough for a choice that saves space.

#include "assetconv/mips.hpp"

namespace atrium {

/// Encodes one level into 4 x 4 blocks, rows of blocks from the top; texels beyond the edge repeat the last ones.
/// Formats: bc1_srgb, bc3_srgb, bc3_unorm from four channels; bc5_unorm from two. Colours: principal axis end points,
/// then one least-squares step (van Waveren 2006, "Real-Time DXT Compression", follows the same path); alpha: the
/// block's range.
[[nodiscard]] std::vector<std::uint8_t> compress_level(const MipLevel& level, TextureFormat format);

} // namespace atrium
