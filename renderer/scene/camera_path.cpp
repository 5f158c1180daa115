#include "renderer/scene/camera_path.hpp"

#include <algorithm>

namespace atrium {

Camera camera_at(const CameraPath& path, double time, const Camera& otherwise)
{
    if (path.empty()) return otherwise;
    const auto t = static_cast<float>(time);
    const auto next = std::find_if(path.begin(), path.end(), [&](const CameraKey& k) { return k.time > t; });
    Camera camera = otherwise;
    if (next == path.begin() || next == path.end()) {
        const CameraKey& end = next == path.begin() ? path.front() : path.back();
        camera.eye = end.eye;
        camera.target = end.target;
        return camera;
    }
    const auto at = [&](std::ptrdiff_t i) -> const CameraKey& {
        return path[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(i, 0, std::ssize(path) - 1))];
    };
    const std::ptrdiff_t i = next - path.begin();
    const float u = (t - at(i - 1).time) / (at(i).time - at(i - 1).time);
    // Source: Catmull & Rom 1974.
    const auto curve = [u](const vec3& a, const vec3& b, const vec3& c, const vec3& d) {
        return 0.5f * (2.0f * b + u * (c - a) + u * u * (2.0f * a - 5.0f * b + 4.0f * c - d) +
                       u * u * u * (3.0f * b - a - 3.0f * c + d));
    };
    camera.eye = curve(at(i - 2).eye, at(i - 1).eye, at(i).eye, at(i + 1).eye);
    camera.target = curve(at(i - 2).target, at(i - 1).target, at(i).target, at(i + 1).target);
    if (camera.eye == camera.target) camera.target += at(i).target - at(i).eye; // two curves may cross
    return camera;
}

} // namespace atrium
