#pragma once
// Camera paths: where a camera stands at some times, and the curve between.

#include "renderer/scene/camera.hpp"

#include <map>
#include <string>
#include <vector>

namespace atrium {

struct CameraKey {
    float time = 0; ///< s
    vec3 eye{0}, target{0};
    bool operator==(const CameraKey&) const = default;
};

/// Ordered by time, no time twice. Empty: no path, and every time has the same camera.
using CameraPath = std::vector<CameraKey>;
using CameraPaths = std::map<std::string, CameraPath>;

/// Between keys eye and target move along Catmull-Rom curves; before the first and after the last they stand still. The
/// field of view stays that of `otherwise`.
[[nodiscard]] Camera camera_at(const CameraPath& path, double time, const Camera& otherwise);

} // namespace atrium
