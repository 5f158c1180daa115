#pragma once
// Textures as the files have them, decoded by OpenImageIO.

#include "assetconv/warnings.hpp"
#include "renderer/core/math.hpp"

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace atrium {

/// Larger sides than this fit no device, and would let a small file ask for much memory.
inline constexpr int max_image_side = 16384;
inline constexpr std::int64_t max_image_pixels = std::int64_t{8192} * 16384;

/// Decoded texels, row 0 at the top, as encoded in the file (no sRGB decoding). Files deeper than 8 bits are kept at 16
/// (a height map of 8 bits would show terraces). Floating-point files are linear and are kept sRGB-encoded when
/// they were asked for as colour.
class SourceImage {
public:
    int width = 0, height = 0;
    int channels = 0;                ///< 1 grey, 2 grey and alpha, 3 RGB, 4 RGBA
    std::vector<std::uint8_t> bytes; ///< one of the two is filled
    std::vector<std::uint16_t> words;

    float alpha_min = 1, alpha_max = 1;
    float luminance_min = 0, luminance_max = 1;
    float largest_spread = 0; ///< largest difference between the colour channels of one texel

    [[nodiscard]] bool has_alpha() const { return channels == 2 || channels == 4; }
    [[nodiscard]] bool is_grey() const { return largest_spread < 2.0f / 255.0f; }

    /// 0..1
    [[nodiscard]] float value(int x, int y, int channel) const
    {
        const std::size_t i =
            (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)) *
                static_cast<std::size_t>(channels) +
            static_cast<std::size_t>(channel);
        return bytes.empty() ? static_cast<float>(words[i]) / 65535.0f : static_cast<float>(bytes[i]) / 255.0f;
    }
    /// RGB of a texel; grey is repeated.
    [[nodiscard]] vec3 rgb(int x, int y) const
    {
        if (channels < 3) return vec3(value(x, y, 0));
        return {value(x, y, 0), value(x, y, 1), value(x, y, 2)};
    }
    [[nodiscard]] float alpha(int x, int y) const { return has_alpha() ? value(x, y, channels - 1) : 1.0f; }
    [[nodiscard]] float luminance(int x, int y) const { return glm::dot(rgb(x, y), vec3(0.2126f, 0.7152f, 0.0722f)); }
};

/// Fills the facts (alpha_min …) from the texels.
void gather_facts(SourceImage& image);

/// A file in one of its two uses.
struct ImageKey {
    std::filesystem::path file;
    bool colour = false;
    auto operator<=>(const ImageKey&) const = default;
};

/// Images by file, each decoded once.
class ImageStore {
public:
    /// Notes a file for loading. `where` is the place that names it first, for warnings.
    void want(const ImageKey& key, const std::string& where) { wanted_.try_emplace(key, where); }
    /// Decodes everything wanted, in parallel, with a progress bar. Files that fail are counted as warnings.
    void load(Warnings& warnings);
    /// nullptr when the file could not be read.
    [[nodiscard]] const SourceImage* find(const ImageKey& key) const;

private:
    std::map<ImageKey, std::string> wanted_;
    std::map<ImageKey, SourceImage> images_;
};

} // namespace atrium
