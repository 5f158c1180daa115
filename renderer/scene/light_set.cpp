#include "renderer/scene/light_set.hpp"

#include "renderer/core/hash.hpp"

#include <algorithm>
#include <string>

#include <fmt/format.h>

namespace atrium {
namespace {

/// Set in keys made from names, not in keys made from ids.
constexpr LightKey named = LightKey{1} << 63;

LightKey key_of(const Light& light, std::size_t index)
{
    if (light.id != 0) return light.id;
    const std::string name = light.name.empty() ? fmt::format("light{}", index) : light.name;
    return hash64(std::as_bytes(std::span(name))) | named;
}

} // namespace

std::optional<std::uint32_t> LightSet::shadow_layer(std::size_t light) const
{
    const auto found = std::find(shadowed.begin(), shadowed.end(), light);
    if (found == shadowed.end()) return std::nullopt;
    return static_cast<std::uint32_t>(found - shadowed.begin());
}

LightSet make_light_set(std::span<const Light> lights, std::size_t most_shadowed)
{
    LightSet set;
    set.lights = lights;
    set.places.resize(lights.size());
    std::uint32_t next = 0;
    for (const bool rects : {false, true}) {
        for (std::size_t i = 0; i < lights.size(); ++i) {
            if ((lights[i].type == LightType::rect) == rects) set.places[i] = next++;
        }
        if (!rects) set.delta_count = next;
    }
    for (std::uint32_t i = 0; i < lights.size() && set.shadowed.size() < most_shadowed; ++i) {
        if (lights[i].shadow) set.shadowed.push_back(i);
    }
    set.keys.reserve(lights.size());
    for (std::size_t i = 0; i < lights.size(); ++i) {
        LightKey key = key_of(lights[i], i);
        while (std::find(set.keys.begin(), set.keys.end(), key) != set.keys.end())
            ++key; // lights with the same name: by order
        set.keys.push_back(key);
    }
    return set;
}

} // namespace atrium
