#include "app/config.hpp"

#include "app/scene_writer.hpp"
#include "app/toml_text.hpp"
#include "renderer/core/error.hpp"

#include <fmt/format.h>

namespace atrium::app {
namespace {

FrameConfig from_picture(const std::filesystem::path& file, const ImageMetadata& metadata)
{
    const auto text = metadata.find(metadata_key);
    if (text == metadata.end()) {
        throw Error(ExitCode::input, fmt::format("{} carries no settings", file.string()), file.string(),
                    fmt::format("it has no text called \"{}\"", metadata_key),
                    "use a picture that atrium wrote, or a TOML file");
    }
    return parse_frame_config(text->second, file);
}

} // namespace

ImageMetadata describe_frame(const FrameRequest& request, double time)
{
    // Bind to fresh settings, whose values are the defaults, then show those of the request.
    Settings settings;
    SettingList list;
    describe(list, settings);
    settings = request.settings;

    std::string out = fmt::format("width = {}\nheight = {}\ntime = {}\nlights = [", request.size.x, request.size.y,
                                  toml_number(time));
    for (const Light& light : request.lights) out += fmt::format("\n    {},", toml_string(to_spec(light)));
    out += "\n]\n[camera]\n" + toml_camera(request.camera);
    out += "[settings]\n";
    for (const SettingText& s : portable_settings(list)) out += fmt::format("{} = {}\n", s.key, toml_string(s.value));
    return {{metadata_key, out + materials_toml(request.materials)}};
}

FrameConfig read_config(const std::filesystem::path& file)
{
    ImageMetadata metadata;
    if (file.extension() == ".png") {
        static_cast<void>(read_png(file, &metadata));
        return from_picture(file, metadata);
    }
    if (file.extension() == ".exr") {
        static_cast<void>(read_exr(file, &metadata));
        return from_picture(file, metadata);
    }
    return read_settings_file(file);
}

} // namespace atrium::app
