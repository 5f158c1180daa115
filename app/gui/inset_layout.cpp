#include "app/gui/inset_layout.hpp"

#include "app/gui/panels.hpp"

#include <algorithm>

namespace atrium::gui {
namespace {

// Pixels at scale 1.
constexpr float margin = 8, padding = 10, line = 20;
constexpr float widest = 200, narrowest_legend = 150, narrowest = 56;
constexpr float reserved = 140; ///< at the top, for the legend of the buffer in place of the picture

struct Space {
    vec2 size;
    float aspect; ///< height by width of an image
};

vec2 step_of(float width, const Space& space)
{
    const float lines = width >= narrowest_legend ? 4 : 1; // the name; with a legend three more
    return {width + 2 * padding + margin, width * space.aspect + lines * line + 2 * padding + margin};
}

/// The width at which so many columns fill the space, or 0 where the rows do not fit.
float width_in(const Space& space, std::size_t columns, std::size_t count)
{
    const float width = std::min(widest, space.size.x / static_cast<float>(columns) - 2 * padding - margin);
    const std::size_t rows = (count + columns - 1) / columns;
    return static_cast<float>(rows) * step_of(width, space).y <= space.size.y ? width : 0;
}

} // namespace

InsetLayout lay_out_insets(uvec2 window, float scale, std::size_t count)
{
    const vec2 size = vec2(window) / scale;
    const float left = std::min(panel_end, std::max(size.x - step_of(narrowest, {}).x, 0.0f));
    const Space space{{size.x - left, size.y - reserved}, std::min(size.y / std::max(size.x, 1.0f), 1.0f)};
    InsetLayout out;
    float width = narrowest;
    out.columns = std::max<std::size_t>(static_cast<std::size_t>(space.size.x / step_of(narrowest, space).x), 1);
    for (std::size_t columns = 1; columns <= count; ++columns) {
        const float fitting = width_in(space, columns, count);
        if (fitting < width) continue; // of equals the one with fewer rows
        width = fitting;
        out.columns = columns;
    }
    out.image = glm::max(uvec2(scale * vec2(width, width * space.aspect)), uvec2(1));
    out.step = uvec2(scale * step_of(width, space));
    out.origin = uvec2(scale * vec2(left, size.y - margin));
    out.with_legend = width >= narrowest_legend;
    return out;
}

} // namespace atrium::gui
