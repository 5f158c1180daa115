#pragma once
// Set 2 of a pass: the binding of each declared use, and a check against the bindings of its shaders.

#include "renderer/graph/graph.hpp"

#include <string>
#include <vector>

namespace atrium::graph {

/// The bindings of a pass in ascending order: sampled images, storage buffers and storage images, each kind numbered in
/// order of declaration (shaders/shared/pass.h). Transfer passes bind nothing. `is_image`: by resource.
[[nodiscard]] std::vector<BoundUse> bind_uses(const Pass& pass, const std::function<bool(ResourceIndex)>& is_image);

/// The name of a shader of the pass, and its bindings in set 2.
struct ShaderBindings {
    std::string shader;
    std::vector<gpu::PassBinding> bindings;
};

/// Throws std::logic_error with the names of pass, resource and shader if a shader binds something that the pass does
/// not declare or declares as another kind, or if no shader binds a declared resource. `name_of`: of resources.
void check_bindings(const Pass& pass, const std::vector<BoundUse>& declared, const std::vector<ShaderBindings>& shaders,
                    const std::function<std::string(ResourceIndex)>& name_of);

} // namespace atrium::graph
