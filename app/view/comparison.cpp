#include "app/view/comparison.hpp"

#include "app/config.hpp"
#include "app/view/numbered_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

namespace atrium::app {

Image8 amplified_difference(const Image8& a, const Image8& b, int factor)
{
    Image8 out(a.width, a.height, a.channels);
    for (std::size_t i = 0; i < out.values.size(); ++i)
        out.values[i] = static_cast<std::uint8_t>(std::min(factor * std::abs(a.values[i] - b.values[i]), 255));
    return out;
}

std::string write_comparison(Engine& engine, FrameRequest frame)
{
    constexpr const char *as_it_is = ".filtered.png", *reference = ".reference.png", *difference = ".difference.png";
    constexpr int factor = 4;
    frame.want_picture = true;
    const std::string name = unused_name({as_it_is, reference, difference});
    const auto draw = [&](const char* ending) {
        Image8 picture = engine.render(frame).picture;
        write_png(name + ending, picture, describe_frame(frame, 0));
        return picture;
    };
    const Image8 filtered = draw(as_it_is);
    frame.settings.shadow.filter = ShadowFilter::reference;
    write_png(name + difference, amplified_difference(filtered, draw(reference), factor));
    return fmt::format("{}{}, {} and {} (x {}) written", name, as_it_is, reference, difference, factor);
}

} // namespace atrium::app
