// `atrium compare`: how far a picture differs from its reference, in four numbers; or all pictures of two folders.

#include "app/commands.hpp"
#include "app/json_output.hpp"
#include "renderer/core/error.hpp"
#include "renderer/core/log.hpp"
#include "renderer/core/output_guard.hpp"
#include "renderer/metrics/flip.hpp"
#include "renderer/metrics/image_error.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace atrium::app {
namespace {

namespace fs = std::filesystem;

struct Options {
    fs::path reference, test;
    std::string metric = "all", json;
    fs::path diff;
    std::optional<double> fail_above, fail_below;
};

/// Three colour channels: encoded values in 0 to 1 of a PNG, or linear light of an EXR.
struct Picture {
    ImageF colors;
    bool hdr = false;
};

/// Three channels of an image of any number: alpha is left out, grey is repeated, a missing third is 0.
ImageF to_colors(const ImageF& image)
{
    ImageF out(image.width, image.height, 3);
    const auto channels = static_cast<std::size_t>(image.channels);
    for (std::size_t i = 0; i < out.values.size() / 3; ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
            if (channels >= 3 || (channels == 2 && c < 2))
                out.values[3 * i + c] = image.values[channels * i + c];
            else if (channels == 1)
                out.values[3 * i + c] = image.values[i];
        }
    }
    return out;
}

enum class Kind { png, exr, other };

Kind kind_of(const fs::path& file)
{
    std::string extension = file.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return std::tolower(c); });
    return extension == ".png" ? Kind::png : extension == ".exr" ? Kind::exr : Kind::other;
}

Picture read_picture(const fs::path& file)
{
    const Kind kind = kind_of(file);
    if (kind == Kind::png) return {to_colors(read_png_values(file)), false};
    if (kind == Kind::exr) return {to_colors(read_exr(file)), true};
    throw Error(ExitCode::input, fmt::format("cannot compare \"{}\"", file.string()), file.string(),
                "its name ends neither in .png nor in .exr",
                "give two PNG or two EXR pictures, or two folders of them");
}

/// Sets NaN and infinite values to 0. How many there were.
std::size_t replace_not_finite(ImageF& image)
{
    std::size_t count = 0;
    for (float& value : image.values) {
        if (std::isfinite(value)) continue;
        value = 0;
        ++count;
    }
    return count;
}

struct Errors {
    std::string name;
    double mse = 0, flip = 0;
    std::optional<double> psnr, ssim; ///< nothing: infinite; not defined
    std::size_t not_finite = 0;       ///< values that were replaced by 0
};

ImageF linear(const ImageF& encoded)
{
    ImageF out = encoded;
    for (float& value : out.values) value = static_cast<float>(linear_from_srgb(value));
    return out;
}

Errors compare(const fs::path& reference_file, const fs::path& test_file, const fs::path& diff)
{
    Picture reference = read_picture(reference_file), test = read_picture(test_file);
    const auto refuse = [&](const std::string& why, const std::string& next) {
        throw Error(ExitCode::input, "the pictures cannot be compared",
                    fmt::format("{} and {}", reference_file.string(), test_file.string()), why, next);
    };
    if (reference.hdr != test.hdr) refuse("one is a PNG and one an EXR", "give two of one kind");
    const ImageF &a = reference.colors, &b = test.colors;
    if (a.width != b.width || a.height != b.height)
        refuse(fmt::format("one has {} x {} pixels and one {} x {}", a.width, a.height, b.width, b.height),
               "give two of one size");

    Errors errors;
    errors.name = test_file.filename().string();
    errors.not_finite = replace_not_finite(reference.colors) + replace_not_finite(test.colors);
    if (errors.not_finite > 0)
        log_warning(fmt::format("{}: {} values that are not finite count as 0", test_file.string(), errors.not_finite));
    errors.mse = mean_squared_error(a, b);
    errors.psnr = peak_signal_to_noise(errors.mse, reference.hdr ? peak_of(a) : 1);
    if (!reference.hdr) errors.ssim = structural_similarity(a, b);
    const ImageF map = reference.hdr ? flip_map_hdr(a, b, flip_exposures(a)) : flip_map(linear(a), linear(b));
    errors.flip = mean_of(map);
    if (!diff.empty()) write_png(diff, heat_map(map));
    return errors;
}

/// Files of both folders with the same name, by name.
std::vector<fs::path> common_names(const fs::path& reference, const fs::path& test)
{
    std::vector<fs::path> names;
    std::size_t alone = 0;
    for (const fs::directory_entry& entry : fs::directory_iterator(reference)) {
        if (kind_of(entry.path()) == Kind::other) continue;
        if (fs::exists(test / entry.path().filename()))
            names.push_back(entry.path().filename());
        else
            ++alone;
    }
    std::sort(names.begin(), names.end());
    if (alone > 0)
        log_warning(fmt::format("{} pictures of {} have no partner in {}", alone, reference.string(), test.string()));
    if (names.empty())
        throw Error(ExitCode::input, "there is nothing to compare",
                    fmt::format("{} and {}", reference.string(), test.string()),
                    "no PNG or EXR has the same name in both", "name the pictures of a pair alike");
    return names;
}

/// Means over all pairs; of PSNR and SSIM, over those that have one.
Errors mean_of(const std::vector<Errors>& all)
{
    Errors mean;
    mean.name = "mean";
    const auto mean_value = [&](const std::optional<double> Errors::*member) {
        std::optional<double> total;
        int count = 0;
        for (const Errors& e : all) {
            if (!(e.*member)) continue;
            total = total.value_or(0) + *(e.*member);
            ++count;
        }
        return total ? std::optional(*total / count) : std::nullopt;
    };
    for (const Errors& e : all) {
        mean.mse += e.mse / static_cast<double>(all.size());
        mean.flip += e.flip / static_cast<double>(all.size());
        mean.not_finite += e.not_finite;
    }
    mean.psnr = mean_value(&Errors::psnr);
    mean.ssim = mean_value(&Errors::ssim);
    return mean;
}

nlohmann::ordered_json to_json(const Errors& e)
{
    const auto number = [](const std::optional<double>& value) {
        return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json();
    };
    nlohmann::ordered_json out{{"mse", e.mse}, {"psnr", number(e.psnr)}, {"ssim", number(e.ssim)}, {"flip", e.flip}};
    if (e.not_finite > 0) out["not_finite"] = e.not_finite;
    return out;
}

void print_table(const std::vector<Errors>& rows, const std::string& metric)
{
    std::size_t width = 4;
    for (const Errors& e : rows) width = std::max(width, e.name.size());
    const auto shown = [&](const char* name) { return metric == "all" || metric == name; };
    const auto column = [&](const char* name, const std::string& text) {
        if (shown(name)) fmt::print("  {:>10}", text);
    };
    const auto number = [](const std::optional<double>& value, const char* absent) {
        return value ? fmt::format("{:.4f}", *value) : absent;
    };
    fmt::print("{:<{}}", "", width);
    for (const char* name : {"mse", "psnr", "ssim", "flip"})
        column(name, name == std::string_view("psnr") ? "psnr dB" : name);
    for (const Errors& e : rows) {
        fmt::print("\n{:<{}}", e.name, width);
        column("mse", fmt::format("{:.6g}", e.mse));
        column("psnr", number(e.psnr, "infinite"));
        column("ssim", number(e.ssim, "-"));
        column("flip", fmt::format("{:.6f}", e.flip));
    }
    fmt::print("\n");
}

/// Whether the chosen metric of a pair lies outside what was asked for.
bool fails(const Errors& e, const Options& o)
{
    double value = e.flip;
    if (o.metric == "mse") value = e.mse;
    if (o.metric == "psnr") value = e.psnr.value_or(std::numeric_limits<double>::infinity());
    if (o.metric == "ssim") {
        if (!e.ssim)
            throw Error(ExitCode::input, fmt::format("\"{}\" has no SSIM", e.name), "--metric ssim",
                        "it is not defined for EXR and for pictures smaller than 11 x 11", "choose another metric");
        value = *e.ssim;
    }
    return (o.fail_above && value > *o.fail_above) || (o.fail_below && value < *o.fail_below);
}

int run(const Options& o)
{
    if (o.fail_below && o.metric != "psnr" && o.metric != "ssim")
        throw Error(ExitCode::usage, "--fail-below needs a metric that is better when it is larger", "--fail-below",
                    fmt::format("--metric is {}", o.metric), "add --metric psnr or --metric ssim, or use --fail-above");
    const std::array inputs{o.reference, o.test};
    refuse_overwriting(std::array{OutputFile{"--diff", o.diff}, OutputFile{"--json", o.json}}, inputs);
    const bool folders = fs::is_directory(o.reference) && fs::is_directory(o.test);
    if (folders && !o.diff.empty())
        throw Error(ExitCode::usage, "--diff is for one pair of pictures", "--diff", "two folders were given",
                    "compare the pair that you want to look at");

    std::vector<Errors> pairs;
    if (folders) {
        for (const fs::path& name : common_names(o.reference, o.test))
            pairs.push_back(compare(o.reference / name, o.test / name, {}));
    } else {
        pairs.push_back(compare(o.reference, o.test, o.diff));
    }
    std::vector<Errors> rows = pairs;
    if (folders) rows.push_back(mean_of(pairs));

    if (o.json != "-") print_table(rows, o.metric);
    if (!o.json.empty()) {
        nlohmann::ordered_json json = to_json(rows.back());
        if (folders) {
            for (const Errors& e : pairs) {
                nlohmann::ordered_json pair{{"name", e.name}};
                pair.update(to_json(e));
                json["pairs"].push_back(pair);
            }
        }
        write_json_text(o.json, json.dump(2) + "\n");
    }
    const bool failed = std::any_of(pairs.begin(), pairs.end(), [&](const Errors& e) { return fails(e, o); });
    return static_cast<int>(failed ? ExitCode::check_failed : ExitCode::done);
}

} // namespace

Run add_compare_command(CLI::App& app)
{
    const auto o = std::make_shared<Options>();
    CLI::App* command = app.add_subcommand("compare", "measure how far a picture differs from its reference");
    command->add_option("REF", o->reference, "the reference: a PNG, an EXR, or a folder of them")->required();
    command->add_option("TEST", o->test, "the picture under test, of the same kind and size; or a folder")->required();
    command->add_option("--metric", o->metric, "which to print and test; all: print all, test FLIP")
        ->check(CLI::IsMember({"all", "mse", "psnr", "ssim", "flip"}));
    command->add_option("--json", o->json, "all metrics as JSON to a file, or - for the terminal");
    command->add_option("--diff", o->diff, "a picture of the FLIP error, dark to bright (PNG)");
    CLI::Option* above = command->add_option("--fail-above", o->fail_above, "exit with 1 if the metric is larger");
    command->add_option("--fail-below", o->fail_below, "exit with 1 if the metric is smaller (psnr, ssim)")
        ->excludes(above);
    command->footer("Example:\n  atrium compare truth.png fast.png --diff error.png --fail-above 0.05");
    return [o] { return run(*o); };
}

} // namespace atrium::app
