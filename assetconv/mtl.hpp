#pragma once
// MTL files as they are written: values with a note whether they were given, and maps with their options. What they
// mean is decided in material_rules.hpp.

#include "assetconv/warnings.hpp"
#include "renderer/core/math.hpp"

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace atrium {

/// The maps that the material model can use.
enum class MapKind : std::uint8_t {
    diffuse,      ///< map_Kd
    ambient,      ///< map_Ka
    specular,     ///< map_Ks
    shininess,    ///< map_Ns
    alpha,        ///< map_d
    emission,     ///< map_Ke
    roughness,    ///< map_Pr
    metallic,     ///< map_Pm
    normal,       ///< norm
    bump,         ///< map_bump, bump
    displacement, ///< map_disp, disp
};
inline constexpr std::size_t map_kind_count = 11;

/// A map statement: the file as the MTL names it (with / for \), options, and the place for messages.
struct MapReference {
    std::string file;
    std::string where;        ///< "sponza.mtl:212, map_bump of material "lion""
    vec2 scale{1}, offset{0}; ///< -s, -o
    float base = 0, gain = 1; ///< -mm: value * gain + base
    float bump = 1;           ///< -bm
    char channel = 0;         ///< -imfchan: r g b m l z; 0 when not given
    bool clamp = false;
};

struct MtlMaterial {
    std::string name;
    std::string where;          ///< of newmtl
    std::filesystem::path file; ///< that defines it: its texture names start there
    std::optional<vec3> kd, ka, ks, ke, tf;
    std::optional<float> ns, ni, d, tr, pr, pm;
    std::optional<int> illum;
    std::array<std::optional<MapReference>, map_kind_count> maps;

    [[nodiscard]] const std::optional<MapReference>& map(MapKind kind) const
    {
        return maps[static_cast<std::size_t>(kind)];
    }
};

/// Adds the file's materials to `materials`; one of a known name replaces the earlier in its place.
/// Throws Error(input) when the file cannot be read.
void read_mtl(const std::filesystem::path& file, std::vector<MtlMaterial>& materials, Warnings& warnings);

/// Options and file name after a map keyword. nullopt when no file is named.
[[nodiscard]] std::optional<MapReference> parse_map(std::string_view text);

} // namespace atrium
