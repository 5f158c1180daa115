#include "app/resume.hpp"

#include "app/toml_text.hpp"
#include "renderer/core/error.hpp"
#include "renderer/core/hash.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <glm/gtc/type_ptr.hpp>

#include <span>

namespace atrium::app {

std::string scene_mark(const SceneInput& scene)
{
    std::string text;
    for (const auto& bake : scene.bakes) {
        for (const bake::SectionEntry& section : bake->table()) text += fmt::format("section {:x}\n", section.hash);
    }
    for (const Instance& instance : scene.instances) {
        const std::span matrix(glm::value_ptr(instance.world_from_object), 16);
        text += fmt::format("instance {} {} {}\n", instance.bake,
                            instance.mesh ? fmt::format("{}", *instance.mesh) : "all", fmt::join(matrix, " "));
    }
    text += materials_toml(scene.file.materials);
    return fmt::format("{:016x}", hash64(std::as_bytes(std::span(text))));
}

std::string resume_text(const std::string& scene_mark, const Camera& previous_camera)
{
    return fmt::format("scene = \"{}\"\n[previous_camera]\n{}", scene_mark, toml_camera(previous_camera));
}

bool is_whole(const std::filesystem::path& file, const ImageMetadata& metadata)
{
    if (!std::filesystem::exists(file)) return false;
    try {
        ImageMetadata found;
        if (file.extension() == ".png")
            static_cast<void>(read_png(file, &found));
        else
            static_cast<void>(read_exr(file, &found));
        return found == metadata;
    } catch (const Error&) { // cut off, or no picture at all: it is drawn again
        return false;
    }
}

} // namespace atrium::app
