#include "app/view/recent_scenes.hpp"

namespace atrium::app {

std::filesystem::path scene_path(const std::filesystem::path& file)
{
    return std::filesystem::absolute(file).lexically_normal();
}

void remember_scene(std::vector<std::filesystem::path>& recent, const std::filesystem::path& scene)
{
    constexpr std::size_t most = 10;
    std::erase(recent, scene);
    recent.insert(recent.begin(), scene);
    if (recent.size() > most) recent.resize(most);
}

} // namespace atrium::app
