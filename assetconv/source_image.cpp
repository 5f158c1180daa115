#include "assetconv/source_image.hpp"

#include "assetconv/srgb.hpp"
#include "renderer/core/jobs.hpp"
#include "renderer/core/progress.hpp"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <mutex>
#include <optional>
#include <utility>

namespace atrium {
namespace {

/// What a read gave: an image, or why there is none.
struct Outcome {
    std::optional<SourceImage> image;
    std::string why;
};

std::string first_line(const std::string& text)
{
    return text.substr(0, text.find('\n'));
}

void read_bytes(OIIO::ImageInput& input, const OIIO::ImageSpec& spec, int stored, SourceImage& image, bool& good)
{
    image.bytes.resize(static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(spec.height) *
                       static_cast<std::size_t>(stored));
    good = input.read_image(0, 0, 0, stored, OIIO::TypeDesc::UINT8, image.bytes.data());
}

void read_words(OIIO::ImageInput& input, const OIIO::ImageSpec& spec, int stored, bool colour, SourceImage& image,
                bool& good)
{
    const std::size_t count =
        static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(spec.height) * static_cast<std::size_t>(stored);
    image.words.resize(count);
    if (!spec.format.is_floating_point()) {
        good = input.read_image(0, 0, 0, stored, OIIO::TypeDesc::UINT16, image.words.data());
        return;
    }
    std::vector<float> linear(count);
    good = input.read_image(0, 0, 0, stored, OIIO::TypeDesc::FLOAT, linear.data());
    for (std::size_t i = 0; i < count; ++i) {
        const bool is_alpha = image.has_alpha() && static_cast<int>(i % static_cast<std::size_t>(stored)) == stored - 1;
        const float bounded = linear[i] > 0 ? std::min(linear[i], 1.0f) : 0.0f; // NaN becomes 0
        const float encoded = colour && !is_alpha ? srgb_encode(bounded) : bounded;
        image.words[i] = static_cast<std::uint16_t>(encoded * 65535.0f + 0.5f);
    }
}

Outcome read_image(const ImageKey& key)
{
    OIIO::ImageSpec config;
    config["oiio:UnassociatedAlpha"] = 1; // else colour comes multiplied by alpha, and masks get dark rims
    config["oiio:RawColor"] = 0;
    const auto input = OIIO::ImageInput::open(key.file.string(), &config);
    if (!input) return {std::nullopt, first_line(OIIO::geterror())};
    const OIIO::ImageSpec spec = input->spec();
    if (spec.width <= 0 || spec.height <= 0 || spec.depth > 1 || spec.nchannels <= 0)
        return {std::nullopt, "it is no two-dimensional image"};
    if (spec.width > max_image_side || spec.height > max_image_side ||
        std::int64_t{spec.width} * spec.height > max_image_pixels)
        return {std::nullopt, "it is larger than 16384 x 8192 pixels"};
    SourceImage image;
    image.width = spec.width;
    image.height = spec.height;
    image.channels = std::min(spec.nchannels, 4);
    bool good = false;
    if (spec.format.basesize() == 1)
        read_bytes(*input, spec, image.channels, image, good);
    else
        read_words(*input, spec, image.channels, key.colour, image, good);
    if (!good) return {std::nullopt, first_line(input->geterror())};
    gather_facts(image);
    return {std::move(image), ""};
}

/// OpenImageIO throws nothing, but the libraries below it may.
Outcome try_to_read(const ImageKey& key)
{
    try {
        return read_image(key);
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& e) {
        return {std::nullopt, first_line(e.what())};
    }
}

} // namespace

void gather_facts(SourceImage& image)
{
    image.alpha_min = image.luminance_min = 1;
    image.alpha_max = image.luminance_max = 0;
    image.largest_spread = 0;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const vec3 c = image.rgb(x, y);
            const float luminance = glm::dot(c, vec3(0.2126f, 0.7152f, 0.0722f)), alpha = image.alpha(x, y);
            image.luminance_min = std::min(image.luminance_min, luminance);
            image.luminance_max = std::max(image.luminance_max, luminance);
            image.alpha_min = std::min(image.alpha_min, alpha);
            image.alpha_max = std::max(image.alpha_max, alpha);
            const float spread = std::max({c.x, c.y, c.z}) - std::min({c.x, c.y, c.z});
            image.largest_spread = std::max(image.largest_spread, spread);
        }
    }
}

void ImageStore::load(Warnings& warnings)
{
    OIIO::attribute("threads", 1); // the jobs are the threads
    OIIO::attribute("exr_threads", -1);
    const std::vector<std::pair<ImageKey, std::string>> wanted(wanted_.begin(), wanted_.end());
    std::vector<Outcome> outcomes(wanted.size());
    if (!wanted.empty()) {
        Progress progress("reading textures", wanted.size());
        parallel_for(wanted.size(), [&](std::size_t i) {
            outcomes[i] = try_to_read(wanted[i].first);
            progress.advance();
        });
    }
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        const ImageKey& key = wanted[i].first;
        if (outcomes[i].image)
            images_.emplace(key, std::move(*outcomes[i].image));
        else
            warnings.add("texture-unreadable",
                         wanted[i].second + ": " + key.file.filename().string() + ": " + outcomes[i].why);
    }
}

const SourceImage* ImageStore::find(const ImageKey& key) const
{
    const auto found = images_.find(key);
    return found == images_.end() ? nullptr : &found->second;
}

} // namespace atrium
