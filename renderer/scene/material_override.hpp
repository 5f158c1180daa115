#pragma once
// Changes of materials by name, and the one description of a material's keys: for scene files, pictures and widgets.

#include "renderer/core/setting.hpp"
#include "renderer/scene/scene.hpp"

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace atrium {

/// As to_string() has them.
[[nodiscard]] std::array<const char*, material_class_count> enum_names(MaterialClass);

/// What can be changed of a material, for a SettingList or any other visitor.
template <class V>
void describe(V& v, Material& m)
{
    constexpr Range share{0.0f, 1.0f}, amount{0.0f, 1e9f};
    v.group("", "Material");
    v("class", m.cls, "How it is drawn: closed, with holes, see-through, or as cloth");
    v("two_sided", m.two_sided, "Seen from behind too; classes other than opaque always are");
    v("base_color", m.base_color, "Linear Rec.709; multiplies the texture", share);
    v("opacity", m.opacity, "Masked and blended; multiplies the texture's alpha", share);
    v("alpha_cutoff", m.alpha_cutoff, "Masked: what is less opaque is a hole", share);
    v("roughness", m.roughness, "Perceptual; multiplies the texture", share);
    v("metallic", m.metallic, "Multiplies the texture", share);
    v("specular", m.specular, "Dielectric F0; multiplies the texture", share);
    v("emission", m.emission, "Radiance; multiplies the texture", amount, "nt");
}

/// Values for the materials whose name fits a pattern.
struct MaterialOverride {
    std::string match;                                       ///< with * and ?
    std::vector<std::pair<std::string, std::string>> values; ///< key and text, within what describe() says
    bool operator==(const MaterialOverride&) const = default;
};

/// `name` against a pattern of *, ? and plain characters.
[[nodiscard]] bool matches_pattern(std::string_view pattern, std::string_view name);

/// A pattern for a name: a ? stands for each byte that a text in TOML cannot hold.
[[nodiscard]] std::string pattern_of(std::string_view name);

/// Writes the values into a material.
void apply(const MaterialOverride& o, Material& material);

/// The material with all overrides that fit it, in order.
[[nodiscard]] Material overridden(Material material, std::span<const MaterialOverride> overrides);

/// What makes `to` of `from`, for the materials of from's name.
[[nodiscard]] MaterialOverride difference(const Material& from, const Material& to);

/// The same changes of those materials, one override for each name that is changed.
[[nodiscard]] std::vector<MaterialOverride> spelled_out(std::span<const Material> materials,
                                                        std::span<const MaterialOverride> overrides);

} // namespace atrium
