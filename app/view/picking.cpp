#include "app/view/picking.hpp"

namespace atrium::app {

std::optional<std::size_t> material_at(Engine& engine, FrameRequest frame, uvec2 pixel)
{
    frame.want_picture = frame.want_hdr = false;
    frame.settings.debug = {};
    frame.aovs = {parse_aov("material", frame.lights)};
    const ImageF materials = engine.render(frame).aovs.front();
    const uvec2 inside = glm::min(pixel, frame.size - 1u);
    const float material = *materials.at(static_cast<int>(inside.x), static_cast<int>(inside.y));
    return material < 0 ? std::nullopt : std::optional(static_cast<std::size_t>(material));
}

} // namespace atrium::app
