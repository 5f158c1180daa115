#pragma once
// The plan of the court: every dimension that two parts must agree on. Metres; y = 0 is the court's floor.
//
//        outer wall                         local frame of a side, seen from the court:
//   +--------------------+                    x along the side to the right, y up,
//   |  aisle             |                    z towards the court; z = 0 on the column axes
//   |  o  o  o  o  o  o  |
//   |  o    (court)   o  |
//   |  o  o  o  o  o  o  |
//   +--------------------+

#include "assetconv/courtyard/profile.hpp"
#include "renderer/core/math.hpp"

#include <array>
#include <cstdint>
#include <string>

namespace atrium::courtyard {

inline constexpr float bay = 2.6f; ///< from column axis to column axis
inline constexpr int long_bays = 7, short_bays = 3;
inline constexpr float half_length = 0.5f * bay * long_bays; ///< of the column axes' rectangle, along X
inline constexpr float half_width = 0.5f * bay * short_bays; ///< along Z
inline constexpr float aisle_depth = 2.9f;                   ///< column axis to outer wall
inline constexpr float wall_half = 0.25f;                    ///< half the thickness of the arcade's wall

// Lower floor.
inline constexpr float step_height = 0.15f;
inline constexpr float step_tread = 0.34f;
inline constexpr float aisle_floor = 2 * step_height;
inline constexpr float stylobate_edge = 0.42f; ///< the aisle floor reaches so far beyond the column axes
inline constexpr float column_diameter = 0.42f;
inline constexpr float column_height = 3.55f; ///< 8.45 diameters, base and capital included
inline constexpr float springing = aisle_floor + column_height;
inline constexpr float arch_half_span = 1.0f;
inline constexpr float arch_rise = 1.0f; ///< semicircular
inline constexpr float vault_rise = 1.2f;
inline constexpr float string_course_bottom = 5.22f;

// Upper floor.
inline constexpr float gallery_floor = 5.55f;
inline constexpr float rail_height = 0.95f;
inline constexpr float upper_diameter = 0.27f;
inline constexpr float upper_height = 2.2f; ///< 8.1 diameters, on a pedestal as high as the rail
inline constexpr float upper_springing = gallery_floor + rail_height + upper_height;
inline constexpr float upper_half_span = 1.1f;
inline constexpr float upper_rise = 0.62f; ///< segmental
inline constexpr float upper_wall_half = 0.18f;
inline constexpr float gallery_ceiling = 9.55f;
inline constexpr float eaves_cornice_bottom = 9.6f;
inline constexpr float eaves_top = 9.86f;
inline constexpr float eaves_overhang = 0.62f; ///< tiles reach so far beyond the column axes, towards the court
inline constexpr float roof_slope = 0.36f;     ///< rise over run, about 20 degrees
inline constexpr float outer_thickness = 0.45f;

/// Lower storey: the plaster texture is this high and wide, and its foot stands on the aisle's floor.
inline constexpr float plaster_tile = 5.2f;

/// How finely round things are cut.
struct Fineness {
    int column, column_small; ///< segments around a shaft
    int shaft_rings;          ///< rows along it
    int leaf_pieces;          ///< across a leaf of a capital; 0: none
    Cut cut;                  ///< of profiles
    float least_chamfer;      ///< of boxes, m
    int baluster;             ///< segments around
    int balusters_per_bay;
    int arch;          ///< segments of an arch
    int voussoir;      ///< segments of one voussoir
    int cloth;         ///< vertices across a pleat
    int tile;          ///< segments of a roof tile's arc
    int tile_rows;     ///< rows of single tiles from the eaves; above them one tile runs to the ridge
    bool small_things; ///< nails, rings, louvres, dentils
    int lathe;         ///< segments around vases and basins
    float leaves;      ///< share of the leaves that high detail would have
    bool voussoirs;    ///< single stones in the lower arches
};

/// One of the four sides of the court.
struct Side {
    std::string name;
    int bays = 0;
    float half = 0; ///< half the side's length between corner axes
    mat4 frame{1};  ///< local to world
    /// Local x of column i; 0 and `bays` are the corners.
    [[nodiscard]] float axis(int i) const { return -half + bay * static_cast<float>(i); }
    [[nodiscard]] float bay_centre(int i) const { return axis(i) + 0.5f * bay; }
};

[[nodiscard]] const std::array<Side, 4>& sides();
enum SideIndex { north = 0, east = 1, south = 2, west = 3 };

} // namespace atrium::courtyard
