#include "assetconv/courtyard/textures/canvas.hpp"

#include "renderer/core/image.hpp"

#include <algorithm>
#include <cmath>

namespace atrium::courtyard {
namespace {

int wrap(int x, int size)
{
    return ((x % size) + size) % size;
}

std::uint8_t byte(float x)
{
    return static_cast<std::uint8_t>(glm::clamp(x, 0.0f, 1.0f) * 255.0f + 0.5f);
}

void write(const Studio& studio, const std::string& name, const Image8& image)
{
    write_png(studio.folder / (name + ".png"), image);
}

Image8 image_of(const Canvas& canvas, int channels, const std::function<void(const Texel&, std::uint8_t*)>& encode)
{
    Image8 image(canvas.size, canvas.size, channels);
    for (int y = 0; y < canvas.size; ++y) {
        for (int x = 0; x < canvas.size; ++x) {
            encode(canvas.at(x, y), image.at(x, y));
        }
    }
    return image;
}

} // namespace

const Texel& Canvas::at(int x, int y) const
{
    return texels[static_cast<std::size_t>(wrap(y, size)) * static_cast<std::size_t>(size) +
                  static_cast<std::size_t>(wrap(x, size))];
}

Canvas paint(int size, float metres, const std::function<Texel(vec2 uv)>& painter)
{
    Canvas canvas{size, metres, {}};
    canvas.texels.reserve(static_cast<std::size_t>(size) * static_cast<std::size_t>(size));
    const float step = 1.0f / static_cast<float>(size);
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            canvas.texels.push_back(
                painter({(static_cast<float>(x) + 0.5f) * step, 1 - (static_cast<float>(y) + 0.5f) * step}));
        }
    }
    return canvas;
}

namespace {

/// Running mean along rows or columns, wrapped.
void blur(std::vector<float>& values, int size, int radius, bool rows)
{
    std::vector<float> line(static_cast<std::size_t>(size));
    const auto place = [&](int i, int k) {
        const int w = wrap(k, size);
        return static_cast<std::size_t>(rows ? i * size + w : w * size + i);
    };
    for (int i = 0; i < size; ++i) {
        double sum = 0;
        for (int k = -radius; k <= radius; ++k) {
            sum += static_cast<double>(values[place(i, k)]);
        }
        for (int k = 0; k < size; ++k) {
            line[static_cast<std::size_t>(k)] = static_cast<float>(sum / (2 * radius + 1));
            sum += static_cast<double>(values[place(i, k + radius + 1)] - values[place(i, k - radius)]);
        }
        for (int k = 0; k < size; ++k) {
            values[place(i, k)] = line[static_cast<std::size_t>(k)];
        }
    }
}

} // namespace

void weather_by_height(Canvas& canvas, float radius, float hollow, float edge)
{
    std::vector<float> mean;
    mean.reserve(canvas.texels.size());
    for (const Texel& t : canvas.texels) {
        mean.push_back(t.height);
    }
    const int reach = std::max(1, static_cast<int>(radius / canvas.metres * static_cast<float>(canvas.size) + 0.5f));
    for (int pass = 0; pass < 2; ++pass) {
        blur(mean, canvas.size, std::min(reach, canvas.size / 2 - 1), true);
        blur(mean, canvas.size, std::min(reach, canvas.size / 2 - 1), false);
    }
    for (std::size_t i = 0; i < mean.size(); ++i) {
        Texel& t = canvas.texels[i];
        const float relief = (t.height - mean[i]) / radius; // a slope of sorts
        t.color *= 1 + glm::clamp(relief * (relief < 0 ? hollow : edge), -0.55f, 0.22f);
    }
}

void write_color(const Studio& studio, const std::string& name, const Canvas& canvas)
{
    write(studio, name, image_of(canvas, 3, [](const Texel& t, std::uint8_t* out) {
              for (int c = 0; c < 3; ++c) {
                  out[c] = byte(t.color[c]);
              }
          }));
}

void write_color_alpha(const Studio& studio, const std::string& name, const Canvas& canvas)
{
    write(studio, name, image_of(canvas, 4, [](const Texel& t, std::uint8_t* out) {
              for (int c = 0; c < 3; ++c) {
                  out[c] = byte(t.color[c]);
              }
              out[3] = byte(t.alpha);
          }));
}

void write_alpha(const Studio& studio, const std::string& name, const Canvas& canvas)
{
    write(studio, name, image_of(canvas, 1, [](const Texel& t, std::uint8_t* out) { *out = byte(t.alpha); }));
}

void write_gloss(const Studio& studio, const std::string& name, const Canvas& canvas)
{
    write(studio, name, image_of(canvas, 1, [](const Texel& t, std::uint8_t* out) { *out = byte(t.gloss); }));
}

void write_normal(const Studio& studio, const std::string& name, const Canvas& canvas, float exaggerate, float aspect)
{
    Image8 image(canvas.size, canvas.size, 3);
    const float scale = exaggerate * static_cast<float>(canvas.size) / (2 * canvas.metres);
    for (int y = 0; y < canvas.size; ++y) {
        for (int x = 0; x < canvas.size; ++x) {
            const float right = canvas.at(x + 1, y).height - canvas.at(x - 1, y).height;
            const float up = canvas.at(x, y - 1).height - canvas.at(x, y + 1).height;
            const vec3 n = glm::normalize(vec3(-right * scale, -up * scale / aspect, 1));
            std::uint8_t* out = image.at(x, y);
            for (int c = 0; c < 3; ++c) {
                out[c] = byte(0.5f + 0.5f * n[c]);
            }
        }
    }
    write(studio, name, image);
}

Stone stone_at(const Bond& bond, vec2 uv, std::uint32_t seed)
{
    const float y = uv.y * static_cast<float>(bond.courses);
    const int course = std::min(bond.courses - 1, std::max(0, static_cast<int>(y)));
    const auto row = static_cast<std::uint32_t>(course);
    const auto count = static_cast<float>(bond.stones);
    const float shift = (course % 2 != 0 ? bond.shift : 0.0f) + bond.jitter * unit(mix(seed, 900 + row));
    const float x = uv.x * count - shift;
    const auto joint = [&](int k) { // place of joint k, in stones
        const auto id = static_cast<std::uint32_t>(wrap(k, bond.stones));
        return static_cast<float>(k) + bond.jitter * (unit(mix(mix(seed, row), id)) - 0.5f);
    };
    int k = static_cast<int>(std::floor(x));
    if (x < joint(k)) {
        --k;
    }
    if (x >= joint(k + 1)) {
        ++k;
    }
    const vec2 size = bond.tile / vec2(count, static_cast<float>(bond.courses));
    const float left = (x - joint(k)) * size.x, right = (joint(k + 1) - x) * size.x;
    const float low = (y - static_cast<float>(course)) * size.y, high = size.y - low;
    Stone stone;
    stone.id = mix(mix(seed + 17, row), static_cast<std::uint32_t>(wrap(k, bond.stones)));
    stone.half = {0.5f * (left + right), 0.5f * size.y};
    stone.within = {left - stone.half.x, low - stone.half.y};
    // Rounded corners: the distance is to a box with a small radius.
    const vec2 to_edge(std::min(left, right), std::min(low, high));
    constexpr float radius = 0.02f;
    const vec2 corner = glm::max(vec2(radius) - to_edge, vec2(0));
    stone.edge = corner.x > 0 && corner.y > 0 ? radius - glm::length(corner) : std::min(to_edge.x, to_edge.y);
    return stone;
}

} // namespace atrium::courtyard
