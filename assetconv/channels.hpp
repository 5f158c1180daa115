#pragma once
// One number out of a texel, as -imfchan asks.

#include "assetconv/source_image.hpp"

namespace atrium {

/// r g b: that channel; m: matte, the alpha; l, z and anything else: luminance.
[[nodiscard]] inline float scalar_channel(const SourceImage& image, int x, int y, char channel)
{
    switch (channel) {
    case 'r':
        return image.rgb(x, y).x;
    case 'g':
        return image.rgb(x, y).y;
    case 'b':
        return image.rgb(x, y).z;
    case 'm':
        return image.alpha(x, y);
    default:
        return image.luminance(x, y);
    }
}

} // namespace atrium
