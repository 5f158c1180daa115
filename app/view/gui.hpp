#pragma once
// Dear ImGui between the window and the engine: events in, triangles out.

#include "app/view/window.hpp"
#include "renderer/engine.hpp"

namespace atrium::app {

class Gui {
public:
    Gui(const Window& window, Engine& engine);
    ~Gui();
    Gui(const Gui&) = delete;
    Gui& operator=(const Gui&) = delete;

    /// Begins a frame of the interface, over the engine's picture, for a window of so many pixels.
    void begin(uvec2 pixels);
    /// Ends it.
    [[nodiscard]] UiDraws end();

    /// What ImGui calls the image of insets.
    [[nodiscard]] static void* insets();
    [[nodiscard]] float scale() const { return scale_; }

private:
    void set_scale(float scale);
    const Window& window_;
    Engine& engine_;
    float scale_ = 0;
};

} // namespace atrium::app
