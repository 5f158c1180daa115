#pragma once
// What keys do.

#include "app/gui/panels.hpp"
#include "app/view/window.hpp"
#include "renderer/core/setting.hpp"

namespace atrium::app {

enum class Action : std::uint8_t {
    none,
    gui,
    full_screen,
    screenshot,
    undo,
    redo,
    soft_shadows,
    softer,
    harder,
    ao_method,
    normal_mapping,
    previous_buffer,
    next_buffer
};

[[nodiscard]] Action action_of(const KeyPress& press);

/// For the help panel: keys and what they do.
[[nodiscard]] std::vector<gui::KeyHelp> key_table();

/// Does to settings what the action's key says: to the next value, on and off, or up and down by a tenth.
void step_setting(const SettingList& list, Action action);

} // namespace atrium::app
