#pragma once
// Where the embedded shaders came from, and how.

#include <span>
#include <string>

namespace atrium::shaders {

/// The compiler and its options as the build calls it, without folders and files.
[[nodiscard]] std::span<const std::string> compiler();
/// The sources in the tree that the program was built from, and where its build puts programs.
[[nodiscard]] const std::string& source_folder();
[[nodiscard]] const std::string& program_folder();

} // namespace atrium::shaders
