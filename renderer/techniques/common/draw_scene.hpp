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

/// The scene as a pass draws it.
struct SceneDraws {
    DrawList list;
    Geometry geometry;
    bool both_sides = false; ///< no face culling, also for one-sided ranges
    /// How often the list is drawn in the pass, e.g. once per tile of a shadow map. The commands of view n start at
    /// `list.count * n`.
    std::uint32_t views = 1;
    std::function<void(graph::Cmd&, std::uint32_t view)> begin_view{}; ///< sets viewport, push constants…
};

/// Declares that `pass` draws the scene (commands, indices, pipelines) and sets its record function. The caller
/// declares the targets. A pipeline is bound only if it differs from the previous range's.
void draw_scene(graph::PassBuilder& pass, const SceneDraws& draws, const ClassPipeline& pipeline_of);

/// `desc` for a class: vertex input, specialisation constants 0 (materials_diverge) and 1 (vertex_function), after
/// which its own are counted, and patches of three control points if it has tessellation stages. Throws
/// std::logic_error if the class is tessellated and `desc` is not: its depths would differ from those of other passes.
[[nodiscard]] gpu::GraphicsPipelineDesc class_pipeline(gpu::GraphicsPipelineDesc desc, const MaterialClassInfo& cls,
                                                       const Geometry& geometry);

} // namespace atrium
