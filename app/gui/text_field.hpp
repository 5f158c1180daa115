#pragma once
// A text field whose text counts once it is complete: half a name is no name.

#include <string>

namespace atrium::gui {

/// True when the field was left, or Enter pressed, with another text than `value`, which is then the new one. Escape
/// leaves it as it was.
bool draw_text_field(const char* label, std::string& value);

} // namespace atrium::gui
