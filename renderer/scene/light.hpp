#pragma once
// Lights as users describe them (the command line's SPEC, TOML). Units are photometric-like; the exposure turns them
// into a picture.

#include "renderer/core/error.hpp"
#include "renderer/core/math.hpp"
#include "renderer/core/setting.hpp"
#include "renderer/scene/camera.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace atrium {

enum class LightType : std::uint8_t { sun, spot, point, rect };
[[nodiscard]] const char* to_string(LightType t);

inline constexpr int max_lights = 64;

/// Fields that a type does not have keep their defaults. Angles are degrees here, as typed.
struct Light {
    LightType type = LightType::sun;
    std::string name;             ///< "light<index>" when the user gave none
    vec3 position{0};             ///< m; spot, point, rect (centre)
    vec3 direction{0, -1, 0};     ///< that the light travels (sun: -0.3:-1:-0.2); rect: its normal. Not normalised
    vec3 up{0, 1, 0};             ///< rect; +X where parallel to direction
    vec3 color{1};                ///< linear RGB, multiplies
    float illuminance = 10;       ///< sun, lux-like, on a plane facing it
    float intensity = 100;        ///< spot, point, candela-like
    float radiance = 10;          ///< rect, nit-like
    float angle = 0.53f;          ///< sun, diameter, degrees
    float inner = 20, outer = 30; ///< spot, half angles, degrees; outer <= 80
    float size = 0.05f;           ///< spot, point: radius, m
    float range = 0;              ///< spot, point: m; 0 = none
    float width = 1, height = 1;  ///< rect, m
    bool shadow = true;
    /// Identifies the light from frame to frame (LightSet::keys); 0: its name does. It does not affect the picture:
    /// neither written to files nor compared.
    std::uint32_t id = 0;

    bool operator==(const Light& other) const;
};

/// A light of the type as it is before any key is given.
[[nodiscard]] Light default_light(LightType type);

/// The keys that the light's type has, for a SettingList or any other visitor. `position` is required of the types
/// that have it; the rules between keys are check_light's.
template <class V>
void describe(V& v, Light& l)
{
    constexpr Range amount{0.0f, 1e9f}, metres{1e-4f, 1e4f};
    v.group("", "Light");
    v("name", l.name, "Name; light<index> when empty");
    v("color", l.color, "Linear RGB, multiplies", amount);
    v("shadow", l.shadow, "Cast shadows");
    if (l.type != LightType::sun) v("position", l.position, "Where it stands; a rect's centre", world_range, "m");
    if (l.type != LightType::point)
        v("direction", l.direction, "Where its light travels; a rect's normal", world_range);
    switch (l.type) {
    case LightType::sun:
        v("illuminance", l.illuminance, "On a plane that faces it", amount, "lx");
        v("angle", l.angle, "Diameter in the sky", Range{0.0f, 90.0f}, "degrees");
        break;
    case LightType::spot:
        v("inner", l.inner, "Half angle within which it is full", Range{0.0f, 80.0f}, "degrees");
        v("outer", l.outer, "Half angle beyond which it is dark", Range{0.1f, 80.0f}, "degrees");
        [[fallthrough]];
    case LightType::point:
        v("intensity", l.intensity, "Along its axis", amount, "cd");
        v("size", l.size, "Radius", metres, "m");
        v("range", l.range, "Distance beyond which it is dark; 0: none", Range{0.0f, 1e6f}, "m");
        break;
    case LightType::rect:
        v("up", l.up, "Direction of its height; +X where parallel to direction", world_range);
        v("width", l.width, "Width", metres, "m");
        v("height", l.height, "Height", metres, "m");
        v("radiance", l.radiance, "Towards every direction in front", amount, "nt");
        break;
    }
}

/// What holds between keys: directions have a length, a spot's inner is at most its outer, names can stand in a SPEC.
/// Throws Error(`code`) naming the key; `where` is the option or file:line.
void check_light(const Light& light, ExitCode code, std::string_view where);

/// Unit axes: direction that the light travels, up, and right = cross(direction, up). `up` as given, made orthogonal;
/// where that is parallel to the direction +X, and +Y where +X is parallel too.
struct LightAxes {
    vec3 direction, right, up;
};
[[nodiscard]] LightAxes axes_of(const Light& light);

/// Parses "TYPE,key=value,…" (vectors x:y:z). Throws Error(usage) naming key and nearest valid one, or the range; a
/// key given twice or a missing position is an error too.
[[nodiscard]] Light parse_light(std::string_view spec);
/// The same text again, the position and what differs from the defaults; parse_light(to_spec(l)) == l.
[[nodiscard]] std::string to_spec(const Light& light);

/// Gives default names light0, light1, … by index and checks them: not digits only, unique, at most max_lights.
/// Throws Error(`code`) otherwise.
void name_lights(std::vector<Light>& lights, ExitCode code = ExitCode::usage);

/// Index of the light called `name`, which may also be its index; throws Error(usage) with the nearest name.
[[nodiscard]] std::size_t find_light(std::span<const Light> lights, std::string_view name);

} // namespace atrium
