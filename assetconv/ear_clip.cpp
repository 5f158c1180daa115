#include "assetconv/ear_clip.hpp"

#include <algorithm>
#include <cmath>

namespace atrium {
namespace {

using dvec2 = glm::dvec2;
using dvec3 = glm::dvec3;

/// Point-in-triangle tests after which the rest is cut without looking: about a second.
constexpr std::uint64_t max_tests = 400'000'000;

/// The polygon seen along its mean normal, counter-clockwise.
std::vector<dvec2> project(std::span<const vec3> polygon)
{
    dvec3 normal(0);
    const dvec3 origin(polygon[0]); // keeps far-away polygons precise
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        normal += glm::cross(dvec3(polygon[i]) - origin, dvec3(polygon[(i + 1) % polygon.size()]) - origin);
    }
    const dvec3 size = glm::abs(normal);
    const int drop = size.x > size.y && size.x > size.z ? 0 : size.y > size.z ? 1 : 2;
    const int u = (drop + 1) % 3, v = (drop + 2) % 3;
    const double flip = normal[drop] < 0 ? -1.0 : 1.0;
    std::vector<dvec2> flat;
    flat.reserve(polygon.size());
    for (const vec3& p : polygon) {
        const dvec3 d = dvec3(p) - origin;
        flat.emplace_back(d[u] * flip, d[v]);
    }
    return flat;
}

double cross(const dvec2& a, const dvec2& b, const dvec2& c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

class Clipper {
public:
    explicit Clipper(std::span<const vec3> polygon) : p_(project(polygon))
    {
        const auto n = static_cast<std::uint32_t>(p_.size());
        previous_.resize(n);
        next_.resize(n);
        for (std::uint32_t i = 0; i < n; ++i) {
            previous_[i] = i == 0 ? n - 1 : i - 1;
            next_[i] = i + 1 == n ? 0 : i + 1;
        }
        for (std::uint32_t i = 0; i < n; ++i) {
            if (turn(i) <= 0) reflex_.push_back(i);
        }
        result_.triangles.reserve(n - 2);
    }

    EarClipping run()
    {
        auto left = static_cast<std::uint32_t>(p_.size());
        std::uint32_t at = 0, tried = 0;
        while (left > 3) {
            if (is_ear(at)) {
                at = clip(at);
                --left;
                tried = 0;
            } else if (++tried > left) {
                at = clip(least_bad(at, left));
                --left;
                tried = 0;
            } else {
                at = next_[at];
            }
        }
        if (turn(at) < 0) result_.simple = false;
        emit(at);
        return std::move(result_);
    }

private:
    [[nodiscard]] double turn(std::uint32_t i) const { return cross(p_[previous_[i]], p_[i], p_[next_[i]]); }

    bool is_ear(std::uint32_t i)
    {
        if (turn(i) <= 0) return false;
        if (tests_ > max_tests) {
            result_.simple = false;
            return true;
        }
        const dvec2 a = p_[previous_[i]], b = p_[i], c = p_[next_[i]];
        const dvec2 low = glm::min(a, glm::min(b, c)), high = glm::max(a, glm::max(b, c));
        tests_ += reflex_.size();
        return std::none_of(reflex_.begin(), reflex_.end(), [&](std::uint32_t r) {
            const dvec2 q = p_[r];
            if (q.x < low.x || q.x > high.x || q.y < low.y || q.y > high.y) return false;
            if (q == a || q == b || q == c) return false;
            return cross(a, b, q) >= 0 && cross(b, c, q) >= 0 && cross(c, a, q) >= 0;
        });
    }

    /// Where no ear is left: a corner on a straight line does no harm; else the polygon crosses itself.
    std::uint32_t least_bad(std::uint32_t at, std::uint32_t left)
    {
        std::uint32_t convex = at;
        bool found = false;
        for (std::uint32_t k = 0; k < left; ++k, at = next_[at]) {
            const double t = turn(at);
            if (t == 0) return at;
            if (t > 0 && !found) {
                convex = at;
                found = true;
            }
        }
        result_.simple = false;
        return convex;
    }

    void emit(std::uint32_t i) { result_.triangles.push_back({previous_[i], i, next_[i]}); }

    /// Returns where to look next: one further on, which spreads the cuts and avoids fans of slivers.
    std::uint32_t clip(std::uint32_t i)
    {
        emit(i);
        const std::uint32_t a = previous_[i], c = next_[i];
        next_[a] = c;
        previous_[c] = a;
        std::erase_if(reflex_, [&](std::uint32_t r) { return r == i || ((r == a || r == c) && turn(r) > 0); });
        return next_[c];
    }

    std::vector<dvec2> p_;
    std::vector<std::uint32_t> previous_, next_, reflex_;
    EarClipping result_;
    std::uint64_t tests_ = 0;
};

} // namespace

EarClipping clip_ears(std::span<const vec3> polygon)
{
    if (polygon.size() == 3) return {{{0, 1, 2}}, true};
    return Clipper(polygon).run();
}

} // namespace atrium
