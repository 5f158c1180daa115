#pragma once
// Frames for tests: one engine under validation for the whole program, scenes from memory or file, AOVs by name.

#include "renderer/engine.hpp"
#include "renderer/scene/bake_file.hpp"
#include "tests/truth/mask.hpp"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace atrium::rig {

/// A scene of a test, resident on the shared engine until the next one is made.
class FrameRig {
public:
    explicit FrameRig(const BakeData& scene);
    explicit FrameRig(const std::filesystem::path& bake);
    ~FrameRig();
    FrameRig(const FrameRig&) = delete;
    FrameRig& operator=(const FrameRig&) = delete;

    FrameRequest
        request; ///< 320x180, no lights, no ambient occlusion, linear tone operator, else the device's own defaults

    [[nodiscard]] FrameResult render() const;
    /// Draws and returns one AOV.
    [[nodiscard]] ImageF aov(const std::string& name) const;
    [[nodiscard]] std::vector<ImageF> aovs(const std::vector<std::string>& names) const;
    void set(const std::string& key, const std::string& value); ///< a setting, as --set takes it
    void look(const vec3& eye, const vec3& target, float fov = 60);
    void light(const std::string& spec); ///< adds one, as --light takes it

    [[nodiscard]] const BakeFile& bake() const { return *bake_; }

private:
    void begin();
    std::filesystem::path folder_; ///< of a scene from memory; empty for files
    std::unique_ptr<BakeFile> bake_;
};

[[nodiscard]] Engine& engine();
/// Forgets the shared engine: for tests that make one of their own.
void reset_engine();

/// A folder of the test program's own, emptied at its end.
[[nodiscard]] std::filesystem::path temporary_folder();

/// The courtyard at low detail, written and baked once per program.
[[nodiscard]] const std::filesystem::path& courtyard_bake();

/// Bakes an OBJ into a file of the temporary folder.
[[nodiscard]] std::filesystem::path bake_of(const std::filesystem::path& obj);

/// Folder of real scenes (environment's ATRIUM_SCENES), if any.
[[nodiscard]] std::optional<std::filesystem::path> real_scenes();
/// Sponza in metres, baked once per program; empty when there are no real scenes.
[[nodiscard]] std::optional<std::filesystem::path> sponza_bake();

} // namespace atrium::rig
