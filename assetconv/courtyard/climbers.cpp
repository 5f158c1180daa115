// What hangs and climbs: ivy from the gallery's edge, wisteria along the eaves, ivy up two corners.
#include "assetconv/courtyard/court.hpp"
#include "assetconv/courtyard/leaves.hpp"
#include "assetconv/courtyard/shapes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace atrium::courtyard {
namespace {

float leaf_size(const Court& court)
{
    return std::pow(court.fine.leaves, -0.3f);
}

/// How rich the growth is at x along a ledge: a few slow waves, from 0 to 1.
float richness(float x, float phase)
{
    return glm::clamp(0.5f + 0.38f * std::sin(0.9f * x + phase) + 0.3f * std::sin(2.3f * x + 2.1f * phase), 0.0f, 1.0f);
}

struct Ledge {
    SideIndex side;
    float from, to; ///< local x
    float y, z;     ///< the edge that strands fall from
    float longest;
    float spacing; ///< at high detail
    bool wisteria;
};

/// A strand that falls from `start`: leaves alternate left and right and hang.
void draw_strand(Court& court, Pen& leaves, Pen& bark, vec3 start, float length, bool wisteria, Random& random)
{
    const float size = leaf_size(court), step = (wisteria ? 0.13f : 0.12f) * size * size;
    const float phase = random.unit() * 2 * pi, sway = 0.045f * length;
    const auto at = [&](float down) {
        const float t = down / length;
        const float out = 0.07f * std::min(1.0f, down / 0.1f) + 0.03f * std::sin(4 * t + phase);
        return start + vec3(sway * t * std::sin(2.7f * t + phase), -down, out);
    };
    const int pieces = std::max(2, static_cast<int>(length / 0.35f));
    for (int i = 0; i < (court.fine.small_things ? pieces : 0); ++i) {
        const float a = length * static_cast<float>(i) / static_cast<float>(pieces),
                    b = a + length / static_cast<float>(pieces);
        draw_rod(bark, at(a), at(b), 0.006f * (1 - 0.7f * a / length), 0.006f * (1 - 0.7f * b / length), 3);
    }
    int index = 0;
    for (float down = 0.02f; down < length; down += step * random.between(0.7f, 1.3f)) {
        const float young = 1 - 0.45f * down / length; // leaves are smaller towards the tip
        const float yaw = (index++ % 2 == 0 ? 1.0f : -1.0f) * random.between(0.2f, 1.5f);
        const vec3 out(std::sin(yaw), 0, std::cos(yaw));
        const vec3 along = glm::normalize(out * random.between(0.5f, 1.0f) + vec3(0, random.between(-1.2f, -0.3f), 0));
        const vec3 facing = glm::normalize(out + vec3(0, 0.5f, 0));
        const float l = (wisteria ? random.between(0.2f, 0.3f) : random.between(0.15f, 0.24f)) * young * size;
        draw_leaf_card(leaves, {at(down), along, facing, l, (wisteria ? 0.5f : 1.0f) * l, 0.5f, wisteria ? 2 : 1,
                                wisteria ? cell_pinnate : cell_ivy, 0.6f * vec3(0, 0.3f, 1)});
    }
}

void draw_raceme(Pen& pen, vec3 from, float length, Random& random)
{
    const float turn = random.unit() * pi;
    for (int k = 0; k < 2; ++k) {
        const float a = turn + 0.5f * pi * static_cast<float>(k);
        const vec3 facing = glm::normalize(vec3(std::sin(a), 0, std::abs(std::cos(a)) + 0.05f));
        // The picture stands on its stalk: here it hangs by it.
        draw_leaf_card(pen, {from, {0, -1, 0}, facing, length, 0.42f * length, 0, 1, cell_raceme, vec3(0, 0.2f, 0.5f)});
    }
}

void grow_ledge(Court& court, const Ledge& ledge, std::uint32_t index)
{
    const Side& side = sides()[static_cast<std::size_t>(ledge.side)];
    Random random(court.seed, "ledge", index);
    const std::string group = fmt::format("{}_{}_{:02}", ledge.wisteria ? "wisteria" : "ivy", side.name, index);
    Pen leaves = court.pen(group, ledge.wisteria ? "frond" : "leaf", side.frame);
    Pen bark = court.pen(group, "bark", side.frame);
    const float phase = random.unit() * 2 * pi, spacing = ledge.spacing / std::sqrt(court.fine.leaves);
    // The vine that lies on the ledge.
    vec3 before(ledge.from - 0.1f, ledge.y + 0.03f, ledge.z - 0.06f);
    for (float x = ledge.from; x < ledge.to; x += 0.3f) {
        const vec3 now(x + 0.15f, ledge.y + 0.04f + random.around(0, 0.03f), ledge.z - 0.06f + random.around(0, 0.04f));
        const float thick = ledge.wisteria ? 0.026f : 0.012f;
        draw_rod(bark, before, now, thick, thick, court.fine.small_things ? 5 : 3);
        before = now;
    }
    for (float x = ledge.from; x < ledge.to; x += spacing * random.between(0.5f, 1.5f)) {
        const float ends = std::min({1.0f, (x - ledge.from) / 0.7f + 0.25f, (ledge.to - x) / 0.7f + 0.25f});
        const float length = ledge.longest * ends * (0.15f + 0.85f * richness(x, phase)) * random.between(0.45f, 1.0f);
        const vec3 start(x, ledge.y + random.around(0.02f, 0.03f), ledge.z + random.around(-0.02f, 0.05f));
        if (length > 0.12f) {
            draw_strand(court, leaves, bark, start, length, ledge.wisteria, random);
        }
        const int tufts = 2; // leaves that stand up from the ledge and hide the strand's start
        for (int i = 0; i < tufts; ++i) {
            const vec3 out = glm::normalize(any_direction(random) + vec3(0, 0.5f, 0.9f));
            const float l = (ledge.wisteria ? 0.26f : 0.2f) * random.between(0.7f, 1.1f) * leaf_size(court);
            draw_leaf_card(leaves,
                           {start + 0.05f * any_direction(random) + vec3(0, 0, -0.03f), out,
                            glm::normalize(vec3(0, 1, 0.5f) + 0.3f * out), l, (ledge.wisteria ? 0.5f : 1.0f) * l, 0.9f,
                            ledge.wisteria ? 2 : 1, ledge.wisteria ? cell_pinnate : cell_ivy, vec3(0, 0.5f, 0.5f)});
        }
        if (ledge.wisteria && random.chance(0.75f)) {
            const vec3 from = start + vec3(random.around(0, 0.1f), -random.between(0, 0.6f) * length,
                                           0.07f + random.around(0, 0.05f));
            draw_raceme(leaves, from, random.between(0.32f, 0.6f) * std::sqrt(leaf_size(court)), random);
        }
    }
}

/// A stem that winds upwards along a corner, from the court's floor.
void draw_stem(Pen& bark, vec3 foot, float top, float radius, Random& random)
{
    const float phase = random.unit() * 2 * pi;
    const auto at = [&](float y) {
        return foot + vec3(0.07f * std::sin(1.9f * y + phase), y, 0.05f * std::sin(2.6f * y + 1.3f * phase));
    };
    constexpr float step = 0.42f;
    for (float y = -0.05f; y < top; y += step) {
        const float a = radius * (1 - 0.6f * y / top), b = radius * (1 - 0.6f * (y + step) / top);
        draw_rod(bark, at(y), at(y + step), a, b, 4);
    }
}

/// Ivy that covers the corner between two walls of the court: the inner faces of the corner's pier and the spandrels.
void grow_corner(Court& court, const Side& side, float height, std::uint32_t index)
{
    Random random(court.seed, "corner", index);
    const std::string group = fmt::format("climber_{}", side.name);
    // Local space of the corner: its origin on the pier's axis, x along this side, z along the next, both into the
    // court.
    const mat4 place = side.frame * moved_to({-side.half, 0, 0});
    Pen leaves = court.pen(group, "leaf", place);
    Pen bark = court.pen(group, "bark", place);
    for (int i = 0; i < (court.fine.small_things ? 3 : 1); ++i) {
        const vec3 foot(0.36f + 0.1f * static_cast<float>(i), aisle_floor, 0.36f + random.around(0, 0.05f));
        draw_stem(bark, foot, height * (0.95f - 0.15f * static_cast<float>(i)), 0.035f, random);
    }
    const int count = std::max(60, static_cast<int>(1100 * court.fine.leaves));
    const float phase = random.unit() * 2 * pi;
    for (int i = 0; i < count; ++i) {
        const float share = std::pow(random.unit(), 0.75f), y = aisle_floor + 0.05f + share * height;
        const bool on_x = random.chance(0.5f);
        // Around the pier it stays close; above the springing there are walls on both sides to spread over.
        const bool below = y < springing - 0.2f;
        const float crest = std::exp(-0.9f * (y - springing - 0.7f) * (y - springing - 0.7f));
        const float lobes = 1 + 0.35f * std::sin(2.4f * y + phase + (on_x ? 0.0f : 2.0f));
        const float spread = below ? 0.2f : (0.22f + 0.85f * crest) * lobes * (1.1f - 0.6f * share * share);
        const float face = below ? 0.32f : wall_half + 0.05f;
        const float off = spread * random.unit() * (0.35f + 0.65f * random.unit()) - (below ? 0.25f : 0.0f);
        const float depth = face + 0.02f + 0.16f * random.unit() * random.unit();
        const vec3 at =
            on_x ? vec3(std::max(face + off, 0.05f), y, depth) : vec3(depth, y, std::max(face + off, 0.05f));
        const vec3 out = glm::normalize(vec3(on_x ? 0.3f : 1.0f, 0.25f, on_x ? 1.0f : 0.3f));
        const vec3 along = glm::normalize(
            vec3(random.around(0, 0.8f), random.around(-0.55f, 0.55f), random.around(0, 0.8f)) + 0.2f * out);
        const float l = random.between(0.17f, 0.28f) * leaf_size(court);
        draw_leaf_card(leaves, {at, along, glm::normalize(out + 0.35f * any_direction(random)), l, l, 0.5f, 1, cell_ivy,
                                0.7f * out});
    }
}

} // namespace

void build_hanging_plants(Court& court)
{
    constexpr float lip_y = gallery_floor - 0.05f, lip_z = wall_half + 0.16f;
    const Ledge ledges[] = {
        {north, -8.6f, -6.1f, lip_y, lip_z, 1.5f, 0.075f, false},
        {north, -2.3f, -0.6f, lip_y, lip_z, 1.1f, 0.075f, false},
        {north, 1.9f, 4.0f, lip_y, lip_z, 1.2f, 0.075f, false},
        {south, -3.6f, -1.5f, lip_y, lip_z, 1.3f, 0.075f, false},
        {south, 3.4f, 6.0f, lip_y, lip_z, 1.0f, 0.075f, false},
        {east, 1.1f, 3.5f, lip_y, lip_z, 1.4f, 0.075f, false},
        {west, -3.4f, -1.2f, lip_y, lip_z, 1.3f, 0.075f, false},
        {north, 3.2f, 8.3f, eaves_top + 0.1f, eaves_overhang + 0.0f, 1.35f, 0.1f, true},
        {east, -3.2f, -0.4f, eaves_top + 0.1f, eaves_overhang + 0.0f, 1.2f, 0.1f, true},
        {south, -8.2f, -4.6f, eaves_top + 0.1f, eaves_overhang + 0.0f, 1.1f, 0.1f, true},
    };
    std::uint32_t index = 0;
    for (const Ledge& ledge : ledges) {
        grow_ledge(court, ledge, index++);
    }
}

void build_climbers(Court& court)
{
    grow_corner(court, sides()[east], 7.4f, 0);  // the corner of north and east
    grow_corner(court, sides()[north], 5.6f, 1); // west and north
    grow_corner(court, sides()[west], 4.6f, 2);  // south and west
}

} // namespace atrium::courtyard
