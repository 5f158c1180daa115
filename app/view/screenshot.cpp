#include "app/view/screenshot.hpp"

#include "app/config.hpp"
#include "app/view/numbered_file.hpp"

#include <fmt/format.h>

namespace atrium::app {

std::string write_screenshot(Engine& engine, FrameRequest frame)
{
    constexpr const char *png = ".png", *exr = ".exr";
    const std::string name = unused_name({png, exr});
    frame.want_picture = frame.want_hdr = true;
    const FrameResult drawn = engine.render(frame);
    const ImageMetadata description = describe_frame(frame, 0);
    write_exr(name + exr, drawn.hdr, description);
    write_png(name + png, drawn.picture, description);
    return fmt::format("{}{} and {} written; --config {}{} draws it again", name, png, exr, name, png);
}

} // namespace atrium::app
