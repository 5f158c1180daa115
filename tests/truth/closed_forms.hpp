#pragma once
// Ambient visibility that is known in closed form: by Nusselt's analogue cosine-weighted directions are points of the
// unit disc, so answers are areas over pi.

#include <cmath>
#include <numbers>

namespace atrium::truth {

/// Share of the disc beyond a chord at distance k: what an endless wall at k radii takes.
inline double beyond_chord(double k)
{
    return k >= 1 ? 0 : (std::acos(k) - k * std::sqrt(1 - k * k)) / std::numbers::pi;
}

/// Share of the disc beyond both of two chords at right angles: what two walls take twice.
inline double beyond_both(double a, double b)
{
    if (a * a + b * b >= 1) return 0;
    const auto f = [b](double u) { return 0.5 * (u * std::sqrt(1 - u * u) + std::asin(u)) - b * u; };
    return (f(std::sqrt(1 - b * b)) - f(a)) / std::numbers::pi;
}

} // namespace atrium::truth
