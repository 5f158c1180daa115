// `atrium upscale`: the renderer's upscalers on any picture.

#include "app/commands.hpp"
#include "app/options.hpp"
#include "app/scene_input.hpp"
#include "renderer/core/error.hpp"
#include "renderer/core/image.hpp"
#include "renderer/core/output_guard.hpp"
#include "renderer/core/text_value.hpp"
#include "renderer/engine.hpp"
#include "renderer/frame_resources.hpp"
#include "renderer/techniques/upscale/upscale.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace atrium::app {
namespace {

constexpr double most = 4; // of either axis

struct Options {
    std::filesystem::path in, out;
    std::optional<double> ratio;
    std::optional<uvec2> size;
    std::string method = "fsr1", sharpness = "0.2";
    SceneOptions device;
};

uvec2 target_size(const Options& o, uvec2 source)
{
    const uvec2 size = o.ratio ? uvec2(glm::round(glm::dvec2(source) * *o.ratio)) : *o.size;
    const glm::dvec2 ratio = glm::dvec2(size) / glm::dvec2(source);
    if (ratio.x < 1 || ratio.y < 1 || ratio.x > most || ratio.y > most)
        throw Error(ExitCode::usage, "the picture cannot be made that large", o.ratio ? "--ratio" : "--size",
                    fmt::format("{} x {} to {} x {} is {:.3g} and {:.3g} times; 1 to {} are allowed", source.x,
                                source.y, size.x, size.y, ratio.x, ratio.y, most),
                    "choose another size, or upscale in two steps");
    return size;
}

/// Stops; empty for "off".
std::optional<float> parse_sharpness(const std::string& text)
{
    if (text == "off") return std::nullopt;
    const std::optional<float> stops = parse_float(text);
    if (!stops || *stops < 0 || *stops > 10)
        throw Error(ExitCode::usage, fmt::format("\"{}\" is no sharpness", text), "--sharpness",
                    "it takes stops from 0 (most) to 10, or off", "try --sharpness 0.2");
    return stops;
}

UpscaleMethod parse_method(const std::string& text)
{
    const auto names = enum_names(UpscaleMethod{});
    return static_cast<UpscaleMethod>(std::find(names.begin(), names.end(), text) - names.begin());
}

graph::Tex upload(graph::Graph& g, const Image8& image)
{
    const auto width = static_cast<std::uint32_t>(image.width), height = static_cast<std::uint32_t>(image.height);
    const auto channels = static_cast<std::size_t>(image.channels);
    std::vector<std::uint8_t> rgba(std::size_t{4} * width * height, 255);
    for (std::size_t i = 0; i < rgba.size() / 4; ++i) {
        for (std::size_t c = 0; c < 3; ++c) rgba[4 * i + c] = image.values[channels * i + (channels == 1 ? 0 : c)];
    }
    const graph::Buf bytes = g.upload("picture.bytes", rgba);
    const graph::Tex picture = g.texture("picture", {gpu::Format::rgba8_unorm, width, height});
    g.transfer("upload").reads(bytes).writes(picture).record([=](graph::Cmd& cmd) { cmd.copy(bytes, picture); });
    return picture;
}

int run(const Options& o)
{
    const std::array inputs{o.in};
    refuse_overwriting(std::array{OutputFile{"--output", o.out}}, inputs);
    if (o.ratio.has_value() == o.size.has_value())
        throw Error(ExitCode::usage, "the new size is not clear", "atrium upscale",
                    o.ratio ? "both --ratio and --size were given" : "neither --ratio nor --size was given",
                    "give one of them");
    const std::optional<float> stops = parse_sharpness(o.sharpness);
    const Image8 image = read_png(o.in);
    const uvec2 source(glm::ivec2(image.width, image.height)), size = target_size(o, source);
    const UpscaleMethod method = parse_method(o.method);

    Engine engine(engine_options(o.device));
    Readbacks readbacks(engine.device());
    graph::Graph g(engine.runner(), {size, size, "upscale"});
    graph::Tex picture = add_upscale(g, upload(g, image), size, method);
    // Sharpening belongs to FSR; other filters are shown as they are, unless the size stays.
    if (stops && (method == UpscaleMethod::fsr1 || size == source)) picture = add_sharpening(g, picture, *stops);
    const gpu::Buffer& back = readbacks.add(g, picture, "picture");
    static_cast<void>(engine.runner().run(g));

    Image8 out(static_cast<int>(size.x), static_cast<int>(size.y), 3);
    const std::span<const std::byte> rgba = bytes_in(back);
    for (std::size_t i = 0; i < out.values.size() / 3; ++i) std::memcpy(&out.values[3 * i], &rgba[4 * i], 3);
    write_png(o.out, out);
    return verdict(engine);
}

} // namespace

Run add_upscale_command(CLI::App& app)
{
    const auto o = std::make_shared<Options>();
    CLI::App* command = app.add_subcommand("upscale", "enlarge a picture as the renderer does");
    command->add_option("IN", o->in, "a PNG; its values are taken as encoded for display")->required();
    command->add_option("-o,--output", o->out, "the enlarged picture (PNG)")->required();
    command->add_option("--ratio", o->ratio, "how many times as large along each axis, 1 to 4");
    add_size_option(*command, o->size, "its size instead, WxH");
    command->add_option("--method", o->method, "the upscaler")
        ->check(CLI::IsMember({"fsr1", "bilinear", "catmullrom", "lanczos"}));
    command->add_option("--sharpness", o->sharpness, "of fsr1: stops from 0 (most), or off");
    add_device_options(*command, o->device);
    command->footer("Example:\n  atrium upscale small.png -o large.png --ratio 2");
    return [o] { return run(*o); };
}

} // namespace atrium::app
