#pragma once
// Images in host memory and the two file formats that Atrium writes. Row 0 is the top.

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace atrium {

/// width x height x channels 32-bit floats, channels interleaved.
struct ImageF {
    int width = 0, height = 0, channels = 0;
    std::vector<float> values;

    ImageF() = default;
    ImageF(int w, int h, int c, float fill = 0.0f)
        : width(w), height(h), channels(c),
          values(static_cast<std::size_t>(w) * static_cast<std::size_t>(h) * static_cast<std::size_t>(c), fill)
    {}
    [[nodiscard]] std::size_t index(int x, int y) const
    {
        return (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)) *
               static_cast<std::size_t>(channels);
    }
    [[nodiscard]] const float* at(int x, int y) const { return &values[index(x, y)]; }
    [[nodiscard]] float* at(int x, int y) { return &values[index(x, y)]; }
};

/// width x height x channels bytes: 1 grey, 3 RGB or 4 RGBA. Colour is sRGB-encoded unless said otherwise.
struct Image8 {
    int width = 0, height = 0, channels = 0;
    std::vector<std::uint8_t> values;

    Image8() = default;
    Image8(int w, int h, int c, std::uint8_t fill = 0)
        : width(w), height(h), channels(c),
          values(static_cast<std::size_t>(w) * static_cast<std::size_t>(h) * static_cast<std::size_t>(c), fill)
    {}
    [[nodiscard]] std::size_t index(int x, int y) const
    {
        return (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)) *
               static_cast<std::size_t>(channels);
    }
    [[nodiscard]] const std::uint8_t* at(int x, int y) const { return &values[index(x, y)]; }
    [[nodiscard]] std::uint8_t* at(int x, int y) { return &values[index(x, y)]; }
};

/// Text kept inside a picture: keyword to value. PNG stores it in iTXt chunks, EXR in string attributes.
using ImageMetadata = std::map<std::string, std::string>;

/// Both write to a temporary beside and rename; both give the same bytes for the same input (no dates).
/// PNG trades some size for speed. EXR is 32-bit float, ZIP-compressed; channel names: one channel "Y",
/// two "R,G", three "R,G,B". Throw Error(environment) when the file cannot be written.
void write_png(const std::filesystem::path& file, const Image8& image, const ImageMetadata& metadata = {});
void write_exr(const std::filesystem::path& file, const ImageF& image, const ImageMetadata& metadata = {});

/// Throw Error(input) on a missing, damaged or unsupported file.
/// The stored values of a PNG of 8 or 16 bits over their maximum: 0 to 1.
[[nodiscard]] ImageF read_png_values(const std::filesystem::path& file);
[[nodiscard]] Image8 read_png(const std::filesystem::path& file, ImageMetadata* metadata = nullptr);
[[nodiscard]] ImageF read_exr(const std::filesystem::path& file, ImageMetadata* metadata = nullptr);

} // namespace atrium
