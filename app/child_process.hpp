#pragma once
// Starting programs.

#include <filesystem>
#include <string>
#include <vector>

namespace atrium::app {

/// The file of the running program.
[[nodiscard]] std::filesystem::path this_program();

/// Runs a program with its output passed through and waits. Returns its exit code, or minus the signal that ended it.
[[nodiscard]] int run_child(const std::vector<std::string>& command);

} // namespace atrium::app
