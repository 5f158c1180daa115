#include "assetconv/texture_recipe.hpp"

#include "assetconv/channels.hpp"
#include "assetconv/dilate.hpp"
#include "assetconv/normal_maps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace atrium {
namespace {

std::uint8_t to_byte(float x)
{
    return static_cast<std::uint8_t>(glm::clamp(x, 0.0f, 1.0f) * 255.0f + 0.5f);
}

/// Reads an image as if it had another size.
class Resampled {
public:
    Resampled(const SourceImage& image, int width, int height, bool clamp)
        : image_(image), same_(image.width == width && image.height == height), clamp_(clamp),
          scale_(static_cast<float>(image.width) / static_cast<float>(width),
                 static_cast<float>(image.height) / static_cast<float>(height))
    {}

    /// `read(image, x, y)` gives the value of a texel; bilinear between them.
    template <class Read>
    auto at(int x, int y, Read&& read) const
    {
        if (same_) return read(image_, x, y);
        const float fx = (static_cast<float>(x) + 0.5f) * scale_.x - 0.5f;
        const float fy = (static_cast<float>(y) + 0.5f) * scale_.y - 0.5f;
        const float x0 = std::floor(fx), y0 = std::floor(fy), tx = fx - x0, ty = fy - y0;
        const int l = wrap(static_cast<int>(x0), image_.width), r = wrap(static_cast<int>(x0) + 1, image_.width);
        const int t = wrap(static_cast<int>(y0), image_.height), b = wrap(static_cast<int>(y0) + 1, image_.height);
        const auto top = read(image_, l, t) * (1 - tx) + read(image_, r, t) * tx;
        const auto low = read(image_, l, b) * (1 - tx) + read(image_, r, b) * tx;
        return top * (1 - ty) + low * ty;
    }

private:
    [[nodiscard]] int wrap(int i, int n) const { return clamp_ ? std::clamp(i, 0, n - 1) : ((i % n) + n) % n; }

    const SourceImage& image_;
    bool same_, clamp_;
    vec2 scale_;
};

class Packer {
public:
    Packer(const TextureRecipe& recipe, const ImageStore& images) : recipe_(recipe), images_(images)
    {
        for (const auto* map :
             {&recipe.color, &recipe.alpha, &recipe.specular, &recipe.shininess, &recipe.roughness, &recipe.metallic}) {
            if (!*map) continue;
            const SourceImage& image = source(**map);
            out_.width = std::max(out_.width, image.width);
            out_.height = std::max(out_.height, image.height);
        }
        out_.channels = recipe.role == TextureRole::normal ? 2 : 4;
        out_.texels.assign(static_cast<std::size_t>(out_.width) * static_cast<std::size_t>(out_.height) *
                               static_cast<std::size_t>(out_.channels),
                           255);
    }

    PackedImage run()
    {
        switch (recipe_.role) {
        case TextureRole::base_color:
        case TextureRole::emission:
            pack_color();
            break;
        case TextureRole::normal:
            pack_normals();
            break;
        case TextureRole::surface:
            pack_surface();
            break;
        }
        return std::move(out_);
    }

private:
    [[nodiscard]] const SourceImage& source(const MapInput& map) const { return *images_.find(map.image); }

    void pack_color()
    {
        if (recipe_.color) {
            const MapInput& map = *recipe_.color;
            const bool plain = map.base == 0 && map.gain == 1;
            const Resampled image(source(map), out_.width, out_.height, recipe_.clamp);
            each([&](int x, int y, std::uint8_t* texel) {
                const vec3 c = image.at(x, y, [](const SourceImage& s, int i, int j) { return s.rgb(i, j); });
                for (int k = 0; k < 3; ++k) texel[k] = to_byte(plain ? c[k] : map.adjust(c[k]));
            });
        }
        if (!recipe_.alpha) return;
        fill_channel(3, *recipe_.alpha);
        dilate_color(out_, recipe_.cutoff ? static_cast<int>(std::ceil(*recipe_.cutoff * 255)) : 1);
    }

    void pack_normals()
    {
        const SourceImage& image = source(*recipe_.color);
        if (recipe_.from_height) {
            const MapInput& map = *recipe_.color;
            const float strength = recipe_.strength * map.gain;
            store_normals(normals_from_height(image, map.channel, strength, recipe_.clamp));
            return;
        }
        std::vector<vec3> normals = read_normals(image).normals;
        for (vec3& n : normals) {
            n.y *= recipe_.green_down ? -1.0f : 1.0f;
            n = glm::normalize(vec3(n.x * recipe_.strength, n.y * recipe_.strength, n.z));
        }
        store_normals(normals);
    }

    void store_normals(const std::vector<vec3>& normals)
    {
        for (std::size_t i = 0; i < normals.size(); ++i) {
            out_.texels[i * 2] = to_byte(normals[i].x * 0.5f + 0.5f);
            out_.texels[i * 2 + 1] = to_byte(normals[i].y * 0.5f + 0.5f);
        }
    }

    void pack_surface()
    {
        if (recipe_.specular) fill_channel(0, *recipe_.specular);
        if (recipe_.metallic) fill_channel(2, *recipe_.metallic);
        if (recipe_.roughness)
            fill_channel(1, *recipe_.roughness);
        else if (recipe_.bake_roughness)
            bake_roughness();
    }

    void bake_roughness()
    {
        if (recipe_.shininess) fill_channel(1, *recipe_.shininess);
        std::array<float, 256> of_exponent{};
        for (std::size_t i = 0; i < 256; ++i) {
            of_exponent[i] = recipe_.shininess ? roughness_of_exponent(recipe_.ns * static_cast<float>(i) / 255.0f)
                                               : recipe_.base_roughness;
        }
        each([&](int, int, std::uint8_t* texel) {
            const float r = of_exponent[texel[1]];
            const float specular = static_cast<float>(texel[0]) / 255.0f;
            texel[1] = to_byte(recipe_.specular ? roughness_under_specular_map(r, specular) : r);
        });
    }

    void fill_channel(int channel, const MapInput& map)
    {
        const Resampled image(source(map), out_.width, out_.height, recipe_.clamp);
        each([&](int x, int y, std::uint8_t* texel) {
            const float v = image.at(
                x, y, [&](const SourceImage& s, int i, int j) { return scalar_channel(s, i, j, map.channel); });
            texel[channel] = to_byte(map.adjust(v));
        });
    }

    template <class Body>
    void each(Body&& body)
    {
        for (int y = 0; y < out_.height; ++y) {
            for (int x = 0; x < out_.width; ++x) body(x, y, out_.at(x, y));
        }
    }

    const TextureRecipe& recipe_;
    const ImageStore& images_;
    PackedImage out_;
};

std::string key_of(const std::optional<MapInput>& map)
{
    if (!map) return "-";
    return fmt::format("{}|{}|{}|{}|{}", map->image.file.string(), map->image.colour, map->channel, map->base,
                       map->gain);
}

} // namespace

std::string TextureRecipe::key() const
{
    return fmt::format("{} {} {} {} {} {} {} {} {} {} {}\n{}\n{}\n{}\n{}\n{}\n{}", static_cast<int>(role), clamp,
                       cutoff.value_or(0), from_height, green_down, strength, bake_roughness, base_roughness, ns,
                       color.has_value(), alpha.has_value(), key_of(color), key_of(alpha), key_of(specular),
                       key_of(shininess), key_of(roughness), key_of(metallic));
}

std::string TextureRecipe::file() const
{
    std::vector<std::string> names;
    for (const auto* map : {&color, &alpha, &specular, &shininess, &roughness, &metallic}) {
        if (*map && std::find(names.begin(), names.end(), (*map)->name) == names.end()) names.push_back((*map)->name);
    }
    return fmt::format("{}", fmt::join(names, "+"));
}

PackedImage pack_texture(const TextureRecipe& recipe, const ImageStore& images)
{
    return Packer(recipe, images).run();
}

float roughness_of_exponent(float ns)
{
    return std::pow(2.0f / (std::max(ns, 0.0f) + 2.0f), 0.25f);
}

float roughness_under_specular_map(float roughness, float specular)
{
    return glm::mix(std::min(1.0f, roughness + 0.2f), roughness, specular);
}

} // namespace atrium
