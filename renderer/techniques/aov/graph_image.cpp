#include "renderer/techniques/aov/graph_image.hpp"

#include "renderer/core/error.hpp"
#include "renderer/core/nearest_name.hpp"
#include "shaders/shared/aov.h"
#include "shaders/shared/buffer_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <limits>

namespace atrium {
namespace {

using gpu::Format;

constexpr AovInfo row(int channels, std::uint32_t mode, float high)
{
    return {"graph", false, channels, AovSource::graph, shared::aov_constant, -std::numeric_limits<float>::infinity(),
            mode,    0,     high};
}

/// What is not known before there is a frame, and of an image that the frame has not.
constexpr AovInfo unknown = row(1, shared::view_scalar, 0);

const graph::Tex* find(const GraphImages& images, const std::string& name)
{
    const auto found = std::find_if(images.begin(), images.end(), [&](const auto& i) { return i.first == name; });
    return found == images.end() ? nullptr : &found->second;
}

} // namespace

Aov parse_graph_image(std::string_view text)
{
    Aov out{&unknown};
    const std::size_t colon = text.rfind(':');
    if (colon != std::string_view::npos) {
        const char* end = text.data() + text.size();
        const auto [stop, error] = std::from_chars(text.data() + colon + 1, end, out.layer);
        if (error == std::errc{} && stop == end) text = text.substr(0, colon); // else the name has a colon in it
    }
    out.image = text;
    return out;
}

std::string graph_image_text(const Aov& aov)
{
    return aov.layer == 0 ? aov.image : fmt::format("{}:{}", aov.image, aov.layer);
}

std::optional<graph::Tex> find_graph_image(const graph::Graph& g, const Aov& aov, const GraphImages& images)
{
    const graph::Tex* image = find(images, aov.image);
    if (!image || aov.layer >= g.desc(*image).layers) return std::nullopt;
    return *image;
}

void refuse_graph_image(const graph::Graph& g, const Aov& aov, const GraphImages& images)
{
    std::vector<std::string> names;
    for (const auto& [name, image] : images) names.push_back(name);
    const graph::Tex* image = find(images, aov.image);
    const std::string why = image ? fmt::format("it has {} layer(s), counted from 0", g.desc(*image).layers)
                                  : suggest_name(aov.image, names);
    throw Error(ExitCode::usage, fmt::format("this frame has no image \"{}\"", graph_image_text(aov)),
                "graph." + graph_image_text(aov), why,
                "--graph FILE.txt lists a frame's images; those of a technique that is off are not among them");
}

const AovInfo& graph_image_info(Format format)
{
    using namespace shared;
    static constexpr AovInfo share = row(1, view_scalar, 1), two_shares = row(2, view_color, 1),
                             color = row(4, view_color, 1), index = row(1, view_index, 1),
                             two_numbers = row(2, view_color, 0), four_numbers = row(4, view_color, 0);
    switch (format) {
    case Format::r8_unorm:
        return share;
    case Format::rg8_unorm:
        return two_shares;
    case Format::rgba8_unorm:
    case Format::rgba8_srgb:
    case Format::bgra8_unorm:
        return color;
    case Format::r32_uint:
        return index;
    case Format::rg32_uint:
    case Format::rg16_float:
    case Format::rg32_float:
        return two_numbers;
    case Format::rgba16_float:
    case Format::rgba32_float:
        return four_numbers;
    default:
        return unknown; // one number: depth, R32F
    }
}

graph::Tex add_graph_image(graph::Graph& g, graph::Tex image, std::uint32_t layer, const std::string& pass)
{
    const graph::TexDesc& from = g.desc(image);
    const bool whole_numbers = from.format == Format::r32_uint || from.format == Format::rg32_uint;
    const Format format = graph_image_info(from.format).channels == 1 ? Format::r32_float : Format::rgba32_float;
    const graph::Tex target = g.texture(pass, {format, from.width, from.height});
    g.raster(pass)
        .reads_layer(image, layer)
        .writes(target)
        .fullscreen(whole_numbers ? "techniques/aov/graph_image_uint.frag" : "techniques/aov/graph_image.frag");
    return target;
}

} // namespace atrium
