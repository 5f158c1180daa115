#include "assetconv/normal_maps.hpp"

#include "assetconv/channels.hpp"

#include <algorithm>
#include <cmath>

namespace atrium {
namespace {

constexpr float black = 8.0f / 255.0f;
constexpr float length_tolerance = 0.2f;
constexpr int most_samples_per_axis = 512;

} // namespace

BumpContent classify_bump(const SourceImage& image)
{
    if (image.channels < 3 || image.is_grey()) return BumpContent::height;
    const int step_x = std::max(1, image.width / most_samples_per_axis);
    const int step_y = std::max(1, image.height / most_samples_per_axis);
    glm::dvec3 sum(0);
    double count = 0, unit = 0;
    for (int y = 0; y < image.height; y += step_y) {
        for (int x = 0; x < image.width; x += step_x) {
            const vec3 c = image.rgb(x, y);
            if (std::max({c.x, c.y, c.z}) <= black) continue;
            const float length = glm::length(c * 2.0f - 1.0f);
            sum += glm::dvec3(c);
            unit += std::abs(length - 1) < length_tolerance ? 1 : 0;
            count += 1;
        }
    }
    if (count == 0) return BumpContent::colour;
    const glm::dvec3 mean = sum / count;
    const bool centred = std::abs(mean.x - 0.5) < 0.15 && std::abs(mean.y - 0.5) < 0.15;
    return mean.z > 0.6 && centred && unit > 0.9 * count ? BumpContent::normals : BumpContent::colour;
}

NormalField read_normals(const SourceImage& image)
{
    NormalField field{image.width, image.height, {}, {}};
    const std::size_t count = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    field.normals.reserve(count);
    field.valid.reserve(count);
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const vec3 c = image.rgb(x, y);
            vec3 n = c * 2.0f - 1.0f;
            if (image.channels == 2) n = vec3(image.value(x, y, 0) * 2 - 1, image.value(x, y, 1) * 2 - 1, 1);
            const float length = glm::length(n);
            const bool valid = std::max({c.x, c.y, c.z}) > black && length > 0.1f && n.z > 0;
            field.normals.push_back(valid ? n / length : vec3(0, 0, 1));
            field.valid.push_back(valid);
        }
    }
    return field;
}

std::vector<vec3> normals_from_height(const SourceImage& image, char channel, float strength, bool clamp)
{
    const int w = image.width, h = image.height;
    std::vector<float> height(static_cast<std::size_t>(w) * static_cast<std::size_t>(h));
    for (int y = 0, i = 0; y < h; ++y) {
        for (int x = 0; x < w; ++x, ++i) height[static_cast<std::size_t>(i)] = scalar_channel(image, x, y, channel);
    }
    const auto wrap = [&](int i, int n) { return clamp ? std::clamp(i, 0, n - 1) : (i + n) % n; };
    const auto at = [&](int x, int y) {
        return height[static_cast<std::size_t>(wrap(y, h)) * static_cast<std::size_t>(w) +
                      static_cast<std::size_t>(wrap(x, w))];
    };
    const float sx = strength * static_cast<float>(w) / bump_texels,
                sy = strength * static_cast<float>(h) / bump_texels;
    std::vector<vec3> normals;
    normals.reserve(height.size());
    for (int y = 0; y < h; ++y) {
        for (int x = 0; x < w; ++x) {
            const float dx = (at(x + 1, y - 1) + 2 * at(x + 1, y) + at(x + 1, y + 1) - at(x - 1, y - 1) -
                              2 * at(x - 1, y) - at(x - 1, y + 1)) /
                             8;
            const float dy = (at(x - 1, y + 1) + 2 * at(x, y + 1) + at(x + 1, y + 1) - at(x - 1, y - 1) -
                              2 * at(x, y - 1) - at(x + 1, y - 1)) /
                             8;
            normals.push_back(glm::normalize(vec3(-sx * dx, sy * dy, 1)));
        }
    }
    return normals;
}

} // namespace atrium
