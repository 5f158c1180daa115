#include "app/output.hpp"

#include "app/config.hpp"
#include "renderer/core/error.hpp"
#include "renderer/core/nearest_name.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>

namespace atrium::app {
namespace {

constexpr std::size_t max_frames = 1000000;

std::optional<std::size_t> parse_count(std::string_view text)
{
    std::size_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size() || value > max_frames) return std::nullopt;
    return value;
}

[[noreturn]] void refuse_frames(const std::string& text)
{
    throw Error(ExitCode::usage, fmt::format("--frames takes N or A-B, not \"{}\"", text), "--frames",
                fmt::format("N is 1 to {}, A is at most B", max_frames),
                "for example --frames 10, or --frames 100-199");
}

void write_image(const std::filesystem::path& file, const ImageF& image, const ImageMetadata& metadata)
{
    write_exr(file, image, metadata);
}

} // namespace

OutputPlan::OutputPlan(std::filesystem::path picture, const std::string& frames, const std::vector<std::string>& aovs)
    : picture_(std::move(picture))
{
    const std::string extension = picture_.extension().string();
    png_ = extension == ".png";
    if (!png_ && extension != ".exr") {
        throw Error(ExitCode::usage, fmt::format("cannot tell the format of {}", picture_.string()), "-o",
                    fmt::format("it ends in \"{}\"", extension), "name it .png or .exr");
    }
    if (!frames.empty()) {
        const std::size_t dash = frames.find('-');
        const auto first =
            dash == std::string::npos ? std::optional<std::size_t>(0) : parse_count(frames.substr(0, dash));
        const auto second = parse_count(dash == std::string::npos ? frames : frames.substr(dash + 1));
        if (!first || !second) refuse_frames(frames);
        if (dash == std::string::npos && *second == 0) refuse_frames(frames);
        first_ = *first;
        last_ = dash == std::string::npos ? *second - 1 : *second;
        if (last_ < first_) refuse_frames(frames);
    }
    for (const std::string& text : aovs) {
        const std::size_t equals = text.find('=');
        if (equals == std::string::npos || !text.ends_with(".exr")) {
            throw Error(ExitCode::usage, fmt::format("--aov takes NAME=FILE.exr, not \"{}\"", text), "--aov",
                        "AOVs are written as EXR", "for example --aov depth=depth.exr");
        }
        aovs_.push_back({text.substr(0, equals), text.substr(equals + 1)});
    }
}

bool OutputPlan::numbered() const
{
    return picture_.filename().string().find('#') != std::string::npos;
}

std::filesystem::path OutputPlan::numbered_name(const std::filesystem::path& pattern, std::size_t i) const
{
    std::string name = pattern.filename().string();
    const std::size_t first = name.find('#');
    if (first == std::string::npos) return pattern;
    const std::size_t end = std::min(name.find_first_not_of('#', first), name.size());
    name.replace(first, end - first, fmt::format("{:0{}}", first_ + i, end - first));
    return pattern.parent_path() / name;
}

bool OutputPlan::exists(std::size_t i) const
{
    return std::filesystem::exists(numbered_name(picture_, i));
}

void OutputPlan::check_writable() const
{
    std::vector<std::filesystem::path> files{picture_};
    for (const AovOutput& aov : aovs_) files.push_back(aov.file);
    for (const std::filesystem::path& file : files) {
        const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
        if (!std::filesystem::is_directory(folder)) {
            throw Error(ExitCode::environment, fmt::format("cannot write {}", file.string()), folder.string(),
                        "there is no such folder", "make the folder, or write elsewhere");
        }
    }
}

void OutputPlan::write(std::size_t i, const FrameResult& frame, const FrameRequest& request, double time) const
{
    const ImageMetadata metadata = describe_frame(request, time);
    const std::filesystem::path picture = numbered_name(picture_, i);
    if (png_)
        write_png(picture, frame.picture, metadata);
    else
        write_image(picture, frame.hdr, metadata);
    for (std::size_t a = 0; a < aovs_.size(); ++a)
        write_image(numbered_name(aovs_[a].file, i), frame.aovs[a], metadata);
}

Camera CameraPath::camera_at(double time, const Camera& otherwise) const
{
    if (keys_.empty()) return otherwise;
    const auto t = static_cast<float>(time);
    const auto next = std::find_if(keys_.begin(), keys_.end(), [&](const CameraKey& k) { return k.time > t; });
    Camera camera = otherwise; // the field of view stays
    if (next == keys_.begin() || next == keys_.end()) {
        const CameraKey& end = next == keys_.begin() ? keys_.front() : keys_.back();
        camera.eye = end.eye;
        camera.target = end.target;
        return camera;
    }
    const auto at = [&](std::ptrdiff_t i) -> const CameraKey& {
        return keys_[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(i, 0, std::ssize(keys_) - 1))];
    };
    const std::ptrdiff_t i = next - keys_.begin();
    const float u = (t - at(i - 1).time) / (at(i).time - at(i - 1).time);
    // Source: Catmull & Rom 1974.
    const auto curve = [u](const vec3& a, const vec3& b, const vec3& c, const vec3& d) {
        return 0.5f * (2.0f * b + u * (c - a) + u * u * (2.0f * a - 5.0f * b + 4.0f * c - d) +
                       u * u * u * (3.0f * b - a - 3.0f * c + d));
    };
    camera.eye = curve(at(i - 2).eye, at(i - 1).eye, at(i).eye, at(i + 1).eye);
    camera.target = curve(at(i - 2).target, at(i - 1).target, at(i).target, at(i + 1).target);
    return camera;
}

CameraPath find_path(const std::string& name, const SceneFile& file)
{
    if (name.empty()) return {};
    if (const auto found = file.paths.find(name); found != file.paths.end()) return CameraPath(found->second);
    std::vector<std::string> names;
    for (const auto& [path, keys] : file.paths) names.push_back(path);
    throw Error(ExitCode::usage, fmt::format("no camera path is called \"{}\"", name), "--path",
                names.empty() ? "the scene has none" : fmt::format("did you mean \"{}\"?", nearest_name(name, names)),
                "paths stand in a scene file as [path.NAME]");
}

} // namespace atrium::app
