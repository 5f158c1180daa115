#include "app/output.hpp"

#include "app/resume.hpp"
#include "app/toml_text.hpp"
#include "renderer/core/error.hpp"
#include "renderer/core/nearest_name.hpp"
#include "renderer/core/output_guard.hpp"

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

/// The metadata of an AOV's file, which must not be taken for another AOV's by --resume.
ImageMetadata with_aov(ImageMetadata metadata, const std::string& name)
{
    if (const auto found = metadata.find(resume_key); found != metadata.end())
        found->second += fmt::format("[aov]\nname = {}\n", toml_string(name));
    return metadata;
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

bool OutputPlan::is_done(std::size_t i, const ImageMetadata& metadata) const
{
    return is_whole(numbered_name(picture_, i), metadata) &&
           std::all_of(aovs_.begin(), aovs_.end(), [&](const AovOutput& aov) {
               return is_whole(numbered_name(aov.file, i), with_aov(metadata, aov.name));
           });
}

void OutputPlan::refuse_inputs(std::span<const std::filesystem::path> inputs) const
{
    for (std::size_t i = 0; i < frame_count(); ++i) {
        if (!writes(i)) continue;
        std::vector<OutputFile> files{{"-o", numbered_name(picture_, i)}};
        for (const AovOutput& aov : aovs_) files.push_back({"--aov", numbered_name(aov.file, i)});
        // Few files of a long sequence exist yet, and a file that does not exist is not an input.
        std::erase_if(files, [](const OutputFile& f) { return !std::filesystem::exists(f.file); });
        refuse_overwriting(files, inputs);
    }
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

void OutputPlan::write(std::size_t i, const FrameResult& frame, const ImageMetadata& metadata) const
{
    const std::filesystem::path picture = numbered_name(picture_, i);
    if (png_)
        write_png(picture, frame.picture, metadata);
    else
        write_image(picture, frame.hdr, metadata);
    for (std::size_t a = 0; a < aovs_.size(); ++a)
        write_image(numbered_name(aovs_[a].file, i), frame.aovs[a], with_aov(metadata, aovs_[a].name));
}

CameraPath find_path(const std::string& name, const SceneFile& file)
{
    if (name.empty()) return {};
    if (const auto found = file.paths.find(name); found != file.paths.end()) return found->second;
    std::vector<std::string> names;
    for (const auto& [path, keys] : file.paths) names.push_back(path);
    throw Error(ExitCode::usage, fmt::format("no camera path is called \"{}\"", name), "--path",
                names.empty() ? "the scene has none" : suggest_name(name, names),
                "paths stand in a scene file as [path.NAME]");
}

} // namespace atrium::app
