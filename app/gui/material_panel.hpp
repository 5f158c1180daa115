#pragma once
// The tab of materials: which there are, and the keys of the selected one.

#include "app/gui/scene_facts.hpp"
#include "app/gui/view_model.hpp"

#include <string>

namespace atrium::gui {

/// What the tab remembers between frames.
struct MaterialTab {
    std::string filter;  ///< of the names
    bool scroll = false; ///< to the selected one, in the next frame
    bool open = false;   ///< as of the last frame: clicks in the scene then select materials
};

void draw_material_tab(ViewModel& model, const SceneFacts& facts, MaterialTab& tab, bool is_cpu);

} // namespace atrium::gui
