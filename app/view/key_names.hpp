#pragma once
// Names of keys, as files and the help have them.

#include "app/view/window.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace atrium::app {

/// Such as "P", "Page up", "Ctrl+Z": where a US keyboard has them.
[[nodiscard]] std::string name_of(const KeyPress& key);

/// The key of such a name, in small letters or capitals; nothing where no key has it.
[[nodiscard]] std::optional<KeyPress> parse_key(std::string_view name);

/// All names, without Ctrl and Alt.
[[nodiscard]] std::vector<std::string> key_names();

} // namespace atrium::app
