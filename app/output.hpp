#pragma once
// Files that `render` writes: one picture or numbered ones, and AOVs beside them.

#include "renderer/engine.hpp"
#include "renderer/scene/scene_file.hpp"

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace atrium::app {

struct AovOutput {
    std::string name;
    std::filesystem::path file;
};

class OutputPlan {
public:
    /// `frames` is empty, "N" or "A-B"; `aovs` are "NAME=FILE.exr". A run of '#' in a name becomes the frame's number,
    /// padded with zeros. Throws Error(usage).
    OutputPlan(std::filesystem::path picture, const std::string& frames, const std::vector<std::string>& aovs);

    [[nodiscard]] std::size_t frame_count() const { return last_ - first_ + 1; }
    [[nodiscard]] std::size_t first_frame() const { return first_; }
    [[nodiscard]] bool numbered() const; ///< each frame has a file of its own
    [[nodiscard]] bool wants_png() const { return png_; }
    [[nodiscard]] bool writes(std::size_t i) const { return numbered() || i + 1 == frame_count(); }
    /// Whether all files of the frame are there, whole, with this metadata.
    [[nodiscard]] bool is_done(std::size_t i, const ImageMetadata& metadata) const;
    [[nodiscard]] const std::vector<AovOutput>& aovs() const { return aovs_; }
    /// Throws Error(usage) when one of its files is one of `inputs`.
    void refuse_inputs(std::span<const std::filesystem::path> inputs) const;
    /// Throws Error(environment) when a folder is missing, before anything is drawn.
    void check_writable() const;
    void write(std::size_t i, const FrameResult& frame, const ImageMetadata& metadata) const;

private:
    [[nodiscard]] std::filesystem::path numbered_name(const std::filesystem::path& pattern, std::size_t i) const;
    std::filesystem::path picture_;
    std::vector<AovOutput> aovs_;
    std::size_t first_ = 0, last_ = 0;
    bool png_ = true;
};

/// Throws Error(usage) naming the nearest path; an empty name is no path.
[[nodiscard]] CameraPath find_path(const std::string& name, const SceneFile& file);

} // namespace atrium::app
