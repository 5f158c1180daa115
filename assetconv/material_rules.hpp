#pragma once
// The one table from MTL keywords to the material model. docs/materials.md tells it in words; keep both alike.

#include "assetconv/mtl.hpp"
#include "assetconv/normal_verdict.hpp"
#include "assetconv/texture_recipe.hpp"
#include "assetconv/vertices.hpp"

#include <array>
#include <map>
#include <optional>

namespace atrium {

/// Maps of a material whose files were found, by kind.
using MapFiles = std::array<std::optional<ImageKey>, map_kind_count>;

/// A material and what its textures are to be made of.
struct MaterialPlan {
    Material material; ///< texture indices not yet set
    std::optional<TextureRecipe> base_color, normal, surface, emission;
    UvTransform uv;
};

/// Which maps the rules want to see, before any is decoded: unused ones are neither looked for nor missed.
[[nodiscard]] bool is_map_wanted(const MtlMaterial& mtl, MapKind kind);
/// Whether a map holds colour (for floating-point files: see SourceImage).
[[nodiscard]] bool is_color_map(MapKind kind);

/// Applies the table. `files` holds what was found; images that could not be decoded count as not found.
[[nodiscard]] MaterialPlan plan_material(const MtlMaterial& mtl, const MapFiles& files, const ImageStore& images,
                                         const NormalVerdicts& verdicts, Warnings& warnings);

/// The grey that faces without a material get.
[[nodiscard]] Material default_material();

} // namespace atrium
