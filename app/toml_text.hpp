#pragma once
// Settings written as TOML that reads back the same.

#include "renderer/core/setting.hpp"

#include <string>
#include <string_view>

namespace atrium::app {

/// A TOML basic string, with its quotes.
[[nodiscard]] std::string toml_string(std::string_view text);

/// The table [settings] with every setting that differs from its default, in order of description.
[[nodiscard]] std::string differing_toml(const SettingList& list);

} // namespace atrium::app
