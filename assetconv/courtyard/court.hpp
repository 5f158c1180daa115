#pragma once
// The work site: the model under construction, how fine it is to be, and the builders that add to it.

#include "assetconv/courtyard/courtyard.hpp"
#include "assetconv/courtyard/mesh.hpp"
#include "assetconv/courtyard/plan.hpp"
#include "assetconv/courtyard/random.hpp"

#include <string_view>

namespace atrium::courtyard {

struct Court {
    Model model;
    Fineness fine{};
    std::uint32_t seed = 1;

    /// A pen for that group and material, with the material's texture size.
    Pen pen(std::string_view group, std::string_view material, const mat4& placement = mat4(1));
};

[[nodiscard]] Fineness fineness(CourtyardOptions::Detail detail);

// Architecture.
void build_columns(Court& court);
void build_arcades(Court& court);
void build_cornices(Court& court);
void build_vaults(Court& court);
void build_floors(Court& court);
void build_outer_walls(Court& court);
void build_balustrades(Court& court);
void build_gallery_ceiling(Court& court);
void build_roof(Court& court);
// Things.
void build_doors(Court& court);
void build_fountain(Court& court);
void build_curtains(Court& court);
void build_banners(Court& court);
void build_lanterns(Court& court);
void build_benches(Court& court);
void build_reliefs(Court& court);
// What grows.
void build_pots(Court& court);
void build_hanging_plants(Court& court);
void build_climbers(Court& court);

/// Everything, in the order in which groups stand in the OBJ.
void build_all(Court& court);

} // namespace atrium::courtyard
