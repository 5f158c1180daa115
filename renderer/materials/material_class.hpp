#pragma once
// The table of material classes: how each is drawn. A class's surface function is shaders/materials/<name>.glsl; a pass
// has one entry point per surface function, named <pass>_<surface>.frag.

#include "renderer/scene/scene.hpp"

#include <array>
#include <string>

namespace atrium {

struct MaterialClassInfo {
    MaterialClass cls;
    const char* surface; ///< surface function of its fragments
    bool has_holes;      ///< fragments may be discarded
};

/// In drawing order: what fills most pixels first, so that depth rejects what lies behind; holes last.
inline constexpr std::array<MaterialClassInfo, material_class_count> material_classes{{
    {MaterialClass::opaque, "opaque", false},
    {MaterialClass::cloth, "opaque", false},
    {MaterialClass::masked, "masked", true},
    {MaterialClass::blended, "blended", true},
}};

/// Position of a class in the drawing order.
[[nodiscard]] int draw_rank(MaterialClass cls);

/// The fragment shader of a pass for a class, e.g. ("techniques/gbuffer/gbuffer", masked).
[[nodiscard]] std::string class_fragment(const std::string& pass, const MaterialClassInfo& info);

} // namespace atrium
