#pragma once
// The table of material classes: how each is drawn. A class's surface function is shaders/materials/<surface>.glsl; a
// pass has one entry point per surface function, named <pass>_<surface>.frag. Its vertex function is a case of
// shape_vertex() in shaders/materials/position.glsl, which every pass that draws the scene uses.

#include "renderer/scene/scene.hpp"
#include "shaders/shared/material_class.h"

#include <array>
#include <string>

namespace atrium {

/// Which sides of a class's surfaces are drawn.
enum class Sides : std::uint8_t {
    by_mesh, ///< front faces; both sides if the mesh or the material is two-sided
    both,    ///< always
};

struct MaterialClassInfo {
    MaterialClass cls = MaterialClass::opaque;
    const char* surface = "opaque";              ///< surface function, for fragments
    std::uint32_t vertex = shared::vertex_rigid; ///< vertex function
    Sides sides = Sides::by_mesh;
    bool has_holes = false;   ///< fragments may be discarded
    bool tessellated = false; ///< passes draw it as patches; see class_pipeline()
    bool deformed = false;    ///< the vertex function moves vertices: culling does not rely on the baked triangles
};

/// In drawing order: classes that cover most pixels first, so that the depth test rejects what they hide; classes with
/// holes last.
inline constexpr std::array<MaterialClassInfo, material_class_count> material_classes{{
    {.cls = MaterialClass::opaque, .surface = "opaque"},
    {.cls = MaterialClass::cloth, .surface = "opaque", .sides = Sides::both},
    {.cls = MaterialClass::masked, .surface = "masked", .sides = Sides::both, .has_holes = true},
    {.cls = MaterialClass::blended, .surface = "blended", .sides = Sides::both, .has_holes = true},
}};

/// Position of a class in the drawing order.
[[nodiscard]] int draw_rank(MaterialClass cls);

/// The row of a class in the table.
[[nodiscard]] const MaterialClassInfo& class_info(MaterialClass cls);

/// The fragment shader of a pass for a class, e.g. ("techniques/gbuffer/gbuffer", masked).
[[nodiscard]] std::string class_fragment(const std::string& pass, const MaterialClassInfo& info);

} // namespace atrium
