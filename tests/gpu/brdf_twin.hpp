#pragma once
// The material model of shaders/lib/brdf.glsl once more, in double precision and without its shortcuts.
// Source: Walter et al. 2007; Heitz 2014; Schlick 1994.

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>

namespace atrium {

inline glm::dvec3 brdf_twin(const glm::dvec3& base, double metallic, double roughness, double specular, double n_v,
                            double n_l, double v_l)
{
    constexpr double pi_twin = 3.14159265358979323846;
    const double r = std::max(roughness, 0.045), alpha = r * r, a2 = alpha * alpha;
    const double h = std::sqrt(2 + 2 * v_l); // |v + l|
    const double n_h = (n_l + n_v) / h, v_h = (1 + v_l) / h;
    const double d = a2 / (pi_twin * std::pow(n_h * n_h * (a2 - 1) + 1, 2));
    const double v = 0.5 / (n_l * std::sqrt(n_v * n_v * (1 - a2) + a2) + n_v * std::sqrt(n_l * n_l * (1 - a2) + a2));
    const glm::dvec3 f0 = glm::mix(glm::dvec3(specular), base, metallic);
    const double f90 = std::clamp(16.5 * (f0.x + f0.y + f0.z), 0.0, 1.0);
    const glm::dvec3 f = f0 + (glm::dvec3(f90) - f0) * std::pow(1 - v_h, 5);
    return base * ((1 - metallic) / pi_twin) + f * (d * v);
}

} // namespace atrium
