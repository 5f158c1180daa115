#pragma once
// Small scenes made by code, as valid as what the converter bakes.

#include "renderer/scene/bake_file.hpp"
#include "tests/truth/shapes.hpp"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>

namespace atrium::truth {

/// Collects materials, textures and meshes; finish() adds what a bake has besides: clusters with spheres and facing
/// cones, bounds, mips, alignment. Materials come before the meshes that use them.
class SceneBuilder {
public:
    /// Returns the material's index.
    std::uint32_t add_material(const Material& material);
    /// An opaque, one-sided material of one colour.
    std::uint32_t add_material(const std::string& name, const vec3& base_color = vec3(0.8f));
    /// width x height texels of 4 bytes, row 0 at the top; mips are box-filtered. Returns the texture's index.
    std::int32_t add_texture(const std::string& file, std::uint32_t width, std::uint32_t height,
                             std::span<const std::uint8_t> rgba, TextureFormat format = TextureFormat::rgba8_srgb,
                             bool clamp = false);
    /// White with the given alphas, one byte a texel.
    std::int32_t add_alpha_texture(std::uint32_t width, std::uint32_t height, std::span<const std::uint8_t> alpha,
                                   bool clamp = false);
    /// Two-sided where the material is, or masked or blended. Returns the mesh's index.
    std::uint32_t add_mesh(const std::string& name, std::uint32_t material, const Shape& shape);

    [[nodiscard]] BakeData finish() const;

private:
    BakeData data_;
};

/// A bake in a file of its own in the temporary folder, opened; both go with the object.
class TempBake {
public:
    explicit TempBake(const BakeData& data);
    ~TempBake();
    TempBake(const TempBake&) = delete;
    TempBake& operator=(const TempBake&) = delete;
    [[nodiscard]] const BakeFile& file() const { return *bake_; }
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path folder_, path_;
    std::unique_ptr<BakeFile> bake_;
};

} // namespace atrium::truth
