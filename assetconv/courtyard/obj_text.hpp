#pragma once
// The model as OBJ text.

#include "assetconv/courtyard/mesh.hpp"

namespace atrium::courtyard {

/// One group per part's group, one usemtl per part; every corner has position, texture coordinate and normal.
[[nodiscard]] std::string obj_text(const Model& model);

} // namespace atrium::courtyard
