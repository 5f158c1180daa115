#pragma once
// A camera path drawn over the picture.

#include "app/gui/projection.hpp"
#include "renderer/scene/camera_path.hpp"

#include <cstddef>
#include <optional>

namespace atrium::gui {

/// Under all windows: the eye's curve as a line, a dot for each key with a short line to where it looks, the selected
/// one bright. `scale`: of a pixel.
void draw_path(const CameraPath& path, std::optional<std::size_t> selected, const Projection& view, float scale);

} // namespace atrium::gui
