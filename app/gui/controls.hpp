#pragma once
// What the tabs share: text, buttons, lists.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace atrium::gui {

/// Text that is broken at the panel's edge.
void wrapped(const std::string& text);

/// 1234567 as 1 234 567.
[[nodiscard]] std::string grouped(std::uint64_t number);

/// Of the item before, while the mouse is on it.
void tooltip(const char* text);

/// A button beside the one before, or under it where the line is full.
bool flowing_button(const char* label, bool first);

/// A line to be clicked, which then answers true. What is too long is cut, and whole in its tooltip.
bool list_line(const std::string& text, bool selected);

/// A box as high as its lines, up to eight, of which one can be selected; `none` stands in it where there are none.
/// True when a line was clicked.
bool draw_list(const char* id, const std::vector<std::string>& lines, std::optional<std::size_t>& selected,
               const char* none);

} // namespace atrium::gui
