#pragma once
// What keys can do, beside changing settings.

#include "app/view/window.hpp"

#include <span>

namespace atrium::app {

enum class Action : std::uint8_t {
    none,
    // As long as the key is held.
    forward,
    left,
    back,
    right,
    down,
    up,
    turn_left,
    turn_right,
    turn_up,
    turn_down,
    // Once, when it goes down.
    previous_buffer,
    next_buffer,
    frame,
    light_view,
    compare,
    open,
    gui,
    help,
    graph,
    shaders,
    full_screen,
    screenshot,
    undo,
    redo
};

[[nodiscard]] constexpr bool is_held(Action action)
{
    return action >= Action::forward && action <= Action::turn_down;
}

struct ActionInfo {
    Action action;
    const char* name; ///< in a file of keys
    KeyPress key;     ///< by default
    const char* help;
};

/// All but `none`, in the order of the help.
[[nodiscard]] std::span<const ActionInfo> all_actions();

} // namespace atrium::app
