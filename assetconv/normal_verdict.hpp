#pragma once
// What every bump and normal map of a scene holds and which way its green points, decided for the scene as a whole.

#include "assetconv/normal_maps.hpp"

#include <map>
#include <optional>

namespace atrium {

enum class NormalY : std::uint8_t { automatic, up, down };

struct NormalVerdict {
    BumpContent content = BumpContent::normals;
    GreenAxis green = GreenAxis::up; ///< for normals
    const char* reason = "";         ///< what decided: "curl", "colour", "majority", "default", "option"
};
using NormalVerdicts = std::map<ImageKey, NormalVerdict>;

/// A map to look at: the image, the colour map beside it (may be empty), and whether the MTL says it is a normal map
/// (norm).
struct NormalQuestion {
    ImageKey image;
    std::optional<ImageKey> color;
    bool surely_normals = false;
};

/// Looks at all of them in parallel. Green by curl, else by the colour map, else as most others of the scene, else up.
[[nodiscard]] NormalVerdicts judge_normal_maps(const std::vector<NormalQuestion>& questions, const ImageStore& images,
                                               NormalY option);

} // namespace atrium
