#pragma once
// The court's materials: what the MTL says of each, and how large one repeat of its texture is.

#include "renderer/core/math.hpp"

#include <span>
#include <string>
#include <string_view>

namespace atrium::courtyard {

/// One entry of the MTL. A map is the texture's name without folder and extension; empty: none.
struct MaterialInfo {
    const char* name;
    float tile;              ///< metres of one repeat; 1 where coordinates are 0..1 already
    const char* color = "";  ///< map_Kd
    const char* normal = ""; ///< map_bump (Phong) or norm (PBR), a tangent-space normal map, green up
    const char* gloss = "";  ///< map_Ks (Phong) or map_Pr (PBR)
    const char* mask = "";   ///< map_d
    vec3 kd{1};
    float ns = 0; ///< Phong exponent; 0: PBR keywords instead
    vec3 ks{0.5f};
    float roughness = 0.5f, metallic = 0; ///< PBR keywords only
    vec3 ke{0};                           ///< emission
};

[[nodiscard]] std::span<const MaterialInfo> materials();
/// Stops the program when there is no such material: a defect of ours.
[[nodiscard]] const MaterialInfo& material(std::string_view name);
/// The text of courtyard.mtl.
[[nodiscard]] std::string mtl_text();

} // namespace atrium::courtyard
