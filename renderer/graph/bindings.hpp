#pragma once
// Set 2 of a pass: which of its declared uses are bound where, and whether its shaders agree.

#include "renderer/graph/graph.hpp"

#include <string>
#include <vector>

namespace atrium::graph {

/// A declared use that shaders reach through set 2.
struct BoundUse {
    gpu::PassBinding at;
    std::size_t use = 0; ///< index into Pass::uses
};

/// The bindings of a pass in ascending order: its n-th sampled image, storage buffer and storage image, each counted by
/// itself (shaders/shared/pass.h). Transfer passes bind nothing. `is_image`: by resource.
[[nodiscard]] std::vector<BoundUse> bind_uses(const Pass& pass, const std::function<bool(ResourceIndex)>& is_image);

/// What a shader of the pass binds in set 2, by its name.
struct ShaderBindings {
    std::string shader;
    std::vector<gpu::PassBinding> bindings;
};

/// Throws std::logic_error, naming pass, resource and shader, where a shader binds what the pass does not declare, or
/// in another kind, or where a declared resource is bound by none of the shaders. `name_of`: of resources.
void check_bindings(const Pass& pass, const std::vector<BoundUse>& declared, const std::vector<ShaderBindings>& shaders,
                    const std::function<std::string(ResourceIndex)>& name_of);

} // namespace atrium::graph
