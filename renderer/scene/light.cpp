#include "renderer/scene/light.hpp"

#include "renderer/core/nearest_name.hpp"
#include "renderer/core/text_value.hpp"
#include "renderer/scene/light_reader.hpp"

#include <algorithm>
#include <array>
#include <tuple>
#include <utility>

#include <fmt/format.h>

namespace atrium {
namespace {

constexpr std::array<const char*, 4> type_names{"sun", "spot", "point", "rect"}; // in the enum's order
constexpr std::size_t longest_name = 64;
constexpr float least_length = 1e-6f; // of a direction: its square is still a normal float

/// Names every field, so that a new one cannot be forgotten.
auto compared(const Light& light)
{
    const auto& [type, name, position, direction, up, color, illuminance, intensity, radiance, angle, inner, outer,
                 size, range, width, height, shadow, id] = light;
    return std::tie(type, name, position, direction, up, color, illuminance, intensity, radiance, angle, inner, outer,
                    size, range, width, height, shadow);
}

LightType parse_type(std::string_view text, ExitCode code, const std::string& where)
{
    for (std::size_t i = 0; i < type_names.size(); ++i) {
        if (text == type_names[i]) return static_cast<LightType>(i);
    }
    const std::vector<std::string> names(type_names.begin(), type_names.end());
    throw Error(code, fmt::format("unknown light type \"{}\"", text), where,
                fmt::format("the types are {}", fmt::join(names, ", ")),
                did_you_mean(text, names, "choose one of them"));
}

bool digits_only(std::string_view text)
{
    return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

bool has_position(LightType type)
{
    return type != LightType::sun;
}

/// A name stands in SPECs (",") and in front of "=FILE" of an AOV.
void check_name(const Light& light, ExitCode code, std::string_view where)
{
    const auto fail = [&](const char* why) {
        throw Error(code, fmt::format("bad light name \"{}\"", light.name.substr(0, longest_name)), std::string(where),
                    why, "choose another name");
    };
    if (digits_only(light.name)) fail("a name of digits only would be taken for an index");
    if (light.name.size() > longest_name) fail("it is longer than 64 bytes");
    for (const char c : light.name) {
        if (c == ',' || c == '=' || static_cast<unsigned char>(c) < ' ' || c == '\x7f') {
            fail("it holds a comma, an equals sign or a control character");
        }
    }
}

} // namespace

bool Light::operator==(const Light& other) const
{
    return compared(*this) == compared(other);
}

const char* to_string(LightType t)
{
    return type_names.at(static_cast<std::size_t>(t));
}

Light default_light(LightType type)
{
    Light light;
    light.type = type;
    if (type == LightType::sun) light.direction = {-0.3f, -1.0f, -0.2f};
    return light;
}

void check_light(const Light& light, ExitCode code, std::string_view where)
{
    check_name(light, code, where);
    const auto fail = [&](const std::string& what, const char* why, const char* next) {
        throw Error(code, what, std::string(where), why, next);
    };
    const auto check_direction = [&](const char* key, const vec3& v) {
        if (glm::length(v) >= least_length) return;
        fail(fmt::format("bad value \"{}\" for {} light key \"{}\"", to_text(v), to_string(light.type), key),
             "it has no length, so it points nowhere", "give a vector that is not zero");
    };
    if (light.type != LightType::point) check_direction("direction", light.direction);
    if (light.type == LightType::rect) check_direction("up", light.up);
    if (light.type == LightType::spot && light.inner > light.outer) {
        fail(fmt::format("the spot light's inner angle {} is larger than its outer angle {}", light.inner, light.outer),
             "the light fades from the inner to the outer half angle", "give inner at most outer");
    }
}

LightAxes axes_of(const Light& light)
{
    const vec3 direction = glm::normalize(light.direction);
    for (const vec3& up : {light.up, vec3(1, 0, 0), vec3(0, 1, 0)}) {
        const vec3 right = glm::cross(direction, glm::normalize(up));
        if (glm::length(right) < 1e-4f) continue; // parallel
        const vec3 unit_right = glm::normalize(right);
        return {direction, unit_right, glm::cross(unit_right, direction)};
    }
    return {direction, vec3(1, 0, 0), vec3(0, 1, 0)}; // never reached with a checked light
}

LightReader::LightReader(std::string_view type, ExitCode code, std::string where)
    : code_(code), where_(std::move(where)), light_(default_light(parse_type(type, code, where_))),
      keys_(fmt::format("{} light key", to_string(light_.type)), "")
{
    describe(keys_, light_);
}

void LightReader::set(std::string_view key, std::string_view text, std::string_view where)
{
    keys_.set(key, text, code_, where);
    if (std::find(given_.begin(), given_.end(), key) != given_.end()) {
        throw Error(code_, fmt::format("the light key \"{}\" is given twice", key), std::string(where), "",
                    "give it once");
    }
    given_.emplace_back(key);
}

Light LightReader::finish() const
{
    if (has_position(light_.type) && std::find(given_.begin(), given_.end(), "position") == given_.end()) {
        throw Error(code_, fmt::format("the {} light has no \"position\"", to_string(light_.type)), where_,
                    "only a sun needs none", "give its position in metres");
    }
    check_light(light_, code_, where_);
    return light_;
}

Light parse_light(std::string_view spec)
{
    const std::string where = fmt::format("--light {}", spec);
    const auto next_part = [&spec] {
        const std::size_t comma = std::min(spec.find(','), spec.size());
        const std::string_view part = spec.substr(0, comma);
        spec.remove_prefix(std::min(comma + 1, spec.size()));
        return part;
    };
    bool more = spec.find(',') != std::string_view::npos;
    LightReader reader(next_part(), ExitCode::usage, where);
    while (more) {
        more = spec.find(',') != std::string_view::npos;
        const std::string_view part = next_part();
        const std::size_t equals = part.find('=');
        if (equals == std::string_view::npos) {
            const std::string nearest = reader.keys().nearest(part);
            throw Error(ExitCode::usage, fmt::format("\"{}\" is not a light's key=value", part), where,
                        "there is no equals sign in it",
                        nearest.empty() ? "write key=value" : fmt::format("did you mean \"{}=…\"?", nearest));
        }
        reader.set(part.substr(0, equals), part.substr(equals + 1), where);
    }
    return reader.finish();
}

std::string to_spec(const Light& light)
{
    Light described = default_light(light.type);
    SettingList keys;
    describe(keys, described);
    described = light; // only now, so that the list knows the defaults
    std::string spec = to_string(light.type);
    if (has_position(light.type)) spec += fmt::format(",position={}", to_text(light.position));
    for (const auto& [key, text] : keys.differing()) {
        if (key != "position") spec += fmt::format(",{}={}", key, text);
    }
    return spec;
}

void name_lights(std::vector<Light>& lights, ExitCode code)
{
    if (lights.size() > max_lights) {
        throw Error(code, fmt::format("too many lights: {}", lights.size()), "lights",
                    fmt::format("at most {} can be drawn", max_lights), "leave some out");
    }
    for (std::size_t i = 0; i < lights.size(); ++i) {
        if (lights[i].name.empty()) lights[i].name = fmt::format("light{}", i);
        check_name(lights[i], code, fmt::format("light {}", i));
    }
    for (std::size_t i = 0; i < lights.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            if (lights[i].name != lights[j].name) continue;
            throw Error(code, fmt::format("the light name \"{}\" is used twice", lights[i].name),
                        fmt::format("lights {} and {}", j, i),
                        "a light without a name is called light and its index, counted from 0", "rename one of them");
        }
    }
}

std::size_t find_light(std::span<const Light> lights, std::string_view name)
{
    std::vector<std::string> names;
    for (std::size_t i = 0; i < lights.size(); ++i) {
        if (lights[i].name == name) return i;
        names.push_back(lights[i].name);
    }
    const auto index = digits_only(name) ? parse_int(name) : std::nullopt;
    if (index && static_cast<std::size_t>(*index) < lights.size()) return static_cast<std::size_t>(*index);
    throw Error(ExitCode::usage, fmt::format("unknown light \"{}\"", name), "",
                lights.empty() ? "the scene has no light" : fmt::format("the lights are {}", fmt::join(names, ", ")),
                lights.empty() ? "add one with --light" : did_you_mean(name, names, "choose one of them"));
}

} // namespace atrium
