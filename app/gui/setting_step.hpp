#pragma once
// Settings changed by single presses of keys.

#include "renderer/core/setting.hpp"

#include <string>
#include <vector>

namespace atrium::gui {

/// One change that a key can make.
struct SettingStep {
    std::string name;    ///< in a file of keys: the setting's key, with ".more" or ".less" behind that of a number
    std::string setting; ///< its key
    bool less = false;
    std::string key; ///< by default, from the description; empty: none
    std::string help;
};

/// Of every setting what its type allows: a switch goes on and off, a choice to its next value (or between the two that
/// the description names), a number up and down. Text and vectors have none.
[[nodiscard]] std::vector<SettingStep> setting_steps(const SettingList& list);

/// A number changes by a tenth of itself (from 0, to a hundredth of its range), or where its range begins below 0 by a
/// twentieth of that; a whole one by 1 at least. It stays in its range.
void take_step(const SettingList& list, const SettingStep& step);

} // namespace atrium::gui
