#include "assetconv/courtyard/textures/textures.hpp"

#include "renderer/core/jobs.hpp"

#include <array>

namespace atrium::courtyard {
namespace {

/// `share` of the largest size: what is seen at arm's length or spans a storey gets all of it.
struct Family {
    void (*paint)(const Studio&);
    int divide;
};

// The slow ones first: two cores end together.
constexpr std::array<Family, 26> families{{
    {paint_plaster, 1},     {paint_plaster_ochre, 1}, {paint_cloth, 1},       {paint_ashlar, 1},
    {paint_floor_court, 1}, {paint_limestone, 1},     {paint_leaf_atlas, 1},  {paint_frond_atlas, 1},
    {paint_relief, 2},      {paint_column, 2},        {paint_floor_aisle, 2}, {paint_roof_tile, 2},
    {paint_wood_beam, 2},   {paint_wood_door, 2},     {paint_whitewash, 2},   {paint_basalt, 2},
    {paint_terracotta, 2},  {paint_bark, 4},          {paint_soil, 4},        {paint_iron, 4},
    {paint_bronze, 4},      {paint_water, 4},         {paint_chain, 4},       {paint_glass, 4},
    {paint_orange, 4},      {paint_shutter, 2},
}};

} // namespace

void write_textures(const std::filesystem::path& folder, std::uint32_t seed, CourtyardOptions::Detail detail)
{
    const int largest = detail == CourtyardOptions::Detail::low ? 256 : 1024;
    const bool high = detail == CourtyardOptions::Detail::high;
    parallel_for(families.size(), [&](std::size_t i) {
        const int divide = high && families[i].divide == 2 ? 1 : families[i].divide;
        families[i].paint({folder, mix(seed, static_cast<std::uint32_t>(i) + 40), std::max(64, largest / divide)});
    });
}

} // namespace atrium::courtyard
