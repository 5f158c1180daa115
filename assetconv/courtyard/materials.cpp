#include "assetconv/courtyard/materials.hpp"

#include "assetconv/courtyard/plan.hpp"
#include "renderer/core/error.hpp"

#include <fmt/format.h>

#include <array>

namespace atrium::courtyard {
namespace {

constexpr const char* none = "";

// Phong where nothing else is said. Kd is white or grey where a map gives the colour.
const std::array<MaterialInfo, 29> table{{
    {"limestone_ashlar", 2.4f, "ashlar", "ashlar_normal", "ashlar_gloss", none, vec3(1), 22},
    {"limestone_trim", 1.2f, "limestone", "limestone_normal", "limestone_gloss", none, vec3(1), 34},
    {"column_stone", 1.0f, "column", "column_normal", "column_gloss", none, vec3(1), 60},
    {"plaster", plaster_tile, "plaster", "plaster_normal", "plaster_gloss", none, vec3(1), 12},
    {"plaster_ochre", plaster_tile, "plaster_ochre", "plaster_ochre_normal", none, none, vec3(1), 12},
    {"plaster_vault", 2.4f, "whitewash", "whitewash_normal", none, none, vec3(1), 10},
    {"floor_court", 2.4f, "floor_court", "floor_court_normal", "floor_court_gloss", none, vec3(1), 48},
    {"floor_border", 1.6f, "basalt", "basalt_normal", "basalt_gloss", none, vec3(1), 48},
    {"floor_aisle", 1.2f, "floor_aisle", "floor_aisle_normal", "floor_aisle_gloss", none, vec3(1), 60},
    {"terracotta", 0.9f, "terracotta", "terracotta_normal", none, none, vec3(1), 16},
    {"roof_tile", 1.6f, "roof_tile", "roof_tile_normal", none, none, vec3(1), 14},
    {"wood_beam", 1.6f, "wood_beam", "wood_beam_normal", none, none, vec3(1), 20},
    {"wood_door", 1.2f, "wood_door", "wood_door_normal", "wood_door_gloss", none, vec3(1), 30},
    {"wood_shutter", 1.2f, "shutter", "shutter_normal", none, none, vec3(1), 30},
    {"cloth_red", 1.0f, "cloth_red", "cloth_normal", none, none, vec3(1), 8, vec3(0.3f)},
    {"cloth_green", 1.0f, "cloth_green", "cloth_normal", none, none, vec3(1), 8, vec3(0.3f)},
    {"cloth_blue", 1.0f, "cloth_blue", "cloth_normal", none, none, vec3(1), 8, vec3(0.3f)},
    {"relief", 1.0f, "relief", "relief_normal", "relief_gloss", none, vec3(1), 26},
    {"bark", 0.5f, "bark", "bark_normal", none, none, vec3(1), 10},
    {"soil", 0.5f, "soil", "soil_normal", none, none, vec3(1), 6, vec3(0.3f)},
    {"leaf", 1.0f, "leaf_atlas", none, none, "leaf_mask", vec3(1), 26},
    {"frond", 1.0f, "frond_atlas", none, none, none, vec3(1), 20},
    {"chain", 1.0f, "chain", none, none, "chain_mask", vec3(1), 40},
    {"orange_peel", 0.3f, "orange", "orange_normal", none, none, vec3(1), 40},
    {"lantern_glass", 0.4f, "glass_glow", none, none, none, vec3(1), 80, vec3(0.5f), 0.5f, 0, {6.0f, 3.3f, 1.25f}},
    {"iron", 0.5f, "iron", "iron_normal", "iron_rough", none, vec3(1), 0, vec3(0), 1.0f, 0.4f},
    {"bronze", 0.5f, "bronze", "bronze_normal", "bronze_rough", none, vec3(1), 0, vec3(0), 1.0f, 0.6f},
    {"water", 1.6f, "water", "water_normal", none, none, vec3(1), 0, vec3(0), 0.06f, 0},
    {"gilt", 0.3f, none, none, none, none, {0.72f, 0.5f, 0.2f}, 40, vec3(0.6f)},
}};

void add_map(std::string& text, const char* keyword, const char* map)
{
    if (*map != '\0') {
        text += fmt::format("{} textures/{}.png\n", keyword, map);
    }
}

void add_color(std::string& text, const char* keyword, const vec3& c)
{
    text += fmt::format("{} {:.4g} {:.4g} {:.4g}\n", keyword, c.x, c.y, c.z);
}

} // namespace

std::span<const MaterialInfo> materials()
{
    return table;
}

const MaterialInfo& material(std::string_view name)
{
    for (const MaterialInfo& m : table) {
        if (name == m.name) {
            return m;
        }
    }
    throw Error(ExitCode::internal, fmt::format("the courtyard has no material \"{}\"", name),
                "courtyard/materials.cpp", "", "report this message");
}

std::string mtl_text()
{
    std::string text = "# Courtyard of Atrium, made by code. The normal maps are tangent-space, green up.\n";
    for (const MaterialInfo& m : table) {
        const bool pbr = m.ns == 0;
        text += fmt::format("\nnewmtl {}\n", m.name);
        add_color(text, "Kd", m.kd);
        add_map(text, "map_Kd", m.color);
        if (pbr) {
            text += fmt::format("Pr {:.4g}\nPm {:.4g}\n", m.roughness, m.metallic);
            add_map(text, "map_Pr", m.gloss);
            add_map(text, "norm", m.normal);
        } else {
            add_color(text, "Ks", m.ks);
            text += fmt::format("Ns {:.4g}\nillum 2\n", m.ns);
            add_map(text, "map_Ks", m.gloss);
            add_map(text, "map_bump", m.normal);
        }
        add_map(text, "map_d", m.mask);
        if (m.ke != vec3(0)) {
            add_color(text, "Ke", m.ke);
            add_map(text, "map_Ke", m.color);
        }
    }
    return text;
}

} // namespace atrium::courtyard
