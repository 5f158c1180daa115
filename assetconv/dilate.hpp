#pragma once
// Colour for the texels that a mask hides.

#include "assetconv/texture_recipe.hpp"

namespace atrium {

/// Gives texels of alpha below `visible_code` the colour of the visible ones around them, so that filtering across the
/// mask's edge does not mix in the background. Four-channel images; alpha stays. Pull-push as in Gortler et al. 1996,
/// "The Lumigraph".
void dilate_color(PackedImage& image, int visible_code);

} // namespace atrium
