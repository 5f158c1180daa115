#pragma once
// Where `--json FILE|-` goes.

#include <string>
#include <string_view>

namespace atrium::app {

/// To stdout for "-", else to the file, whole or not at all.
void write_json_text(const std::string& target, std::string_view text);

} // namespace atrium::app
