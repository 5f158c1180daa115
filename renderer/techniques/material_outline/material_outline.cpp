#include "renderer/techniques/material_outline/material_outline.hpp"

namespace atrium {

graph::Tex add_material_outline(graph::Graph& g, graph::Tex id, graph::Tex picture, std::uint32_t material)
{
    g.raster("material_outline")
        .reads(id)
        .writes(picture, graph::Load::keep)
        .fullscreen("techniques/material_outline/material_outline.frag", {}, material);
    return picture;
}

} // namespace atrium
