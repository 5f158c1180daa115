#pragma once
// Widgets made from the description of a setting alone: a setting that is added needs no line here.

#include "renderer/core/setting.hpp"

#include <string>
#include <string_view>

namespace atrium::gui {

/// One line in the present ImGui window, or two where the value wants room: label, widget, and a button back to the
/// default where it differs. A checkbox for bool, a slider for numbers with a range (logarithmic over more than three
/// decades), a drag for those without, a colour or three drags for vec3, a combo for enums and text that has values to
/// choose from, a field for other text. What is typed is brought into the range. True when the field was changed.
bool draw_setting(const Setting& setting, bool is_cpu);

/// What to do with the headings of draw_settings(), in this frame.
enum class Headings { as_they_are, open, close };

struct DrawnSettings {
    int count = 0; ///< settings that had their widget
    bool changed = false;
};

/// A heading per group with the widgets of its settings; of those only that match `filter`, all open, where there is
/// one.
DrawnSettings draw_settings(const SettingList& list, std::string_view filter, bool is_cpu,
                            Headings headings = Headings::as_they_are);

// What the widgets are made of.

/// Each word of `filter` stands in the text. Case does not count.
[[nodiscard]] bool contains_words(std::string_view text, std::string_view filter);
/// Each word of `filter` stands in the key, with blanks for underscores or not, in the heading or in the help. Case
/// does not count.
[[nodiscard]] bool matches_filter(const Setting& setting, std::string_view filter);
/// The last part of the key, blanks for underscores.
[[nodiscard]] std::string label_of(const Setting& setting);
/// Help, key, range, values, default.
[[nodiscard]] std::string tooltip_of(const Setting& setting, bool is_cpu);
/// A vec3 that is a colour: its key says so, or its unit is that of radiance.
[[nodiscard]] bool is_color(const Setting& setting);
[[nodiscard]] bool is_logarithmic(const Range& range);
[[nodiscard]] const std::string& default_of(const Setting& setting, bool is_cpu);

} // namespace atrium::gui
