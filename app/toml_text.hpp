#pragma once
// Settings and what stands beside them, written as TOML that reads back the same.

#include "renderer/core/setting.hpp"
#include "renderer/scene/camera.hpp"
#include "renderer/scene/material_override.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace atrium::app {

/// A TOML basic string, with its quotes.
[[nodiscard]] std::string toml_string(std::string_view text);

/// The shortest text that reads back the same; written as a float if a TOML integer cannot hold the value (-0, large
/// ones).
[[nodiscard]] std::string toml_number(float value);
[[nodiscard]] std::string toml_number(double value);
[[nodiscard]] std::string toml_vector(const vec3& v);
/// A boolean, number or array where the type has one, else a string.
[[nodiscard]] std::string toml_value(const Setting& setting);
/// The lines eye, target and fov.
[[nodiscard]] std::string toml_camera(const Camera& camera);

/// The table [settings] with every setting that differs from its default, in order of description.
[[nodiscard]] std::string differing_toml(const SettingList& list);

/// A table [[material]] for each.
[[nodiscard]] std::string materials_toml(const std::vector<MaterialOverride>& materials);

} // namespace atrium::app
