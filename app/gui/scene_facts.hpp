#pragma once
// What a scene is made of, as numbers and names that do not change while it is shown.

#include "renderer/core/math.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace atrium::gui {

struct TextureFacts {
    const char* use = ""; ///< such as "base color"
    std::string file, format;
    uvec2 size{0};
    std::uint64_t bytes = 0; ///< all mips
};

struct MaterialFacts {
    std::uint64_t meshes = 0, triangles = 0; ///< of all instances
    std::vector<TextureFacts> textures;
    std::optional<std::uint32_t> image; ///< of the base colour, for ui_image(); without: one colour
};

struct SceneFacts {
    std::uint64_t instances = 0;
    std::uint64_t meshes = 0, triangles = 0, vertices = 0; ///< of all instances
    std::uint64_t textures = 0, texture_bytes = 0;
    Bounds bounds;                        ///< m
    double load_ms = 0;                   ///< from files to the device
    std::vector<MaterialFacts> materials; ///< in the order of the AOV `material`
};

} // namespace atrium::gui
