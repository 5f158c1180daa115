// truth_aov: the AOVs that a camera ought to see in a bake, by ray casting; and how far the renderer's agree with them.
//
//   truth_aov SCENE.atrium --eye X,Y,Z --target X,Y,Z --fov F --size WxH [--out PREFIX] [--compare DIR]
//             [--light SPEC --samples N [--visibility FILE.exr]…]
//
// --out writes PREFIX-{depth,geometric_normal,material}.exr. --compare reads DIR/{depth,geometric_normal,material}.exr
// as `atrium render --aov` wrote them and prints how they agree off silhouettes, masked surfaces (and what is seen
// through their holes) apart; render with `--set debug.alpha_lod0=on` for those. Exit code 1: a share is not reached.
//
// --light reckons the light's visibility too, of N points of it (1: a point light), and tells how far each
// --visibility, as `atrium render --aov visibility.L=FILE.exr` wrote it, is off. --out writes PREFIX-visibility.exr and
// PREFIX-compared.exr (1 where pixels are compared), and --known-visibility reads one again instead of reckoning it.

#include "renderer/core/error.hpp"
#include "tests/truth/compare.hpp"
#include "tests/truth/primary.hpp"
#include "tests/truth/shadow_truth.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

namespace {

using namespace atrium;

struct Options {
    std::filesystem::path bake;
    std::vector<float> eye{0, 1.7f, 5}, target{0, 1.7f, 0};
    float fov = 60, near = -1;
    std::string size = "1280x720", out, compare, light, known_visibility;
    int samples = 1;
    std::vector<std::string> visibility;
};

/// A share below which a comparison is not met, of opaque and of masked pixels.
struct Wanted {
    double opaque, masked;
};

ivec2 parse_size(const std::string& text)
{
    ivec2 size(0);
    char rest = 0;
    const int read = std::sscanf(text.c_str(), "%dx%d%c", &size.x, &size.y, &rest);
    if (read == 2 && size.x >= 1 && size.y >= 1 && size.x <= 16384 && size.y <= 16384) return size;
    throw Error(ExitCode::usage, "bad size: " + text, "--size", "it is WxH, each 1 to 16384", "say --size 1280x720");
}

/// Prints one line and keeps pictures of a failure; whether the share is reached. Nothing to compare is no failure.
bool print(const std::string& name, const truth::Agreement& a, double wanted)
{
    if (a.compared == 0) {
        fmt::print("{:<26} none (nothing to compare)\n", name);
        return true;
    }
    const bool met = a.share_within >= wanted;
    fmt::print("{:<26} {:<4} (wanted {:.1f} %)  {}\n", name, met ? "met" : "MISS", 100 * wanted, a.text());
    if (!met) fmt::print("  {}\n", truth::write_failure(name, a));
    return met;
}

bool compare(const truth::PrimaryBuffers& truth, const std::filesystem::path& folder)
{
    const truth::Mask off_edges = truth::inverse(truth::silhouettes(truth));
    const truth::Mask opaque = truth::without(off_edges, truth.alpha), masked = truth::both(off_edges, truth.alpha);
    fmt::print("surfaces {:.2f} %, silhouettes {:.2f} %, alpha-tested off silhouettes {:.2f} % of the picture\n",
               100 * truth.surface.share(), 100 - 100 * off_edges.share(), 100 * masked.share());
    const ImageF depth = read_exr(folder / "depth.exr"), normal = read_exr(folder / "geometric_normal.exr");
    const ImageF material = read_exr(folder / "material.exr");
    bool met = true;
    const auto judge = [&](const std::string& name, Wanted wanted, auto agreement_on) {
        met = print(name + "-opaque", agreement_on(opaque), wanted.opaque) && met;
        met = print(name + "-masked", agreement_on(masked), wanted.masked) && met;
    };
    judge("depth", {0.995, 0.97},
          [&](const truth::Mask& m) { return truth::compare_depth(truth.depth, depth, m, 0.002); });
    judge("geometric_normal", {0.99, 0.97},
          [&](const truth::Mask& m) { return truth::compare_directions(truth.geometric_normal, normal, m, 1); });
    judge("material", {0.995, 0.97},
          [&](const truth::Mask& m) { return truth::compare_indices(truth.material, material, m); });
    return met;
}

void compare_light(const Options& o, const truth::TruthScene& scene, const truth::PrimaryBuffers& primary)
{
    const Light light = parse_light(o.light);
    const ImageF truth = o.known_visibility.empty() ? truth::cast_visibility(scene, primary, light, o.samples)
                                                    : read_exr(o.known_visibility);
    const truth::Mask mask = truth::lit_pixels(primary, light);
    if (!o.out.empty()) {
        ImageF compared(mask.width, mask.height, 1);
        std::copy(mask.values.begin(), mask.values.end(), compared.values.begin());
        write_exr(o.out + "-visibility.exr", truth);
        write_exr(o.out + "-compared.exr", compared);
    }
    for (const std::string& file : o.visibility) {
        const truth::VisibilityError e = truth::compare_visibility(truth, read_exr(file), mask);
        fmt::print(
            "{}: wrong {:.2f} %, RMSE {:.4f}; penumbra ({:.1f} %) RMSE {:.4f}, bias {:+.4f}; compared {:.1f} %\n", file,
            100 * e.wrong, e.rmse, 100 * e.penumbra_share, e.penumbra_rmse, e.penumbra_bias, 100 * e.share);
    }
}

int run(const Options& o)
{
    const ivec2 size = parse_size(o.size);
    const BakeFile bake(o.bake);
    const truth::TruthScene scene(bake);
    Camera camera;
    camera.eye = {o.eye[0], o.eye[1], o.eye[2]};
    camera.target = {o.target[0], o.target[1], o.target[2]};
    camera.fov = o.fov;
    const float near = o.near >= 0 ? o.near : default_near(bake.scene().bounds);
    const truth::PrimaryBuffers truth = truth::cast_primary(scene, camera, size, static_cast<double>(near));
    if (!o.out.empty()) {
        write_exr(o.out + "-depth.exr", truth.depth);
        write_exr(o.out + "-geometric_normal.exr", truth.geometric_normal);
        write_exr(o.out + "-material.exr", truth.material);
    }
    if (!o.light.empty()) compare_light(o, scene, truth);
    if (o.compare.empty()) return 0;
    return compare(truth, o.compare) ? 0 : static_cast<int>(ExitCode::check_failed);
}

} // namespace

int main(int argc, char** argv)
{
    Options o;
    CLI::App app("The AOVs that a camera ought to see in a bake, and how far the renderer's agree.", "truth_aov");
    app.add_option("scene", o.bake, "SCENE.atrium")->required();
    app.add_option("--eye", o.eye, "X,Y,Z, m")->delimiter(',')->expected(3);
    app.add_option("--target", o.target, "X,Y,Z, m")->delimiter(',')->expected(3);
    app.add_option("--fov", o.fov, "vertical, degrees")->check(CLI::Range(1.0, 179.0));
    app.add_option("--near", o.near, "near plane, m; by default what the renderer chooses for the scene");
    app.add_option("--size", o.size, "WxH");
    app.add_option("--out", o.out, "write PREFIX-{depth,geometric_normal,material}.exr");
    app.add_option("--light", o.light, "a light, as atrium takes it");
    app.add_option("--samples", o.samples, "points of the light; 1: its centre");
    app.add_option("--visibility", o.visibility, "the renderer's visibility.L of it, one or several files");
    app.add_option("--known-visibility", o.known_visibility, "PREFIX-visibility.exr of a run before");
    app.add_option("--compare", o.compare, "folder of the renderer's {depth,geometric_normal,material}.exr");
    try {
        app.parse(argc, argv);
        return run(o);
    } catch (const CLI::ParseError& e) {
        return app.exit(e) == 0 ? 0 : static_cast<int>(ExitCode::usage);
    } catch (const Error& e) {
        fmt::print(stderr, "truth_aov: {}\n", e.text());
        return static_cast<int>(e.code());
    } catch (const std::exception& e) {
        fmt::print(stderr, "truth_aov: {}\n", e.what());
        return static_cast<int>(ExitCode::internal);
    }
}
