#pragma once
// How the window's widgets look: warm stone greys and one terracotta accent.

namespace atrium::gui {

/// Sizes, times `scale`, and colours of the present ImGui context. Can be called again, with another scale.
void apply_style(float scale);

/// Puts the font into the context's atlas in place of what is there: DejaVu Sans where it is installed, else ImGui's
/// own. Before the atlas is uploaded.
void load_font(float scale);

} // namespace atrium::gui
