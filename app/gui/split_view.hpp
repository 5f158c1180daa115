#pragma once
// Two settings side by side: a divider in the view, and what the two differ in.

#include "app/gui/panels.hpp"

#include <string>
#include <vector>

namespace atrium::gui {

/// Each setting whose values differ as "key: first | second", in order of description.
[[nodiscard]] std::vector<std::string> differences(const Settings& first, const Settings& second);

/// Buttons that split the view, exchange its sides, or make one picture of it again.
void draw_split_controls(ViewModel& model, float scale);

/// In a split view: the line between both sides, which the mouse can drag, and what stands at each and takes how long.
void draw_divider(ViewModel& model, const FrameFacts& facts, float scale);

} // namespace atrium::gui
