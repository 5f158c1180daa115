#pragma once
// Values as users type them and as they are printed again. One rule for --set, --light, TOML and metadata.

#include "renderer/core/math.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace atrium {

/// The whole text must be the value, without blanks around it; empty otherwise. Numbers are decimal and finite.
[[nodiscard]] std::optional<bool> parse_bool(std::string_view text); ///< on, off, true, false
[[nodiscard]] std::optional<int> parse_int(std::string_view text);
[[nodiscard]] std::optional<float> parse_float(std::string_view text);
[[nodiscard]] std::optional<vec3> parse_vec3(std::string_view text); ///< x:y:z

/// Floats in the shortest form that reads back as the same float.
[[nodiscard]] std::string to_text(bool value); ///< on, off
[[nodiscard]] std::string to_text(int value);
[[nodiscard]] std::string to_text(float value);
[[nodiscard]] std::string to_text(const vec3& value); ///< x:y:z

} // namespace atrium
