// The AOVs by name.

#include "renderer/core/error.hpp"
#include "renderer/core/nearest_name.hpp"
#include "renderer/techniques/aov/graph_image.hpp"
#include "shaders/shared/aov.h"
#include "shaders/shared/buffer_view.h"
#include "shaders/shared/shadow.h"

#include <fmt/format.h>

#include <array>
#include <limits>

namespace atrium {
namespace {

using namespace shared;

constexpr float inf = std::numeric_limits<float>::infinity();
constexpr AovSource gbuffer = AovSource::gbuffer;

constexpr std::array<AovInfo, 26> table{{
    {"depth", false, 1, gbuffer, aov_depth, 0, view_scalar, 0, 0},
    {"position", false, 3, gbuffer, aov_position, 0, view_color, 0, 0},
    {"geometric_normal", false, 3, gbuffer, aov_geometric_normal, 0, view_vector, -1, 1},
    {"normal", false, 3, gbuffer, aov_normal, 0, view_vector, -1, 1},
    {"albedo", false, 3, gbuffer, aov_albedo, 0, view_color, 0, 1},
    {"roughness", false, 1, gbuffer, aov_roughness, 0, view_scalar, 0, 1},
    {"metallic", false, 1, gbuffer, aov_metallic, 0, view_scalar, 0, 1},
    {"specular", false, 1, gbuffer, aov_specular, 0, view_scalar, 0, 0.08f},
    {"emission", false, 3, gbuffer, aov_emission, 0, view_color, 0, 1},
    {"material", false, 1, gbuffer, aov_material, 0, view_index, 0, 1},
    {"mesh", false, 1, gbuffer, aov_mesh, 0, view_index, 0, 1},
    {"instance", false, 1, gbuffer, aov_instance, 0, view_index, 0, 1},
    {"motion", false, 2, gbuffer, aov_motion, 0, view_motion, -0.05f, 0.05f},
    {"light_count", false, 1, gbuffer, aov_light_count, 0, view_scalar, 0, 8},
    {"light", true, 3, AovSource::light, 0, 0, view_color, 0, 1},
    {"ambient", false, 3, AovSource::ambient, 0, 0, view_color, 0, 1},
    {"hdr", false, 3, AovSource::hdr, aov_hdr, 0, view_color, 0, 1},
    {"overdraw", false, 1, AovSource::overdraw, 0, 0, view_scalar, 0, 8},
    {"depth_complexity", false, 1, AovSource::depth_complexity, 0, 0, view_scalar, 0, 8},
    {"visibility", true, 1, AovSource::shadow, show_visibility, 1, view_scalar, 0, 1},
    {"shadow_map", true, 1, AovSource::shadow, show_map, inf, view_scalar, 0, 0},
    {"cascade", true, 1, AovSource::shadow, show_cascade, -1, view_index, 0, 1},
    {"blocker", true, 1, AovSource::shadow, show_blocker, inf, view_scalar, 0, 0},
    {"penumbra", true, 1, AovSource::shadow, show_penumbra, 0, view_scalar, 0, 1},
    {"ao_raw", false, 1, AovSource::ao, aov_ao_raw, 1, view_scalar, 0, 1},
    {"ao", false, 1, AovSource::ao, aov_ao, 1, view_scalar, 0, 1},
}};

} // namespace

std::span<const AovInfo> aov_table()
{
    return table;
}

std::string aov_name(const Aov& aov, std::span<const Light> lights)
{
    if (aov.info->source == AovSource::graph) return "graph." + graph_image_text(aov);
    return aov.info->per_light ? fmt::format("{}.{}", aov.info->name, lights[aov.light].name) : aov.info->name;
}

std::vector<std::string> aov_names(std::span<const Light> lights)
{
    std::vector<std::string> names;
    for (const AovInfo& info : aov_table()) {
        const std::size_t count = info.per_light ? lights.size() : 1;
        for (std::size_t i = 0; i < count; ++i)
            names.push_back(aov_name({&info, static_cast<std::uint32_t>(i)}, lights));
    }
    return names;
}

Aov parse_aov(std::string_view name, std::span<const Light> lights)
{
    constexpr std::string_view of_graph = "graph.";
    if (name.starts_with(of_graph)) return parse_graph_image(name.substr(of_graph.size()));
    for (const AovInfo& info : aov_table()) {
        const std::string_view own = info.name;
        if (!info.per_light && name == own) return {&info, 0};
        if (info.per_light && name.size() > own.size() + 1 && name.starts_with(own) && name[own.size()] == '.') {
            return {&info, static_cast<std::uint32_t>(find_light(lights, name.substr(own.size() + 1)))};
        }
    }
    std::vector<std::string> names;
    for (const AovInfo& info : aov_table()) {
        names.push_back(info.per_light ? fmt::format("{}.{}", info.name, lights.empty() ? "0" : lights.front().name)
                                       : std::string(info.name));
    }
    throw Error(ExitCode::usage, fmt::format("no AOV is called \"{}\"", name), "--aov", suggest_name(name, names),
                "docs/aovs.md lists them; those of a light end in .NAME or .INDEX, and graph.NAME is an image of the "
                "frame graph");
}

} // namespace atrium
