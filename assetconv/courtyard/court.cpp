#include "assetconv/courtyard/court.hpp"

#include "assetconv/courtyard/materials.hpp"

namespace atrium::courtyard {

Pen Court::pen(std::string_view group, std::string_view material_name, const mat4& placement)
{
    return Pen(model.part(group, material_name), placement, material(material_name).tile, fine.least_chamfer);
}

Fineness fineness(CourtyardOptions::Detail detail)
{
    using Detail = CourtyardOptions::Detail;
    Fineness f{};
    switch (detail) {
    case Detail::low:
        f = {.column = 6,
             .column_small = 5,
             .shaft_rings = 2,
             .leaf_pieces = 0,
             .cut = {1, 0.03f, 1},
             .least_chamfer = 1,
             .baluster = 3,
             .balusters_per_bay = 2,
             .arch = 6,
             .voussoir = 1,
             .cloth = 3,
             .tile = 2,
             .tile_rows = 0,
             .small_things = false,
             .lathe = 6,
             .leaves = 0.05f,
             .voussoirs = false};
        break;
    case Detail::medium:
        f = {.column = 14,
             .column_small = 10,
             .shaft_rings = 4,
             .leaf_pieces = 2,
             .cut = {2, 0.007f, 0.0075f},
             .least_chamfer = 0.0075f,
             .baluster = 6,
             .balusters_per_bay = 6,
             .arch = 12,
             .voussoir = 2,
             .cloth = 5,
             .tile = 3,
             .tile_rows = 1,
             .small_things = true,
             .lathe = 18,
             .leaves = 0.46f,
             .voussoirs = true};
        break;
    case Detail::high:
        f = {.column = 24,
             .column_small = 18,
             .shaft_rings = 8,
             .leaf_pieces = 3,
             .cut = {3, 0.0022f, 0.005f},
             .least_chamfer = 0.005f,
             .baluster = 10,
             .balusters_per_bay = 7,
             .arch = 24,
             .voussoir = 3,
             .cloth = 6,
             .tile = 4,
             .tile_rows = 99,
             .small_things = true,
             .lathe = 30,
             .leaves = 1.0f,
             .voussoirs = true};
        break;
    }
    return f;
}

void build_all(Court& court)
{
    build_floors(court);
    build_columns(court);
    build_arcades(court);
    build_cornices(court);
    build_vaults(court);
    build_outer_walls(court);
    build_doors(court);
    build_balustrades(court);
    build_gallery_ceiling(court);
    build_roof(court);
    build_fountain(court);
    build_reliefs(court);
    build_benches(court);
    build_curtains(court);
    build_banners(court);
    build_lanterns(court);
    build_pots(court);
    build_hanging_plants(court);
    build_climbers(court);
    court.model.tidy();
}

} // namespace atrium::courtyard
