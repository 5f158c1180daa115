#pragma once
// Profiles of mouldings and turned things: a line in the plane (distance outwards, height) with its normals.

#include "renderer/core/math.hpp"

#include <vector>

namespace atrium::courtyard {

struct ProfilePoint {
    vec2 at{0};        ///< x outwards (a lathe's radius), y up
    vec2 normal{1, 0}; ///< of unit length
    float length = 0;  ///< along the profile from its start
};
using Profile = std::vector<ProfilePoint>;

/// How finely profiles are cut.
struct Cut {
    int curve = 2;           ///< segments of a quarter circle
    float tolerance = 0;     ///< m; points nearer than this to the line between their neighbours are left out
    float least_chamfer = 0; ///< m; smaller chamfers are not made, their corners stay sharp
    [[nodiscard]] Cut coarser() const { return {curve > 1 ? curve - 1 : 1, 1.5f * tolerance, least_chamfer}; }
};

/// Draws a profile from below upwards, the solid on its left side. Metres.
class ProfilePath {
public:
    ProfilePath(vec2 start, const Cut& cut) : points_{start}, cut_(cut) {}

    ProfilePath& to(float x, float y);
    ProfilePath& by(float dx, float dy);
    /// Quarter ellipse that leaves sideways and arrives upright: convex going outwards (ovolo).
    ProfilePath& ovolo(float dx, float dy);
    /// Quarter ellipse that leaves upright and arrives sideways: hollow going outwards (cavetto).
    ProfilePath& cavetto(float dx, float dy);
    /// Half round, as high as `height`, swelling outwards.
    ProfilePath& torus(float height);
    /// Half round, hollow, sinking inwards by `depth`.
    ProfilePath& scotia(float height, float depth);
    /// S-curve: cavetto above ovolo.
    ProfilePath& cyma(float dx, float dy);

    [[nodiscard]] vec2 end() const { return points_.back(); }
    /// Cuts each sharp corner by a chamfer of `chamfer` metres, whose ends carry the normals of the faces beside it:
    /// flat faces stay flat, and edges catch light.
    [[nodiscard]] Profile finish(float chamfer) const;

private:
    ProfilePath& ellipse(float dx, float dy, bool sideways_first);

    std::vector<vec2> points_;
    Cut cut_;
};

} // namespace atrium::courtyard
