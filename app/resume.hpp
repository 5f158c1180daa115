#pragma once
// What `render --resume` holds a frame's files against.

#include "app/scene_input.hpp"
#include "renderer/core/image.hpp"

#include <filesystem>
#include <string>

namespace atrium::app {

/// Keyword under which numbered frames keep what they depend on beside what describe_frame() tells.
inline constexpr const char* resume_key = "atrium.resume";

/// A short text that differs where the scene's bakes, their instances or the changes of materials do.
[[nodiscard]] std::string scene_mark(const SceneInput& scene);

/// The value of resume_key. Motion depends on the camera of the frame before.
[[nodiscard]] std::string resume_text(const std::string& scene_mark, const Camera& previous_camera);

/// Whether the file is a whole picture with exactly this metadata. Reads all of it.
[[nodiscard]] bool is_whole(const std::filesystem::path& file, const ImageMetadata& metadata);

} // namespace atrium::app
