#pragma once
// The command line of assetconv: what may be typed, and what each command does.

#include <string>
#include <vector>

namespace atrium {

/// Runs one command line (without the program's name) and returns the exit code. Throws Error.
[[nodiscard]] int run_assetconv(std::vector<std::string> arguments);

} // namespace atrium
