#include "assetconv/courtyard/arch.hpp"
#include "assetconv/courtyard/court.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace atrium::courtyard {
namespace {

struct Storey {
    const char* name;
    ArchShape shape;
    float springing_y, top_y, half; ///< heights in the world, half the wall's thickness
    float ring, moulding;           ///< widths of voussoirs and archivolt
    int stones;
    bool voussoirs; ///< single stones in the arch, or a smooth band
    const char* front;
    const char* back;
};

const Storey lower{
    "arcade", {arch_half_span, arch_rise}, springing,      string_course_bottom + 0.04f, wall_half, 0.2f, 0.075f, 13,
    true,     "limestone_ashlar",          "plaster_vault"};
const Storey upper{"loggia",        {upper_half_span, upper_rise},
                   upper_springing, gallery_ceiling + 0.1f,
                   upper_wall_half, 0.15f,
                   0.055f,          7,
                   false,           "plaster_ochre",
                   "plaster_vault"};

/// As many as the joints need, or as the detail asks where there are none.
int segments_of(const Storey& s, const Fineness& f)
{
    return s.voussoirs && f.voussoirs ? s.stones * f.voussoir : f.arch;
}

Profile archivolt_profile(float inner, float width, const Cut& cut)
{
    // x away from the wall, y outwards from the intrados: a fillet, a hollow, a round lip, and back to the wall.
    ProfilePath p({0.018f, inner - 0.004f}, cut);
    p.by(0.022f, 0).by(0, 0.18f * width);
    p.ovolo(0.012f, 0.1f * width).torus(0.3f * width).by(0.012f, 0).by(0, 0.32f * width);
    p.to(-0.02f, p.end().y);
    return p.finish(0.005f);
}

/// Mouldings of the face that looks at the court.
void draw_court_face(Court& court, Pen& trim, const Storey& s)
{
    const Fineness& f = court.fine;
    const int segments = segments_of(s, f);
    if (s.voussoirs && f.voussoirs) {
        draw_voussoirs(trim, s.shape, {.stones = s.stones, .segments = f.voussoir, .depth = s.ring, .z = s.half});
    } else { // one smooth band
        ProfilePath band({-0.03f, 0}, f.cut);
        band.to(0.025f, 0).to(0.025f, s.ring + 0.02f);
        draw_archivolt(trim, s.shape, band.finish(0.009f), s.half, segments);
    }
    if (!f.small_things) {
        return;
    }
    draw_keystone(trim, s.shape, s.ring + s.moulding + 0.02f,
                  0.62f * s.shape.extent() * 2 / static_cast<float>(s.stones), s.half - 0.05f, s.half + 0.085f);
    draw_archivolt(trim, s.shape, archivolt_profile(s.ring, s.moulding, f.cut.coarser()), s.half, segments);
}

/// A plain ring on the face that looks into the aisle: one strip, with a chamfer to the soffit.
void draw_aisle_face(Pen& trim, const Storey& s, int segments, const Cut& cut)
{
    ProfilePath p({-0.03f, 0}, cut);
    p.by(0.048f, 0).by(0, 0.72f * s.ring).by(-0.048f, 0);
    draw_archivolt(trim, s.shape, p.finish(0.006f), s.half, segments);
}

void draw_bay(Court& court, const Side& side, int i, const Storey& s)
{
    const int segments = segments_of(s, court.fine);
    const std::string group = fmt::format("{}_{}_{:02}", s.name, side.name, i);
    const mat4 front = side.frame * moved_to({side.bay_centre(i), s.springing_y, 0});
    const mat4 back = front * turned(pi);
    const bool first = i == 0, last = i + 1 == side.bays;
    const float half_bay = 0.5f * bay, height = s.top_y - s.springing_y;
    const auto index = static_cast<float>(i);

    Pen wall = court.pen(group, s.front, front);
    // v: the ochre plaster's stains begin below the eaves, at the top of its texture.
    const bool plaster = std::string_view(s.front) == "plaster_ochre";
    const float v = plaster ? plaster_tile - height : s.springing_y;
    draw_pierced_wall(wall, s.shape,
                      {first ? -half_bay + s.half : -half_bay,
                       last ? half_bay - s.half : half_bay,
                       height,
                       s.half,
                       0.1f,
                       {side.half + bay * index, v}},
                      segments);
    Pen inner = court.pen(group, s.back, back);
    draw_pierced_wall(inner, s.shape,
                      {last ? -half_bay - s.half : -half_bay,
                       first ? half_bay + s.half : half_bay,
                       height,
                       s.half,
                       0.1f,
                       {-bay * index, s.springing_y}},
                      segments);
    Pen trim = court.pen(group, "limestone_trim", front);
    trim.set_uv_offset({0.31f * index, 0.17f * index});
    draw_soffit(trim, s.shape, -s.half - 0.009f, s.half + 0.016f, segments);
    draw_court_face(court, trim, s);
    if (!court.fine.small_things) {
        return;
    }
    Pen ring = court.pen(group, "limestone_trim", back);
    draw_aisle_face(ring, s, segments / 2 + 1, court.fine.cut.coarser());
    if (s.voussoirs) {
        return;
    }
    // A flat arch's mouldings end in the air beside it: a block above each capital takes them up.
    const float reach = half_bay - s.shape.half_span + 0.01f, depth = s.half + 0.07f;
    const float lift = side.bays == long_bays ? 0.0f : 0.006f; // in the corners two of them meet
    for (const float sign : {-1.0f, 1.0f}) {
        const float axis = sign * half_bay, inner_face = axis - sign * reach;
        draw_box(trim, {{std::min(axis, inner_face), -0.01f - lift, -depth},
                        {std::max(axis, inner_face), 0.13f - lift, depth},
                        0.01f,
                        sign < 0 ? face_left : face_right});
    }
}

} // namespace

void build_arcades(Court& court)
{
    for (const Storey* storey : {&lower, &upper}) {
        for (const Side& side : sides()) {
            for (int i = 0; i < side.bays; ++i) {
                draw_bay(court, side, i, *storey);
            }
        }
    }
}

} // namespace atrium::courtyard
