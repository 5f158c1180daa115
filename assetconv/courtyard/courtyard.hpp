#pragma once
// The demo scene, made by code: a colonnaded court of two floors around a fountain, written as OBJ, MTL, PNG textures
// and a scene file, so that the converter reads it like anybody's model.

#include <cstdint>
#include <filesystem>

namespace atrium {

struct CourtyardOptions {
    std::filesystem::path folder; ///< made when missing; files of the same names in it are replaced
    std::uint32_t seed = 1;       ///< weathering, plants and wear; the plan stays the same
    enum class Detail { low, medium, high };
    Detail detail = Detail::medium; ///< about 25k, 150k and 377k triangles; textures up to 256, 1024 and 1024 texels
};

/// Writes courtyard.obj, courtyard.mtl, courtyard.toml (bake = "courtyard.atrium") and textures/*.png.
/// World: metres, Y up, counter-clockwise fronts, the fountain at the origin, the long axis along X.
/// The same options give the same bytes. Throws Error(environment) when a file cannot be written.
void write_courtyard(const CourtyardOptions& options);

} // namespace atrium
