#pragma once
// What the scene is made of, as a section of the tab of costs.

#include "app/gui/scene_facts.hpp"

#include <cstddef>

namespace atrium::gui {

/// A heading, and under it a line for each number once it is opened.
void draw_scene_statistics(const SceneFacts& facts, std::size_t lights);

} // namespace atrium::gui
