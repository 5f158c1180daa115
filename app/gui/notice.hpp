#pragma once
// A note over the picture, which stays while its reason does.

#include <string>

namespace atrium::gui {

enum class Corner { top_right, bottom_right };

/// Beside the panels where there is room. With `button`, there is one of that label; returns whether it was pressed.
bool draw_notice(Corner corner, const std::string& text, const char* button, float scale);

} // namespace atrium::gui
