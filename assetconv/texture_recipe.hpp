#pragma once
// Which maps make up one texture of the bake, and packing them into it. Two materials with the same recipe share the
// texture.

#include "assetconv/source_image.hpp"
#include "renderer/scene/scene.hpp"

#include <optional>
#include <string>

namespace atrium {

enum class TextureRole : std::uint8_t {
    base_color, ///< rgb sRGB, a opacity
    normal,     ///< xy, green up
    surface,    ///< r specular scale, g roughness, b metallic
    emission,   ///< rgb sRGB
};

/// One map as a recipe uses it.
struct MapInput {
    ImageKey image;
    std::string name;         ///< as the MTL has it, for Texture::file
    char channel = 'l';       ///< for scalar use: r g b m l (channels.hpp)
    float base = 0, gain = 1; ///< value * gain + base

    [[nodiscard]] float adjust(float value) const { return glm::clamp(value * gain + base, 0.0f, 1.0f); }
};

struct TextureRecipe {
    TextureRole role = TextureRole::base_color;
    bool clamp = false;

    // base_color, emission; for normal the map itself
    std::optional<MapInput> color;
    // base_color
    std::optional<MapInput> alpha; ///< opacity; none: 1 everywhere
    std::optional<float> cutoff;   ///< of a mask: alpha below it is a hole; mips keep the covered area
    // normal
    bool from_height = false;
    bool green_down = false;
    float strength = 1; ///< -bm
    // surface
    std::optional<MapInput> specular, shininess, roughness, metallic;
    bool bake_roughness = false; ///< g holds the roughness made of specular and shininess
    float base_roughness = 1, ns = 10;

    /// Equal for equal recipes.
    [[nodiscard]] std::string key() const;
    /// Names of the maps in it, joined by "+".
    [[nodiscard]] std::string file() const;
};

/// The first mip level: 8 bits a channel, row 0 at the top.
struct PackedImage {
    int width = 0, height = 0, channels = 4;
    std::vector<std::uint8_t> texels;

    [[nodiscard]] std::uint8_t* at(int x, int y)
    {
        return &texels[(static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)) *
                       static_cast<std::size_t>(channels)];
    }
};

/// Opacity below this is a hole in a mask.
inline constexpr float mask_cutoff = 0.5f;

/// Packs at the size of the largest map in the recipe; smaller ones are enlarged bilinearly. Every image that the
/// recipe names must be in the store.
[[nodiscard]] PackedImage pack_texture(const TextureRecipe& recipe, const ImageStore& images);

/// The share of specular map and Phong exponent in roughness. Source: Karis 2013 (alpha = sqrt(2 / (Ns + 2))).
[[nodiscard]] float roughness_of_exponent(float ns);
[[nodiscard]] float roughness_under_specular_map(float roughness, float specular);

} // namespace atrium
