// Upscaling against results that AMD's own text of FSR 1 gives, and against what follows from each filter.

#include "renderer/techniques/upscale/upscale.hpp"

#include "renderer/frame_resources.hpp"
#include "tests/rig/device_rig.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <vector>

namespace atrium {
namespace {

using Color = std::array<int, 3>;

struct Bytes {
    uvec2 size{0};
    std::vector<std::uint8_t> rgba;

    Bytes() = default;
    Bytes(uvec2 s, const std::function<Color(std::uint32_t, std::uint32_t)>& color) : size(s)
    {
        for (std::uint32_t y = 0; y < s.y; ++y) {
            for (std::uint32_t x = 0; x < s.x; ++x) {
                for (const int value : color(x, y)) rgba.push_back(static_cast<std::uint8_t>(value));
                rgba.push_back(255);
            }
        }
    }
    [[nodiscard]] Color at(std::uint32_t x, std::uint32_t y) const
    {
        const std::uint8_t* p = &rgba[4 * (std::size_t{y} * size.x + x)];
        return {p[0], p[1], p[2]};
    }
};

Bytes run(const Bytes& in, const std::function<graph::Tex(graph::Graph&, graph::Tex)>& add)
{
    rig::DeviceRig& d = rig::device();
    Readbacks readbacks(d.device);
    graph::Graph g(d.runner, {});
    const graph::Buf bytes = g.upload("bytes", in.rgba);
    const graph::Tex picture = g.texture("picture", {gpu::Format::rgba8_unorm, in.size.x, in.size.y});
    g.transfer("upload").reads(bytes).writes(picture).record([=](graph::Cmd& cmd) { cmd.copy(bytes, picture); });
    const graph::Tex result = add(g, picture);
    const gpu::Buffer& back = readbacks.add(g, result, "result");
    static_cast<void>(d.runner.run(g));
    Bytes out;
    out.size = g.size(result);
    for (const std::byte b : bytes_in(back)) out.rgba.push_back(static_cast<std::uint8_t>(b));
    return out;
}

Bytes upscale(const Bytes& in, uvec2 size, UpscaleMethod method = UpscaleMethod::fsr1)
{
    return run(in, [=](graph::Graph& g, graph::Tex picture) { return add_upscale(g, picture, size, method); });
}

Bytes sharpen(const Bytes& in, float stops)
{
    return run(in, [=](graph::Graph& g, graph::Tex picture) { return add_sharpening(g, picture, stops); });
}

/// Within 1/255 of values in 0 to 1.
void expect_color(const Color& got, const std::array<double, 3>& wanted, const char* what)
{
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(got[c], 255 * wanted[c], 1.0) << what << ", channel " << c;
}

using Patch = std::array<std::array<int, 8>, 8>; ///< RRGGBB

Bytes picture(const Patch& patch)
{
    return {uvec2(8), [&](std::uint32_t x, std::uint32_t y) {
                const int v = patch[y][x];
                return Color{v >> 16, (v >> 8) & 255, v & 255};
            }};
}

/// A dark area with a steep edge on a light one, grey.
constexpr Patch patch_a{{{0x141414, 0x141414, 0xBCBCBC, 0xE6E6E6, 0xE6E6E6, 0xE6E6E6, 0xE6E6E6, 0xE6E6E6},
                         {0x141414, 0x141414, 0x5D5D5D, 0xE6E6E6, 0xE6E6E6, 0xE6E6E6, 0xE6E6E6, 0xE6E6E6},
                         {0x141414, 0x141414, 0x141414, 0xD1D1D1, 0xE6E6E6, 0xE6E6E6, 0xE6E6E6, 0xE6E6E6},
                         {0x141414, 0x141414, 0x141414, 0x727272, 0xE6E6E6, 0xE6E6E6, 0xE6E6E6, 0xE6E6E6},
                         {0x141414, 0x141414, 0x141414, 0x141414, 0xE6E6E6, 0xE6E6E6, 0xE6E6E6, 0xE6E6E6},
                         {0x141414, 0x141414, 0x141414, 0x141414, 0x878787, 0xE6E6E6, 0xE6E6E6, 0xE6E6E6},
                         {0x141414, 0x141414, 0x141414, 0x141414, 0x292929, 0xE6E6E6, 0xE6E6E6, 0xE6E6E6},
                         {0x141414, 0x141414, 0x141414, 0x141414, 0x141414, 0x9D9D9D, 0xE6E6E6, 0xE6E6E6}}};

/// Colours that have nothing in common.
constexpr Patch patch_b{{{0x0FC9A2, 0x8DCB3E, 0xDD55F7, 0x515B63, 0x53CD2F, 0x17E95F, 0x35CABA, 0xC2BD9A},
                         {0xF821C5, 0x5CACDE, 0x73FA34, 0xB52429, 0x0AE02E, 0x297556, 0x425A55, 0x63A31D},
                         {0x8C2F8C, 0xC15713, 0xF66475, 0x00FF76, 0xBA165F, 0x08B0CF, 0x55340D, 0xCFF044},
                         {0x6FCC6A, 0x71D4AB, 0xB8F9CF, 0x35A4A1, 0x1B15BE, 0x77FB29, 0xA9C404, 0x1B4F71},
                         {0x44125D, 0x783FE2, 0xFDC529, 0x79C8EB, 0x3B7D01, 0x423124, 0x80D19A, 0x26C9A6},
                         {0xE3DCF8, 0x4282C0, 0x9F1DB0, 0x09ECAD, 0x5E6EFF, 0xF388EF, 0x0CC1D1, 0xC837AF},
                         {0x27C1C9, 0x4EE9F5, 0x46C9CC, 0xD5E107, 0x343EC4, 0x51DCE1, 0x9D8D7E, 0xAD0F81},
                         {0x9277DA, 0x734A89, 0x3CDD3E, 0xD736F0, 0xDDCC88, 0x0CA748, 0xA44DCD, 0x1E59F7}}};

/// A thin slanted blue line on light grey.
Bytes patch_c()
{
    constexpr std::array<std::uint32_t, 8> column{1, 1, 2, 2, 3, 4, 4, 5};
    return {uvec2(8), [&](std::uint32_t x, std::uint32_t y) {
                if (x == column[y]) return Color{0x1E, 0x3C, 0xC8};
                return x == column[y] + 1 ? Color{0x96, 0xA5, 0xE1} : Color{0xF0, 0xF0, 0xF0};
            }};
}

TEST(upscale, easu_gives_what_the_original_gives)
{
    const Bytes a12 = upscale(picture(patch_a), uvec2(12)), a16 = upscale(picture(patch_a), uvec2(16));
    const auto grey = [](double v) { return std::array{v, v, v}; };
    expect_color(a12.at(5, 3), grey(0.901961), "a12 5 3");
    expect_color(a12.at(6, 6), grey(0.792109), "a12 6 6");
    expect_color(a12.at(7, 9), grey(0.627439), "a12 7 9");
    expect_color(a16.at(0, 0), grey(0.078431), "a16 0 0");
    expect_color(a16.at(5, 3), grey(0.528569), "a16 5 3");
    expect_color(a16.at(6, 6), grey(0.325166), "a16 6 6");
    expect_color(a16.at(7, 9), grey(0.220993), "a16 7 9");
    const Bytes b13 = upscale(picture(patch_b), uvec2(13)), b16 = upscale(picture(patch_b), uvec2(16));
    expect_color(b13.at(5, 3), {0.195539, 0.791174, 0.372116}, "b13 5 3");
    expect_color(b13.at(6, 6), {0.249546, 0.500283, 0.527934}, "b13 6 6");
    expect_color(b13.at(11, 4), {0.574391, 0.626839, 0.203811}, "b13 11 4");
    expect_color(b16.at(5, 3), {0.593872, 0.766953, 0.227197}, "b16 5 3");
    expect_color(b16.at(7, 9), {0.331854, 0.782939, 0.789059}, "b16 7 9");
    const Bytes c12 = upscale(patch_c(), uvec2(12)), c13 = upscale(patch_c(), uvec2(13, 11)); // two ratios
    expect_color(c12.at(5, 3), {0.760865, 0.791979, 0.912187}, "c12 5 3");
    expect_color(c12.at(7, 9), {0.314178, 0.408742, 0.826740}, "c12 7 9");
    expect_color(c13.at(6, 6), {0.241526, 0.344813, 0.811246}, "c13 6 6");
    expect_color(c13.at(7, 9), {0.369152, 0.450572, 0.831921}, "c13 7 9");
}

/// The middle of a cross of five pixels, after sharpening.
Color sharpened(const Color& up, const Color& left, const Color& middle, const Color& right, const Color& down,
                float stops)
{
    const Bytes in(uvec2(3), [&](std::uint32_t x, std::uint32_t y) {
        if (x == 1) return y == 0 ? up : y == 1 ? middle : down;
        return x == 0 ? left : right;
    });
    return sharpen(in, stops).at(1, 1);
}

TEST(upscale, rcas_gives_what_the_original_gives)
{
    const auto grey = [](int v) { return Color{v, v, v}; };
    for (const auto& [stops, wanted] : {std::pair{0.0f, 0.952134}, {0.2f, 0.861084}, {1.0f, 0.717230}})
        expect_color(sharpened(grey(100), grey(100), grey(160), grey(110), grey(120), stops), {wanted, wanted, wanted},
                     "grey ridge");
    const auto edge = [](float stops) {
        return sharpened({200, 40, 30}, {190, 60, 35}, {180, 90, 60}, {40, 160, 90}, {60, 120, 80}, stops);
    };
    expect_color(edge(0), {0.761562, 0.347723, 0.236305}, "colour edge");
    expect_color(edge(1), {0.730612, 0.350607, 0.235734}, "colour edge, one stop");
    expect_color(sharpened(grey(0), grey(0), grey(128), grey(0), grey(0), 0), {0.997039, 0.997039, 0.997039}, "dot");
    expect_color(sharpened(grey(255), grey(255), grey(90), grey(255), grey(255), 0.2f), {0.065843, 0.065843, 0.065843},
                 "hole");
    expect_color(sharpened({255, 0, 0}, {200, 10, 5}, {128, 20, 40}, {60, 30, 60}, {90, 25, 50}, 0),
                 {0.500378, 0.078184, 0.156368}, "red beside dark");
}

TEST(upscale, flat_pictures_stay_flat)
{
    for (const int value : {0, 1, 77, 128, 254, 255}) {
        for (const uvec2 size : {uvec2(1), uvec2(2, 1), uvec2(3), uvec2(9, 7)}) {
            const Bytes flat(size, [&](std::uint32_t, std::uint32_t) { return Color{value, value, value}; });
            for (const UpscaleMethod method :
                 {UpscaleMethod::bilinear, UpscaleMethod::catmullrom, UpscaleMethod::lanczos, UpscaleMethod::fsr1}) {
                const Bytes large = upscale(flat, size * 2u, method);
                EXPECT_EQ(std::count(large.rgba.begin(), large.rgba.end(), value),
                          value == 255 ? std::ptrdiff_t(large.rgba.size()) : std::ptrdiff_t(large.rgba.size() / 4 * 3))
                    << value << " " << size.x;
            }
            const Color sharp = sharpen(flat, 0.2f).at(0, 0); // its approximate division errs by 0.32 % at most
            for (const int channel : sharp) EXPECT_NEAR(channel, value, 1) << value << " " << size.x;
        }
    }
}

TEST(upscale, bilinear_mixes_by_distance)
{
    const Bytes edge(uvec2(4, 1), [](std::uint32_t x, std::uint32_t) { return x < 2 ? Color{} : Color{200, 100, 40}; });
    const Bytes large = upscale(edge, uvec2(8, 2), UpscaleMethod::bilinear);
    EXPECT_EQ(large.at(2, 0), (Color{0, 0, 0}));
    EXPECT_EQ(large.at(3, 0), (Color{50, 25, 10}));
    EXPECT_EQ(large.at(4, 1), (Color{150, 75, 30}));
    EXPECT_EQ(large.at(5, 1), (Color{200, 100, 40}));
}

TEST(upscale, cubic_and_lanczos_filters_overshoot_where_bilinear_does_not)
{
    const Bytes edge(uvec2(12, 1), [](std::uint32_t x, std::uint32_t) {
        return x < 6 ? Color{60, 60, 60} : Color{200, 200, 200};
    });
    for (const UpscaleMethod method : {UpscaleMethod::catmullrom, UpscaleMethod::lanczos}) {
        const Bytes large = upscale(edge, uvec2(24, 1), method);
        EXPECT_LT(large.at(10, 0)[0], 60);
        EXPECT_GT(large.at(13, 0)[0], 200);
    }
    EXPECT_EQ(upscale(edge, uvec2(24, 1), UpscaleMethod::bilinear).at(10, 0)[0], 60);
    EXPECT_EQ(upscale(edge, uvec2(24, 1), UpscaleMethod::fsr1).at(10, 0)[0], 60); // EASU takes ringing away
}

TEST(upscale, without_another_size_nothing_is_added)
{
    graph::Graph g;
    const graph::Tex picture = g.texture("picture", {gpu::Format::rgba8_unorm, 8, 8});
    EXPECT_EQ(add_upscale(g, picture, uvec2(8), UpscaleMethod::fsr1).index, picture.index);
    EXPECT_EQ(add_upscale(g, picture, uvec2(16), UpscaleMethod::off).index, picture.index);
    EXPECT_EQ(g.pass_count(), 0u);
}

} // namespace
} // namespace atrium
