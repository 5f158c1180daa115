#pragma once
// What a shader shares with the world outside it, and on which C++ relies: found in its SPIR-V.

#include "renderer/gpu/descriptors.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace atrium::gpu {

/// From what there is ("set 2, binding 0", "push constants", "constant 3", "output 0") to how it is laid out. Names do
/// not count.
using ShaderInterface = std::map<std::string, std::string>;

/// Of SPIR-V with one entry point, called main. Throws Error(input) for what is no SPIR-V.
[[nodiscard]] ShaderInterface find_interface(std::span<const std::uint32_t> code);

/// The bindings of a shader in set 2, in ascending order. Throws Error(input) if the bytes are not SPIR-V.
[[nodiscard]] std::vector<PassBinding> find_pass_bindings(std::span<const std::uint32_t> code);

/// What keeps a shader from standing in the place of another: something that it wants beyond the other or in another
/// layout, or an output that it lacks. None where it can. It may want less.
[[nodiscard]] std::optional<std::string> interface_conflict(const ShaderInterface& built, const ShaderInterface& fresh);

} // namespace atrium::gpu
