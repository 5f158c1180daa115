#pragma once
// The whole bake, from an OBJ's path to the data of a .atrium file. bake.cpp reads as the list of its steps.

#include "assetconv/material_rules.hpp"
#include "assetconv/sides.hpp"
#include "renderer/core/input_record.hpp"
#include "renderer/scene/bake_file.hpp"

#include <filesystem>
#include <optional>

namespace atrium {

enum class TextureEncoding : std::uint8_t { rgba8, bc };

struct BakeOptions {
    std::filesystem::path input;
    float scale = 1; ///< metres per unit of the OBJ
    UpAxis up = UpAxis::y;
    TextureEncoding textures = TextureEncoding::rgba8;
    std::uint32_t max_texture_size = max_image_side;
    NormalY normal_y = NormalY::automatic;
    std::optional<float> smooth_angle; ///< degrees; given, it overrides smoothing groups
    TwoSided two_sided = TwoSided::automatic;
    bool strict = false;
};

/// Throws Error(input) when the OBJ is missing or holds no face that can be drawn, and with `strict` at the first
/// missing file or material. The same input gives the same bytes whatever the number of threads. `inputs` gets every
/// file that was read and every name that was searched.
[[nodiscard]] BakeData bake_scene(const BakeOptions& options, InputRecord* inputs = nullptr);

/// Parses the OBJ (tinyobjloader) and decodes its textures (OpenImageIO), and keeps nothing: what a renderer without a
/// bake would have to do at each start, for benchmarks.
void parse_scene(const BakeOptions& options);

} // namespace atrium
