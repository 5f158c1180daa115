#pragma once
// Opacity of a masked material as the truth reads it: mip 0, bilinear.

#include "renderer/scene/scene.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace atrium::truth {

/// Alpha of a texture's largest mip, 8 bits a texel. Formats without alpha (r8, rg8, BC1, BC5) are opaque.
class AlphaMap {
public:
    /// `texels`: the bake's whole section; the texture must lie within it (BakeFile has checked).
    AlphaMap(const Texture& texture, std::span<const std::byte> texels);

    /// Bilinear, 0..1. Texel (i, j) has its centre at ((i + 0.5) / width, (j + 0.5) / height), j from the top; outside
    /// the texture repeats or keeps its border, as the texture says. 1 where uv is not finite.
    [[nodiscard]] double sample(const glm::dvec2& uv) const;

private:
    [[nodiscard]] double texel(std::int64_t x, std::int64_t y) const;

    std::int64_t width_, height_;
    bool clamp_;
    std::vector<std::uint8_t> alpha_;
};

} // namespace atrium::truth
