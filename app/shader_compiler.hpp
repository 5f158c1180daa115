#pragma once
// GLSL to SPIR-V while the program runs, by the compiler and with the options of the build.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace atrium::app {

/// SPIR-V of the shader `folder`/`name`, whose includes are sought in `folder`. Throws Error(input) with the file and
/// line of the first mistake, named from `folder`. Takes about 0.1 s; may run on several threads.
[[nodiscard]] std::vector<std::uint32_t> compile_shader(const std::filesystem::path& folder, const std::string& name);

} // namespace atrium::app
