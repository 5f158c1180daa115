#pragma once
// Handles over the picture: lights are selected, moved, aimed and sized where they stand.

#include "app/gui/projection.hpp"
#include "app/gui/view_model.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace atrium::gui {

/// What a handle changes of its light.
enum class HandleKind {
    place,   ///< in the view's plane
    along_x, ///< the place, along an axis of the world
    along_y,
    along_z,
    aim,   ///< the direction
    outer, ///< a spot's angles
    inner,
    extent,    ///< a sphere's radius; a rectangle's width
    extent_up, ///< a rectangle's height
};

struct Handle {
    HandleKind kind = HandleKind::place;
    vec3 from{0}; ///< m: a line leads from here
    vec3 at{0};   ///< m: to where it is taken
};

/// Those of a light, at lengths that look alike from everywhere. A sun's stand before the camera. `scale`: of a pixel.
[[nodiscard]] std::vector<Handle> handles_of(const Light& light, const Projection& view, float scale);

/// The light after its handle was dragged by so many pixels; not checked.
[[nodiscard]] Light dragged(const Light& light, const Handle& handle, const Projection& view, vec2 pixels);

class LightHandles {
public:
    /// Draws a mark for each light and the handles of the selected one under all windows, and follows the mouse: a
    /// click on a mark selects, handles are dragged. What the rules of lights refuse is not done. True while the mouse
    /// is on or holds something of it, and so does not mean the view.
    bool update(ViewModel& model, float scale);
    [[nodiscard]] bool holds() const { return held_.has_value(); }

private:
    /// The held handle goes with the mouse, until the button is let go or its light is no more.
    void follow(ViewModel& model, const Projection& view, vec2 mouse);
    struct Held {
        Light light; ///< as it was when it was taken
        Handle handle;
        vec2 mouse{0};
    };
    std::optional<Held> held_;
};

} // namespace atrium::gui
