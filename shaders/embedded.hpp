#pragma once
// SPIR-V embedded at build time.

#include <cstdint>
#include <span>
#include <string_view>

namespace atrium::shaders {

/// Code of the shader whose source lies at shaders/<name>; empty when there is none.
[[nodiscard]] std::span<const std::uint32_t> find(std::string_view name);

} // namespace atrium::shaders
