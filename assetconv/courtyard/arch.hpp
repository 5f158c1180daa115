#pragma once
// An arch in the plane of its wall: x along the wall from the arch's middle, y up from the springing line.

#include "assetconv/courtyard/shapes.hpp"

#include <cmath>

namespace atrium::courtyard {

/// A circular arc through both springing points and the crown; a semicircle when rise = half_span.
struct ArchShape {
    float half_span, rise;
    [[nodiscard]] float radius() const { return (half_span * half_span + rise * rise) / (2 * rise); }
    [[nodiscard]] float centre() const { return rise - radius(); }
    /// Half the angle of the arc; angles count from the crown, positive towards +x.
    [[nodiscard]] float extent() const { return std::asin(std::min(1.0f, half_span / radius())); }
    /// The point at that angle, `beyond` outside the intrados.
    [[nodiscard]] vec2 at(float angle, float beyond) const
    {
        const float r = radius() + beyond;
        return {r * std::sin(angle), centre() + r * std::cos(angle)};
    }
    [[nodiscard]] vec2 outwards(float angle) const { return {std::sin(angle), std::cos(angle)}; }
};

/// The wall around the arch, from `left` to `right` and up to `top`, in the plane z, facing +z. The opening is
/// `margin` larger than the intrados: its edge hides behind the voussoirs.
struct PiercedWall {
    float left, right, top, z, margin;
    vec2 uv_origin{0};
};
void draw_pierced_wall(Pen& pen, const ArchShape& arch, const PiercedWall& wall, int segments);

/// The underside from z = back to z = front.
void draw_soffit(Pen& pen, const ArchShape& arch, float back, float front, int segments);

/// Wedge stones with chamfered joints in front of the wall at z; an odd number, the middle left to the keystone.
struct VoussoirRing {
    int stones = 13, segments = 2;
    float depth = 0.2f; ///< from intrados to extrados
    float z = 0.25f, proud = 0.025f, chamfer = 0.009f;
    bool keystone = true;
};
void draw_voussoirs(Pen& pen, const ArchShape& arch, const VoussoirRing& ring);

/// Mouldings around the arch: the profile's x is away from the wall at z, its y outwards from the intrados.
void draw_archivolt(Pen& pen, const ArchShape& arch, const Profile& profile, float z, int segments);

/// The wedge at the crown.
void draw_keystone(Pen& pen, const ArchShape& arch, float depth, float half_angle, float back, float front);

} // namespace atrium::courtyard
