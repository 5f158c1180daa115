#pragma once
// Images of the frame graph as AOVs: "graph.NAME", NAME as the graph's text calls it.

#include "renderer/techniques/aov/aov.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace atrium {

/// "NAME" or "NAME:LAYER", without "graph." in front.
[[nodiscard]] Aov parse_graph_image(std::string_view text);
/// What parse_graph_image() takes.
[[nodiscard]] std::string graph_image_text(const Aov& aov);

/// None where there is no image of that name, or not that layer.
[[nodiscard]] std::optional<graph::Tex> find_graph_image(const graph::Graph& g, const Aov& aov,
                                                         const GraphImages& images);
/// Throws Error(usage) of an image that find_graph_image() does not find.
[[noreturn]] void refuse_graph_image(const graph::Graph& g, const Aov& aov, const GraphImages& images);

/// What images of a format hold.
[[nodiscard]] const AovInfo& graph_image_info(gpu::Format format);

/// Reads  one layer of an image.  Writes  R32F or RGBA32F of its size.
[[nodiscard]] graph::Tex add_graph_image(graph::Graph& g, graph::Tex image, std::uint32_t layer,
                                         const std::string& pass);

} // namespace atrium
