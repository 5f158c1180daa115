#pragma once
// Dear ImGui between the window and the engine: events in, triangles out.

#include "app/view/window.hpp"
#include "renderer/engine.hpp"

#include <bitset>
#include <vector>

namespace atrium::app {

class Gui {
public:
    Gui(Window& window, Engine& engine);
    ~Gui();
    Gui(const Gui&) = delete;
    Gui& operator=(const Gui&) = delete;

    /// Begins a frame of the interface, over the engine's picture, for a window of so many pixels. Gives it the input
    /// that one frame can take, and returns the keys that went down.
    [[nodiscard]] std::vector<KeyPress> begin(uvec2 pixels);
    /// Ends it.
    [[nodiscard]] UiDraws end();

    /// What ImGui calls the image of insets.
    [[nodiscard]] static void* insets();
    [[nodiscard]] float scale() const { return scale_; }

private:
    void set_scale(float scale);
    [[nodiscard]] std::vector<KeyPress> take_input();
    Window& window_;
    Engine& engine_;
    float scale_ = 0;
    vec2 mouse_ = mouse_outside;
    std::bitset<8> buttons_; ///< that are down; GLFW knows as many
};

} // namespace atrium::app
