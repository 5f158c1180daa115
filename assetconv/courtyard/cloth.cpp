#include "assetconv/courtyard/court.hpp"
#include "assetconv/courtyard/shapes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace atrium::courtyard {
namespace {

constexpr float rod_y = springing - 0.27f, rod_half = 1.1f, hem_y = aisle_floor + 0.06f, tie_y = aisle_floor + 1.25f;
constexpr float cloth_thickness = 0.004f;

float smooth(float low, float high, float x)
{
    const float t = glm::clamp((x - low) / (high - low), 0.0f, 1.0f);
    return t * t * (3 - 2 * t);
}

/// One hanging width of cloth. `side` -1: fixed at the left column, +1: at the right.
struct Drape {
    float side;
    float reach; ///< width along the rod, m
    float waist; ///< width where it is tied; 0: hangs free
    int pleats;
    float phase;
    int hue;
};

constexpr std::array<const char*, 3> hues{"cloth_red", "cloth_green", "cloth_blue"};

/// Width of the drape at a height, m.
float width_at(const Drape& d, float y)
{
    if (d.waist <= 0) {
        return d.reach * (1 - 0.03f * smooth(rod_y, hem_y, y));
    }
    if (y > tie_y) {
        const float t = (y - tie_y) / (rod_y - tie_y);
        return d.waist + (d.reach - d.waist) * std::pow(t, 1.7f);
    }
    return d.waist * (1 + 0.75f * std::pow((tie_y - y) / (tie_y - hem_y), 0.7f));
}

SheetPoint drape_point(const Drape& d, float s, float t)
{
    // s runs from left to right; `free` is the share towards the edge that is not at the column.
    const float free = d.side < 0 ? s : 1 - s;
    const float lift = d.waist > 0 ? 0.3f * free * free : 0.0f;
    const float y = hem_y + lift + t * (rod_y + 0.02f - hem_y - lift);
    const float width = width_at(d, y), fullness = std::sqrt(glm::clamp(d.reach / width, 1.0f, 4.0f));
    const float drift = 0.35f * std::sin(3.1f * t + d.phase) + 0.2f * std::sin(7.3f * t + 2 * d.phase);
    const float wave = 2 * pi * static_cast<float>(d.pleats) * s + drift;
    float depth = 0.055f * (0.75f + 0.25f * std::sin(2.3f * s * static_cast<float>(d.pleats) + d.phase)) * fullness;
    depth *= 0.45f + 0.55f * smooth(rod_y, rod_y - 0.5f, y);
    if (d.waist > 0) {
        depth *= 0.55f + 0.45f * smooth(0.05f, 0.5f, std::abs(y - tie_y));
    }
    // No steeper than cloth can lie: the folds of a gathered width stay apart.
    depth = std::min(depth, 0.2f * width / static_cast<float>(d.pleats));
    const float sway = 0.05f * std::sin(1.7f * (rod_y - y) + d.phase) * smooth(rod_y, hem_y, y);
    const float across = width * (free + 0.05f / static_cast<float>(d.pleats) * std::sin(2 * wave));
    const float x = d.side < 0 ? -1.02f + across : 1.02f - across;
    return {{x, y, depth * std::sin(wave) + sway}, {1.9f * d.reach * s, t}};
}

/// A gilt cord around the waist: a ring pressed flat.
void draw_cord(Court& court, const std::string& group, const mat4& place, const Drape& d)
{
    const vec3 middle(d.side * (1.02f - 0.5f * d.waist), tie_y, 0);
    Pen cord = court.pen(group, "gilt", place * moved_to(middle));
    Sheet ring{.pieces_s = 3 * court.fine.cloth,
               .pieces_t = std::max(3, court.fine.cloth),
               .thickness = 0,
               .rims = false,
               .at = {}};
    ring.at = [half = 0.5f * d.waist + 0.004f](float s, float t) {
        const float a = -2 * pi * s, b = 2 * pi * t, thick = 0.021f;
        const float out = 1 + thick / half * std::cos(b);
        return SheetPoint{
            {half * out * std::cos(a), thick * std::sin(b), 0.085f * std::sin(a) + thick * std::cos(b) * std::sin(a)},
            {0.1f * a, 0.1f * b}};
    };
    draw_sheet(cord, ring);
}

void draw_drape(Court& court, const std::string& group, const mat4& place, const Drape& d)
{
    Pen cloth = court.pen(group, hues[static_cast<std::size_t>(d.hue)], place);
    const Sheet sheet{d.pleats * court.fine.cloth, court.fine.small_things ? court.fine.cloth + 4 : 4, cloth_thickness,
                      court.fine.small_things, [&d](float s, float t) { return drape_point(d, s, t); }};
    draw_sheet(cloth, sheet);
    if (d.waist > 0) {
        draw_cord(court, group, place, d);
    }
}

void draw_rod_and_rings(Court& court, const std::string& group, const mat4& place, const std::vector<Drape>& drapes)
{
    Pen iron = court.pen(group, "iron", place);
    draw_rod(iron, {-rod_half, rod_y + 0.05f, 0}, {rod_half, rod_y + 0.05f, 0}, 0.019f, 0.019f, 6);
    if (!court.fine.small_things) {
        return;
    }
    Pen rings = court.pen(group, "bronze", place * turned(0.5f * pi)); // local x is -z of the curtain, z is x
    for (const Drape& d : drapes) {
        for (int i = 0; i < d.pleats; ++i) { // at the crest of each pleat
            const float across = d.reach * (static_cast<float>(i) + 0.25f) / static_cast<float>(d.pleats);
            draw_ring(rings, {0, rod_y + 0.038f, d.side < 0 ? -1.02f + across : 1.02f - across}, 0.036f, 0.006f, 6, 3);
        }
    }
}

struct Curtain {
    SideIndex side;
    int bay, hue;
    enum class Way { both_tied, left_tied, right_tied, closed } way;
};

} // namespace

void build_curtains(Court& court)
{
    using Way = Curtain::Way;
    static const std::array<Curtain, 8> curtains{{{north, 2, 0, Way::both_tied},
                                                  {north, 4, 2, Way::both_tied},
                                                  {north, 6, 1, Way::left_tied},
                                                  {south, 1, 0, Way::closed},
                                                  {south, 3, 2, Way::both_tied},
                                                  {south, 5, 1, Way::both_tied},
                                                  {east, 0, 0, Way::left_tied},
                                                  {east, 2, 0, Way::right_tied}}};
    for (std::size_t i = 0; i < curtains.size(); ++i) {
        const Curtain& c = curtains[i];
        Random random(court.seed, "curtain", static_cast<std::uint32_t>(i));
        const Side& side = sides()[static_cast<std::size_t>(c.side)];
        const mat4 place = side.frame * moved_to({side.bay_centre(c.bay), 0, 0});
        const std::string group = fmt::format("curtain_{}_{:02}", side.name, c.bay);
        std::vector<Drape> drapes;
        const auto hang = [&](float at, float reach, float waist, int pleats) {
            drapes.push_back({at, reach, waist, pleats, random.unit() * 2 * pi, c.hue});
        };
        if (c.way == Way::both_tied || c.way == Way::left_tied) {
            hang(-1, 0.99f, 0.3f, 4);
        }
        if (c.way == Way::both_tied || c.way == Way::right_tied) {
            hang(1, 0.99f, 0.3f, 4);
        }
        if (c.way == Way::closed) {
            hang(-1, 2.0f, 0, 7);
        }
        for (const Drape& d : drapes) {
            draw_drape(court, group, place, d);
        }
        draw_rod_and_rings(court, group, place, drapes);
    }
}

namespace {

/// The way a banner takes over rail and string course, as (z, y), rounded by corner cutting.
std::vector<vec2> banner_path(float length)
{
    const float rail = gallery_floor + rail_height;
    std::vector<vec2> path{{-0.17f, rail - 0.55f}, {-0.165f, rail + 0.012f},       {0.16f, rail + 0.012f},
                           {0.25f, rail - 0.35f},  {0.47f, gallery_floor - 0.03f}, {0.465f, gallery_floor - 0.3f},
                           {0.44f, rail - length}};
    for (int round = 0; round < 3; ++round) {
        std::vector<vec2> cut{path.front()};
        for (std::size_t i = 0; i + 1 < path.size(); ++i) {
            const float share = std::min(0.25f, 0.12f / glm::length(path[i + 1] - path[i]));
            cut.push_back(glm::mix(path[i], path[i + 1], share));
            cut.push_back(glm::mix(path[i + 1], path[i], share));
        }
        cut.push_back(path.back());
        path = cut;
    }
    return path;
}

vec2 walk(const std::vector<vec2>& path, float distance)
{
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        const float step = glm::length(path[i + 1] - path[i]);
        if (distance <= step || i + 2 == path.size()) {
            return glm::mix(path[i], path[i + 1], distance / step);
        }
        distance -= step;
    }
    return path.back();
}

} // namespace

void build_banners(Court& court)
{
    struct Banner {
        SideIndex side;
        int bay, hue;
    };
    static const std::array<Banner, 8> banners{{{north, 1, 2},
                                                {north, 3, 0},
                                                {north, 5, 1},
                                                {south, 0, 1},
                                                {south, 2, 0},
                                                {south, 4, 2},
                                                {south, 6, 0},
                                                {east, 1, 0}}};
    std::uint32_t index = 0;
    for (const Banner& b : banners) {
        Random random(court.seed, "banner", index++);
        const Side& side = sides()[static_cast<std::size_t>(b.side)];
        const std::string group = fmt::format("banner_{}_{:02}", side.name, b.bay);
        Pen cloth = court.pen(group, hues[static_cast<std::size_t>(b.hue)],
                              side.frame * moved_to({side.bay_centre(b.bay), 0, 0}));
        const std::vector<vec2> path = banner_path(2.15f);
        float whole = 0;
        for (std::size_t i = 0; i + 1 < path.size(); ++i) {
            whole += glm::length(path[i + 1] - path[i]);
        }
        const float half = 0.42f, phase = random.unit() * 2 * pi, skew = random.around(0, 0.03f);
        Sheet sheet{court.fine.cloth + 1, 3 * court.fine.cloth, cloth_thickness, true, {}};
        sheet.at = [&](float s, float t) {
            // t = 0 at the pointed foot. The tail is cut to a point.
            const float x = 2 * s - 1, length = whole - 0.22f * std::abs(x);
            const float gone = (1 - t) * length;
            const vec2 at = walk(path, gone);
            const float loose = smooth(1.6f, 3.0f, gone);
            const float wave = 0.022f * loose * std::sin(2.2f * x + 2.1f * gone + phase);
            return SheetPoint{{half * x + skew * loose, at.y, at.x + wave},
                              {0.5f + 0.48f * x, (length - gone + (whole - length)) / whole}};
        };
        draw_sheet(cloth, sheet);
    }
}

} // namespace atrium::courtyard
