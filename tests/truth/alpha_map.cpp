#include "tests/truth/alpha_map.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace atrium::truth {
namespace {

std::uint32_t byte_at(std::span<const std::byte> bytes, std::size_t i)
{
    return std::to_integer<std::uint32_t>(bytes[i]);
}

/// The 16 alphas of a BC3 block, row after row: two end points, then 3 bits a texel.
std::array<std::uint8_t, 16> bc3_alpha(std::span<const std::byte> block)
{
    const std::uint32_t a0 = byte_at(block, 0), a1 = byte_at(block, 1);
    std::array<std::uint32_t, 8> ramp{a0, a1};
    const std::uint32_t steps = a0 > a1 ? 7 : 5;
    for (std::uint32_t k = 1; k < steps; ++k) ramp[k + 1] = ((steps - k) * a0 + k * a1 + steps / 2) / steps;
    if (steps == 5) {
        ramp[6] = 0;
        ramp[7] = 255;
    }
    std::uint64_t codes = 0;
    for (std::size_t i = 0; i < 6; ++i) codes |= std::uint64_t{byte_at(block, 2 + i)} << (8 * i);
    std::array<std::uint8_t, 16> alpha{};
    for (std::size_t i = 0; i < 16; ++i) alpha[i] = static_cast<std::uint8_t>(ramp[codes >> (3 * i) & 7]);
    return alpha;
}

} // namespace

AlphaMap::AlphaMap(const Texture& texture, std::span<const std::byte> texels)
    : width_(texture.width), height_(texture.height), clamp_(texture.clamp),
      alpha_(std::size_t{texture.width} * texture.height, 255)
{
    const auto mip0 = texels.subspan(texture.offset, mip_bytes(texture.format, texture.width, texture.height));
    switch (texture.format) {
    case TextureFormat::rgba8_srgb:
    case TextureFormat::rgba8_unorm:
        for (std::size_t i = 0; i < alpha_.size(); ++i) alpha_[i] = static_cast<std::uint8_t>(mip0[4 * i + 3]);
        break;
    case TextureFormat::bc3_srgb:
    case TextureFormat::bc3_unorm: {
        const std::size_t width = texture.width, columns = (width + 3) / 4;
        for (std::size_t i = 0; i < alpha_.size(); ++i) {
            const std::size_t x = i % width, y = i / width;
            alpha_[i] = bc3_alpha(mip0.subspan((y / 4 * columns + x / 4) * 16, 16))[y % 4 * 4 + x % 4];
        }
        break;
    }
    default:
        break;
    }
}

double AlphaMap::texel(std::int64_t x, std::int64_t y) const
{
    if (clamp_) {
        x = std::clamp<std::int64_t>(x, 0, width_ - 1);
        y = std::clamp<std::int64_t>(y, 0, height_ - 1);
    } else {
        x = (x % width_ + width_) % width_;
        y = (y % height_ + height_) % height_;
    }
    return alpha_[static_cast<std::size_t>(y * width_ + x)] / 255.0;
}

double AlphaMap::sample(const glm::dvec2& uv) const
{
    if (!std::isfinite(uv.x) || !std::isfinite(uv.y)) return 1;
    // Into one period, or one step beyond the border, before anything is cast.
    const auto place = [&](double u) { return clamp_ ? std::clamp(u, -1.0, 2.0) : u - std::floor(u); };
    const double x = place(uv.x) * static_cast<double>(width_) - 0.5;
    const double y = place(uv.y) * static_cast<double>(height_) - 0.5;
    const auto x0 = static_cast<std::int64_t>(std::floor(x)), y0 = static_cast<std::int64_t>(std::floor(y));
    const double fx = x - std::floor(x), fy = y - std::floor(y);
    const double top = glm::mix(texel(x0, y0), texel(x0 + 1, y0), fx);
    const double bottom = glm::mix(texel(x0, y0 + 1), texel(x0 + 1, y0 + 1), fx);
    return glm::mix(top, bottom, fy);
}

} // namespace atrium::truth
