#pragma once
// The window's loop: events, flying, the interface, and the frames that are drawn when something changed.

#include "app/gui/fly_camera.hpp"
#include "app/gui/panels.hpp"
#include "app/gui/view_model.hpp"
#include "app/view/gui.hpp"

#include <optional>
#include <string>

namespace atrium::app {

/// At which size to draw while something moves, so that it stays fluent. Time goes with the number of pixels, beyond a
/// part that does not.
class MovingScale {
public:
    /// A frame of `share` of the window along each side took so long.
    void measured(float share, double ms);
    /// 0.2 to 1, in steps coarse enough not to make new images for every frame.
    [[nodiscard]] float choose(double goal_ms) const;

private:
    double full_ms_ = 0;
};

class Viewer {
public:
    Viewer(Window& window, Engine& engine, const FrameRequest& start, const std::string& scene, bool continuous);
    /// Until the window is closed.
    void run();
    [[nodiscard]] const Camera& camera() const { return model_.camera; }

private:
    [[nodiscard]] bool fly(double seconds);
    /// The selected light follows the mouse: in the view's plane, or (`along`) nearer and farther.
    void drag_light(vec2 pixels, bool along);
    void handle_keys(uvec2 pixels);
    void draw_interface(uvec2 pixels);
    /// What the model says, drawn as `render` draws it, into the present folder, with its description.
    void write_screenshot(uvec2 pixels);
    /// The buffers to show beside the picture, in a window of so many pixels; none while the interface is hidden.
    [[nodiscard]] Insets wanted_insets(uvec2 pixels) const;
    /// A request for what is to be shown now, at that size.
    [[nodiscard]] FrameRequest wanted_frame(uvec2 size) const;
    /// Draws the scene if what it shows is not what is wanted.
    void draw_scene(uvec2 pixels, bool moving);
    [[nodiscard]] std::string state_text(uvec2 pixels) const;
    void tell(const FrameResult& frame);

    Window& window_;
    Engine& engine_;
    Gui gui_;
    gui::ViewModel model_;
    gui::PanelState panels_;
    gui::FrameFacts facts_;
    gui::FlyCamera flight_;
    FrameRequest request_;
    MovingScale moving_scale_;
    bool continuous_, show_gui_ = true;
    std::string drawn_;     ///< state_text() of the picture that is kept
    float drawn_share_ = 0; ///< of the window's pixels along each side
    uvec2 drawn_pixels_{0};
    std::optional<vec2> drag_from_;
};

} // namespace atrium::app
