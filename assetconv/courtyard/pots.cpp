#include "assetconv/courtyard/court.hpp"
#include "assetconv/courtyard/leaves.hpp"
#include "assetconv/courtyard/shapes.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace atrium::courtyard {
namespace {

enum class Shape { planter, urn, jar, bowl };

struct Vessel {
    float soil_y, soil_radius;
};

/// A terracotta vessel of that height, with lip, inside and soil.
Vessel draw_vessel(Court& court, const std::string& group, const mat4& place, Shape shape, float h)
{
    Cut cut = court.fine.cut;
    cut.tolerance *=
        std::min(1.6f, 3.5f * h); // a large vessel is seen from as near as a small one, but has larger curves
    ProfilePath p({0, 0}, cut);
    float lip = 0, throat = 0; // radii of the rim and, inside, of the soil
    switch (shape) {
    case Shape::planter:
        p = ProfilePath({0.3f * h, -0.01f}, cut);
        p.to(0.3f * h, 0.03f * h).torus(0.05f * h).to(0.31f * h, 0.1f * h).to(0.37f * h, 0.4f * h).torus(0.045f * h);
        p.to(0.42f * h, 0.8f * h).by(0.035f * h, 0.02f * h).to(0.475f * h, 0.9f * h).torus(0.08f * h);
        lip = 0.47f * h;
        throat = 0.4f * h;
        break;
    case Shape::urn:
        p = ProfilePath({0.2f * h, -0.01f}, cut);
        p.to(0.2f * h, 0.05f * h)
            .torus(0.04f * h)
            .ovolo(-0.1f * h, 0.08f * h)
            .cavetto(0.06f * h, 0.06f * h)
            .torus(0.03f * h);
        p.to(0.25f * h, 0.34f * h).to(0.32f * h, 0.45f * h).to(0.345f * h, 0.56f * h).to(0.34f * h, 0.66f * h);
        p.to(0.3f * h, 0.78f * h)
            .to(0.27f * h, 0.84f * h)
            .torus(0.02f * h)
            .cavetto(0.1f * h, 0.09f * h)
            .torus(0.035f * h);
        lip = 0.365f * h;
        throat = 0.235f * h;
        break;
    case Shape::jar:
        p = ProfilePath({0.15f * h, -0.01f}, cut);
        p.to(0.16f * h, 0.03f * h).to(0.21f * h, 0.14f * h).to(0.27f * h, 0.28f * h).to(0.31f * h, 0.44f * h);
        p.to(0.325f * h, 0.58f * h).to(0.31f * h, 0.72f * h).to(0.26f * h, 0.83f * h).to(0.2f * h, 0.9f * h);
        p.to(0.185f * h, 0.94f * h).ovolo(0.04f * h, 0.01f * h).torus(0.045f * h);
        lip = 0.22f * h;
        throat = 0.145f * h;
        break;
    case Shape::bowl:
        p = ProfilePath({0.42f * h, -0.01f}, cut);
        p.to(0.42f * h, 0.06f * h).to(0.5f * h, 0.2f * h).to(0.62f * h, 0.45f * h).to(0.7f * h, 0.75f * h);
        p.by(0.03f * h, 0).torus(0.2f * h);
        lip = 0.72f * h;
        throat = 0.6f * h;
        break;
    }
    const float wall = 0.05f * h, rim = p.end().y, soil = rim - 0.09f * h - 0.02f;
    p.to(lip - wall, rim).to(throat, soil - 0.03f);
    Pen clay = court.pen(group, "terracotta", place);
    const int segments = std::max(6, h > 0.55f ? court.fine.lathe : (court.fine.lathe * 3) / 4);
    draw_lathe(clay, p.finish(0.006f), {.segments = segments});
    Pen earth = court.pen(group, "soil", place);
    draw_disc(earth, soil, 0.01f, throat + 0.35f * wall, segments / 2);
    return {soil, throat};
}

int leaf_count(const Court& court, float at_high)
{
    return std::max(6, static_cast<int>(at_high * court.fine.leaves));
}
/// Fewer leaves are larger, so that a plant stays as full.
float leaf_size(const Court& court)
{
    return std::pow(court.fine.leaves, -0.3f);
}

/// A ball of leaves on a stem, with fruit: a citrus tree.
void grow_citrus(Court& court, const std::string& group, const mat4& place, float y, float size, Random& random)
{
    Pen bark = court.pen(group, "bark", place);
    const vec3 foot(0, y - 0.03f, 0), fork(random.around(0, 0.04f), y + 0.62f * size, random.around(0, 0.04f));
    draw_rod(bark, foot, fork, 0.034f * size, 0.026f * size, court.fine.small_things ? 7 : 4);
    const vec3 crown = fork + vec3(0, 0.42f * size, 0);
    for (int i = 0; i < 5; ++i) {
        const float a = 2 * pi * (static_cast<float>(i) + 0.5f * random.unit()) / 5;
        const vec3 tip = crown + size * vec3(0.26f * std::cos(a), random.around(0.02f, 0.12f), 0.26f * std::sin(a));
        draw_rod(bark, fork - vec3(0, 0.02f, 0), tip, 0.018f * size, 0.006f * size, 5);
    }
    Pen leaves = court.pen(group, "leaf", place);
    const int count = leaf_count(court, 440);
    for (int i = 0; i < count; ++i) {
        const vec3 out = any_direction(random);
        const float reach = 0.52f * size * (0.45f + 0.55f * std::sqrt(random.unit()));
        const vec3 along = glm::normalize(out + 0.7f * any_direction(random) + vec3(0, -0.15f, 0));
        const float length = random.between(0.19f, 0.27f) * leaf_size(court);
        draw_leaf_card(leaves, {crown + reach * out * vec3(1, 0.9f, 1), along, glm::normalize(out + vec3(0, 0.8f, 0)),
                                length, 0.95f * length, 0.5f, court.fine.leaves < 1 ? 1 : 2, cell_citrus, 0.9f * out});
    }
    Pen fruit = court.pen(group, "orange_peel", place);
    for (int i = 0; i < (court.fine.small_things ? 11 : 4); ++i) {
        const vec3 out = any_direction(random);
        draw_ball(fruit, crown + 0.48f * size * out * vec3(1, 0.85f, 1), random.between(0.034f, 0.044f) * size,
                  court.fine.small_things ? 5 : 3);
    }
}

/// A fountain of long leaves from one point: fern or agave.
void grow_rosette(Court& court, const std::string& group, const mat4& place, float y, float size, bool agave,
                  Random& random)
{
    Pen pen = court.pen(group, "frond", place);
    const bool few = !court.fine.small_things;
    const int count = few ? 11 : agave ? 26 : std::max(20, leaf_count(court, 60));
    for (int i = 0; i < count; ++i) {
        const float share =
            (static_cast<float>(i) + 0.5f) / static_cast<float>(count); // inner leaves stand, outer ones lie
        const float a = 2.39996f * static_cast<float>(i),
                    lean = (agave ? 0.25f : 0.35f) + (agave ? 0.95f : 0.75f) * share;
        const vec3 out(std::cos(a), 0, std::sin(a));
        const vec3 along = glm::normalize(out * std::sin(lean) + vec3(0, std::cos(lean), 0));
        const float length = size * random.between(0.75f, 1.0f) * (0.7f + 0.3f * share);
        const vec3 facing = glm::normalize(vec3(0, std::sin(lean), 0) - out * std::cos(lean)); // the hollow side, up
        draw_leaf_card(pen, {vec3(0, y - 0.02f, 0) + 0.03f * out, along, facing, length, (agave ? 0.2f : 0.3f) * length,
                             (agave ? 0.25f : 1.5f) * (0.6f + 0.4f * share),
                             few                     ? 2
                             : court.fine.leaves < 1 ? 4
                                                     : 5,
                             agave ? cell_agave : cell_fern, vec3(0, 0.3f, 0)});
    }
}

/// A cushion of round leaves with red blossoms.
void grow_geranium(Court& court, const std::string& group, const mat4& place, float y, float radius, Random& random)
{
    Pen pen = court.pen(group, "leaf", place);
    const int count = leaf_count(court, 130);
    const vec3 middle(0, y + 0.25f * radius, 0);
    const auto dome = [&] {
        vec3 out = any_direction(random);
        out.y = std::abs(out.y) * 0.9f + 0.05f;
        return glm::normalize(out);
    };
    for (int i = 0; i < count; ++i) {
        const vec3 out = dome();
        const vec3 along = glm::normalize(out * vec3(1, 0.35f, 1) + 0.5f * any_direction(random) + vec3(0, 0.1f, 0));
        const float size = random.between(0.12f, 0.18f) * leaf_size(court);
        draw_leaf_card(pen, {middle + radius * random.between(0.55f, 1.0f) * out * vec3(1, 0.8f, 1), along,
                             glm::normalize(out + vec3(0, 0.8f, 0)), size, size, 0.4f, 1, cell_geranium, 0.8f * out});
    }
    const int heads = std::max(4, count / 6);
    for (int i = 0; i < heads; ++i) {
        const vec3 out = dome();
        const vec3 head = middle + 1.1f * radius * out * vec3(1, 0.9f, 1);
        const float size = random.between(0.08f, 0.11f) * std::sqrt(leaf_size(court));
        for (int k = 0; k < 2; ++k) { // two crossed cards make a head of blossoms
            const vec3 facing = k == 0 ? out : glm::normalize(glm::cross(out, vec3(0.3f, 0.9f, 0.2f)) + 0.6f * out);
            const vec3 along = glm::normalize(glm::cross(facing, any_direction(random)));
            draw_leaf_card(pen,
                           {head - 0.5f * size * along, along, facing, size, size, 0, 1, cell_blossom, 0.5f * out});
        }
    }
}

enum class Plant { none, citrus, fern, agave, geranium };

struct Pot {
    vec3 at;
    Shape shape;
    float height;
    Plant plant;
    float size;
};

const std::vector<Pot>& pots()
{
    constexpr float edge = half_width - 0.12f, a = aisle_floor, rail = gallery_floor + rail_height;
    static const std::vector<Pot> all{
        // Citrus trees around the fountain, and ferns in urns at the court's corners.
        {{-3.1f, 0, -2.25f}, Shape::planter, 0.62f, Plant::citrus, 1.25f},
        {{3.1f, 0, -2.25f}, Shape::planter, 0.62f, Plant::citrus, 1.15f},
        {{-3.1f, 0, 2.25f}, Shape::planter, 0.62f, Plant::citrus, 1.15f},
        {{3.1f, 0, 2.25f}, Shape::planter, 0.62f, Plant::citrus, 1.25f},
        {{-7.8f, 0, -2.65f}, Shape::urn, 0.95f, Plant::fern, 0.85f},
        {{7.8f, 0, -2.65f}, Shape::urn, 0.95f, Plant::fern, 0.85f},
        {{-7.8f, 0, 2.65f}, Shape::urn, 0.95f, Plant::fern, 0.85f},
        {{7.8f, 0, 2.65f}, Shape::urn, 0.95f, Plant::fern, 0.85f},
        // On the stylobate beside columns.
        {{-5.95f, a, -edge}, Shape::bowl, 0.3f, Plant::geranium, 0.26f},
        {{-1.75f, a, -edge}, Shape::planter, 0.42f, Plant::geranium, 0.27f},
        {{4.55f, a, -edge}, Shape::planter, 0.46f, Plant::agave, 0.62f},
        {{6.1f, a, edge}, Shape::bowl, 0.3f, Plant::geranium, 0.26f},
        {{1.75f, a, edge}, Shape::planter, 0.44f, Plant::agave, 0.6f},
        {{-0.8f, a, edge}, Shape::bowl, 0.3f, Plant::geranium, 0.25f},
        {{-4.5f, a, edge}, Shape::planter, 0.42f, Plant::geranium, 0.27f},
        {{8.95f, a, 0.75f}, Shape::planter, 0.5f, Plant::agave, 0.7f},
        {{8.95f, a, -0.75f}, Shape::planter, 0.5f, Plant::agave, 0.7f},
        // Jars in the aisles.
        {{-2.2f, a, -6.3f}, Shape::jar, 1.05f, Plant::none, 0},
        {{-1.5f, a, -6.4f}, Shape::jar, 0.8f, Plant::none, 0},
        {{4.0f, a, 6.35f}, Shape::jar, 1.1f, Plant::none, 0},
        {{-11.3f, a, 1.9f}, Shape::urn, 0.9f, Plant::fern, 0.75f},
        {{-11.3f, a, -1.9f}, Shape::urn, 0.9f, Plant::fern, 0.75f},
        // Bowls on the gallery's rail.
        {{-7.3f, rail, -half_width}, Shape::bowl, 0.2f, Plant::geranium, 0.2f},
        {{5.7f, rail, -half_width}, Shape::bowl, 0.2f, Plant::geranium, 0.2f},
        {{-2.0f, rail, half_width}, Shape::bowl, 0.2f, Plant::geranium, 0.2f},
        {{half_length, rail, 2.1f}, Shape::bowl, 0.2f, Plant::geranium, 0.2f},
        {{half_length, rail, -2.1f}, Shape::bowl, 0.2f, Plant::geranium, 0.2f},
    };
    return all;
}

} // namespace

void build_pots(Court& court)
{
    std::uint32_t index = 0;
    for (const Pot& pot : pots()) {
        if (pot.height < 0.35f && !court.fine.small_things) {
            continue;
        }
        Random random(court.seed, "pot", index);
        const std::string group = fmt::format("pot_{:02}", index++);
        const mat4 place = moved_to(pot.at) * turned(random.unit() * 2 * pi);
        const Vessel v = draw_vessel(court, group, place, pot.shape, pot.height);
        switch (pot.plant) {
        case Plant::none:
            break;
        case Plant::citrus:
            grow_citrus(court, group, place, v.soil_y, pot.size, random);
            break;
        case Plant::fern:
            grow_rosette(court, group, place, v.soil_y, pot.size, false, random);
            break;
        case Plant::agave:
            grow_rosette(court, group, place, v.soil_y, pot.size, true, random);
            break;
        case Plant::geranium:
            grow_geranium(court, group, place, v.soil_y, pot.size, random);
            break;
        }
    }
}

} // namespace atrium::courtyard
