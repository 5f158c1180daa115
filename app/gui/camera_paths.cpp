#include "app/gui/camera_paths.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace atrium::gui {

std::optional<std::string> add_path(CameraPaths& paths, std::string& name, const Camera& camera)
{
    for (std::size_t i = paths.size(); name.empty(); ++i) {
        const std::string free = fmt::format("path{}", i);
        if (!paths.contains(free)) name = free;
    }
    if (paths.contains(name)) return fmt::format("another path is called {}", name);
    paths[name] = {{0, camera.eye, camera.target}};
    return std::nullopt;
}

std::optional<std::size_t> add_key(CameraPath& path, float time, const Camera& camera)
{
    const auto next = std::find_if(path.begin(), path.end(), [&](const CameraKey& k) { return k.time >= time; });
    if (next != path.end() && next->time == time) return std::nullopt;
    const auto added = path.insert(next, {time, camera.eye, camera.target});
    return static_cast<std::size_t>(added - path.begin());
}

void go_to(Camera& camera, const CameraKey& key)
{
    camera.eye = key.eye;
    camera.target = key.target;
}

void PathPlayer::play(const CameraPath& path)
{
    if (path.empty()) return;
    if (time >= path.back().time || time < path.front().time) time = path.front().time;
    playing = true;
}

bool PathPlayer::advance(const CameraPath& path, double seconds, Camera& camera)
{
    if (!playing || path.empty()) return playing = false;
    time = std::min(time + static_cast<float>(seconds), path.back().time);
    camera = camera_at(path, time, camera);
    playing = time < path.back().time;
    return true;
}

} // namespace atrium::gui
