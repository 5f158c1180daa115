#pragma once
// The shapes that the court is made of. All draw through a pen, in its local space, in metres.

#include "assetconv/courtyard/mesh.hpp"
#include "assetconv/courtyard/profile.hpp"

#include <array>
#include <functional>

namespace atrium::courtyard {

/// Faces of a box that are left out because something stands against them.
enum BoxFace : unsigned {
    face_left = 1,
    face_right = 2,
    face_bottom = 4,
    face_top = 8,
    face_back = 16,
    face_front = 32
};

/// A box between two corners with chamfered edges. Texture by the dominant axis; with `grain_along_x` off, u runs
/// along the longest edge, as the grain of timber does.
struct Box {
    vec3 low{0}, high{1};
    float chamfer = 0.01f;
    unsigned without = 0;
    bool grain = false;
};
void draw_box(Pen& pen, const Box& box);

/// Turns the profile about y. u goes `u_repeats` times around in whole repeats of the texture (0: as fits), v along
/// the profile. `squash` narrows the turned thing along z.
struct Lathe {
    int segments = 24;
    int u_repeats = 0;
    bool unit_v = false;  ///< v from 0 to 1 over the whole profile, in place of metres
    bool faceted = false; ///< flat sides, as of an octagon
    float sweep = 2 * pi; ///< angle turned
};
void draw_lathe(Pen& pen, const Profile& profile, const Lathe& lathe);

/// Carries the profile around a rectangle of half sizes (half_x, half_z): outwards (a plinth) or, `inwards`, around
/// the inside of a court (a cornice). Corners are mitred; outward ones are chamfered.
struct RectSweep {
    float half_x = 1, half_z = 1;
    bool inwards = false;
    float chamfer = 0.008f;
    int pieces = 1; ///< along each side
};
void draw_rect_sweep(Pen& pen, const Profile& profile, const RectSweep& sweep);

/// Carries the profile (x along local z, y up) along local x from `from` to `to`; with `caps` the ends are closed by
/// fans about the profile's first point.
void draw_straight_sweep(Pen& pen, const Profile& profile, float from, float to, int pieces = 1, bool caps = false);

/// A flat disc facing up, from `inner` to `outer` radius.
void draw_disc(Pen& pen, float y, float inner, float outer, int segments);

/// A flat grid from `origin` along two edges; normal = cross(edge_u, edge_v); u and v in metres along the edges.
void draw_plane(Pen& pen, vec3 origin, vec3 edge_u, vec3 edge_v, int pieces_u = 1, int pieces_v = 1,
                vec2 uv_origin = vec2(0));

/// A curved sheet: `at` gives position (and uv) for (s, t) in [0, 1]; the front is cross(d/ds, d/dt).
/// With `thickness` it gets a back that far behind and closed rims, so that it is solid from both sides.
struct SheetPoint {
    vec3 position{0};
    vec2 uv{0};
};
struct Sheet {
    int pieces_s = 8, pieces_t = 8;
    float thickness = 0;
    bool rims = true;
    std::function<SheetPoint(float s, float t)> at;
};
void draw_sheet(Pen& pen, const Sheet& sheet);

/// A round rod between two points, open at its ends.
void draw_rod(Pen& pen, vec3 from, vec3 to, float radius_from, float radius_to, int segments);
/// A ring of round section about local z.
void draw_ring(Pen& pen, vec3 centre, float radius, float thickness, int segments, int around);
/// A ball, poles along y.
void draw_ball(Pen& pen, vec3 centre, float radius, int segments);

} // namespace atrium::courtyard
