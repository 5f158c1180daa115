#pragma once
// The text that a picture carries: everything needed to draw it again, as a scene file without its bake.

#include "renderer/core/image.hpp"
#include "renderer/engine.hpp"
#include "renderer/scene/scene_file.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace atrium::app {

/// Keyword under which pictures keep it.
inline constexpr const char* metadata_key = "atrium";

/// Settings that differ from the defaults of some device, camera, lights, changes of the scene's materials, size and
/// time, as TOML. The same request gives the same text.
[[nodiscard]] ImageMetadata describe_frame(const FrameRequest& request, double time);

/// A settings file in TOML, or the text inside a PNG or EXR. Throws Error(input).
[[nodiscard]] FrameConfig read_config(const std::filesystem::path& file);

} // namespace atrium::app
