#include "assetconv/courtyard/profile.hpp"

#include <algorithm>
#include <cmath>

namespace atrium::courtyard {
namespace {

constexpr float sharp_cosine = 0.85f; // edges that turn by more than 32 degrees are chamfered

/// To the right of the direction of travel: outwards, when the path goes up.
vec2 right_of(vec2 direction)
{
    return {direction.y, -direction.x};
}

/// The normal where a path bends gently: a long straight piece beside a short curved one keeps its own.
vec2 smooth_normal(vec2 in, float in_length, vec2 out, float out_length)
{
    if (in_length > 3 * out_length) {
        return right_of(in);
    }
    if (out_length > 3 * in_length) {
        return right_of(out);
    }
    return right_of(glm::normalize(in + out));
}

} // namespace

ProfilePath& ProfilePath::to(float x, float y)
{
    points_.emplace_back(x, y);
    return *this;
}

ProfilePath& ProfilePath::by(float dx, float dy)
{
    return to(end().x + dx, end().y + dy);
}

ProfilePath& ProfilePath::ellipse(float dx, float dy, bool sideways_first)
{
    const vec2 start = end();
    for (int i = 1; i <= cut_.curve; ++i) {
        const float t = 0.5f * pi * static_cast<float>(i) / static_cast<float>(cut_.curve);
        const float rising = std::sin(t), late = 1 - std::cos(t);
        points_.push_back(start + (sideways_first ? vec2(dx * rising, dy * late) : vec2(dx * late, dy * rising)));
    }
    return *this;
}

ProfilePath& ProfilePath::ovolo(float dx, float dy)
{
    return ellipse(dx, dy, true);
}
ProfilePath& ProfilePath::cavetto(float dx, float dy)
{
    return ellipse(dx, dy, false);
}

ProfilePath& ProfilePath::torus(float height)
{
    const float half = 0.5f * height;
    return ellipse(half, half, true).ellipse(-half, half, false);
}

ProfilePath& ProfilePath::scotia(float height, float depth)
{
    return ellipse(-depth, 0.5f * height, true).ellipse(depth, 0.5f * height, false);
}

ProfilePath& ProfilePath::cyma(float dx, float dy)
{
    return ovolo(0.5f * dx, 0.5f * dy).cavetto(0.5f * dx, 0.5f * dy);
}

namespace {

/// Keeps, of the points from `first` to `last`, those that stand out by more than `tolerance`; source: Douglas and
/// Peucker 1973.
void keep_outstanding(const std::vector<vec2>& p, std::size_t first, std::size_t last, float tolerance,
                      std::vector<bool>& keep)
{
    const vec2 line = p[last] - p[first];
    const float length = std::max(1e-6f, glm::length(line));
    float most = tolerance;
    std::size_t at = first;
    for (std::size_t i = first + 1; i < last; ++i) {
        const vec2 off = p[i] - p[first];
        const float along = glm::clamp(glm::dot(off, line) / (length * length), 0.0f, 1.0f);
        const float distance = glm::length(off - along * line);
        if (distance > most) {
            most = distance;
            at = i;
        }
    }
    if (at == first) {
        return;
    }
    keep[at] = true;
    keep_outstanding(p, first, at, tolerance, keep);
    keep_outstanding(p, at, last, tolerance, keep);
}

std::vector<vec2> simplified(const std::vector<vec2>& points, float tolerance)
{
    std::vector<bool> keep(points.size(), false);
    keep.front() = keep.back() = true;
    keep_outstanding(points, 0, points.size() - 1, std::max(tolerance, 1e-5f), keep);
    std::vector<vec2> kept;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (keep[i] && (kept.empty() || glm::length(points[i] - kept.back()) > 1e-5f)) {
            kept.push_back(points[i]);
        }
    }
    return kept;
}

} // namespace

Profile ProfilePath::finish(float chamfer) const
{
    const std::vector<vec2> p = simplified(points_, cut_.tolerance);
    if (chamfer < cut_.least_chamfer) {
        chamfer = 0;
    }
    Profile profile;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const bool first = i == 0, last = i + 1 == p.size();
        const vec2 to_here = first ? p[1] - p[0] : p[i] - p[i - 1];
        const vec2 from_here = last ? to_here : p[i + 1] - p[i];
        const float in_length = glm::length(to_here), out_length = glm::length(from_here);
        const vec2 in = to_here / in_length, out = from_here / out_length;
        if (glm::dot(in, out) >= sharp_cosine) {
            profile.push_back({p[i], smooth_normal(in, in_length, out, out_length), 0});
        } else {
            const float cut = std::min(chamfer, 0.4f * std::min(in_length, out_length));
            profile.push_back({p[i] - cut * in, right_of(in), 0});
            profile.push_back({p[i] + cut * out, right_of(out), 0});
        }
    }
    for (std::size_t i = 1; i < profile.size(); ++i) {
        profile[i].length = profile[i - 1].length + glm::length(profile[i].at - profile[i - 1].at);
    }
    return profile;
}

} // namespace atrium::courtyard
