#pragma once
// What `assetconv info` tells about a bake.

#include "renderer/scene/scene.hpp"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace atrium {

/// Keys: docs/assetconv.md. `file_size` in bytes. Names may hold bytes that are no UTF-8: dump with to_text().
[[nodiscard]] nlohmann::ordered_json info_json(const Scene& scene, std::uint64_t file_size);
/// Indented, with a trailing newline; bytes that are no UTF-8 are replaced.
[[nodiscard]] std::string to_text(const nlohmann::ordered_json& json);
/// The same for people, with a trailing newline.
[[nodiscard]] std::string info_text(const Scene& scene, std::uint64_t file_size);
/// One line for each kind of warning, without a newline: how often, what it means, and the first place.
[[nodiscard]] std::vector<std::string> warning_lines(const Scene& scene);

} // namespace atrium
