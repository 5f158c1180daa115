#pragma once
// "Did you mean": the valid name closest to what was typed.

#include <span>
#include <string>
#include <string_view>

namespace atrium {

/// The candidate with the smallest edit distance (insert, delete, replace, swap of neighbours); the first of equals.
/// Empty when there is no candidate.
[[nodiscard]] std::string nearest_name(std::string_view typed, std::span<const std::string> candidates);

} // namespace atrium
