#pragma once
// Draws the scene in a raster pass: one pipeline per material class, one indirect multi-draw per range.

#include "renderer/materials/material_class.hpp"
#include "renderer/techniques/common/draw_list.hpp"

#include <cstdint>
#include <functional>
#include <optional>

namespace atrium {

/// The shaders and state with which a pass draws a material class; nullopt: the pass skips the class. The vertex shader
/// takes its position from shaders/materials/vertex.glsl. draw_scene() adds what class_pipeline() says.
using ClassPipeline = std::function<std::optional<gpu::GraphicsPipelineDesc>(const MaterialClassInfo&)>;

/// What a pass draws.
struct SceneDraws {
    DrawList list;
    Geometry geometry;
    bool both_sides = false; ///< no face culling, whatever the ranges say
    /// How often the list is drawn in the pass, e.g. once per tile of a shadow map. View n starts `list.count * n`
    /// commands further.
    std::uint32_t views = 1;
    std::function<void(graph::Cmd&, std::uint32_t view)> begin_view{}; ///< sets viewport, push constants…
};

/// Declares that `pass` draws the scene (commands, indices, pipelines) and how it is recorded. Targets are the
/// caller's. The pipeline is changed only where the class needs another one.
void draw_scene(graph::PassBuilder& pass, const SceneDraws& draws, const ClassPipeline& pipeline_of);

/// `desc` for a class: vertex input, specialisation constants 0 (materials_diverge) and 1 (vertex_function), and
/// patches of three control points where it has tessellation stages. Throws std::logic_error where the class is
/// tessellated and `desc` is not: depths would differ from those of other passes.
[[nodiscard]] gpu::GraphicsPipelineDesc class_pipeline(gpu::GraphicsPipelineDesc desc, const MaterialClassInfo& cls,
                                                       const Geometry& geometry);

} // namespace atrium
