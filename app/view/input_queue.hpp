#pragma once
// What keyboard and mouse did, in order, portioned for an interface that looks once a frame.

#include "renderer/core/math.hpp"

#include <deque>
#include <variant>
#include <vector>

namespace atrium::app {

inline constexpr vec2 mouse_outside{-1e6f}; ///< where no widget is

struct MouseMove {
    vec2 at; ///< in the window's pixels; mouse_outside where the mouse has left it
};
struct MouseButton {
    int button;
    bool down;
};
struct MouseWheel {
    vec2 by;
};
struct KeyChange {
    int key, scancode, action, mods; ///< as GLFW has them
};
struct TextInput {
    unsigned character; ///< Unicode
};
using InputEvent = std::variant<MouseMove, MouseButton, MouseWheel, KeyChange, TextInput>;

/// Dear ImGui 1.86 knows keys and buttons by their state at each frame: what goes down and up within a slow frame never
/// was, and a click happens where the mouse is by then. So a frame is given no more than it can tell apart.
class InputQueue {
public:
    void push(const InputEvent& event) { events_.push_back(event); }
    [[nodiscard]] bool empty() const { return events_.empty(); }
    /// The events of the next frame: up to one that would hide another of them, or change what it was about.
    [[nodiscard]] std::vector<InputEvent> take_frame();

private:
    std::deque<InputEvent> events_;
};

} // namespace atrium::app
