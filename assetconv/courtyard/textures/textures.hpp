#pragma once
// Every picture of the court. A painter writes one family: colour, normals, gloss or mask of the same thing.

#include "assetconv/courtyard/courtyard.hpp"
#include "assetconv/courtyard/textures/canvas.hpp"

#include <span>

namespace atrium::courtyard {

void paint_ashlar(const Studio& studio);
void paint_limestone(const Studio& studio);
void paint_column(const Studio& studio);
void paint_basalt(const Studio& studio);
void paint_plaster(const Studio& studio);
void paint_plaster_ochre(const Studio& studio);
void paint_whitewash(const Studio& studio);
void paint_floor_court(const Studio& studio);
void paint_floor_aisle(const Studio& studio);
void paint_terracotta(const Studio& studio);
void paint_roof_tile(const Studio& studio);
void paint_wood_beam(const Studio& studio);
void paint_wood_door(const Studio& studio);
void paint_shutter(const Studio& studio);
void paint_cloth(const Studio& studio);
void paint_relief(const Studio& studio);
void paint_leaf_atlas(const Studio& studio);
void paint_frond_atlas(const Studio& studio);
void paint_bark(const Studio& studio);
void paint_soil(const Studio& studio);
void paint_orange(const Studio& studio);
void paint_iron(const Studio& studio);
void paint_bronze(const Studio& studio);
void paint_chain(const Studio& studio);
void paint_glass(const Studio& studio);
void paint_water(const Studio& studio);

/// Writes all of them into `folder`, on all cores.
void write_textures(const std::filesystem::path& folder, std::uint32_t seed, CourtyardOptions::Detail detail);

} // namespace atrium::courtyard
