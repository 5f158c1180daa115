#pragma once
// Enlarges a finished picture: FSR 1, or plain filters to compare it with. See README.md in this folder.

#include "renderer/graph/graph.hpp"

#include <array>
#include <optional>

namespace atrium {

enum class UpscaleMethod : std::uint8_t { off, bilinear, catmullrom, lanczos, fsr1 };
constexpr auto enum_names(UpscaleMethod)
{
    return std::array{"off", "bilinear", "catmullrom", "lanczos", "fsr1"};
}

/// Reads  a picture encoded for display (RGBA8 unorm, 0 to 1).  Writes  it at another size, the same format: pass
/// `upscale`. Both axes have their own ratio. With `off` or at the same size it returns the picture.
[[nodiscard]] graph::Tex add_upscale(graph::Graph& g, graph::Tex picture, uvec2 size, UpscaleMethod method);

/// Reads  a picture encoded for display.  Writes  it sharpened (RCAS): pass `upscale.sharpen`. `stops`: 0 sharpens
/// most, each further one half as much.
[[nodiscard]] graph::Tex add_sharpening(graph::Graph& g, graph::Tex picture, float stops);

} // namespace atrium
