// Pipelines with each kind of stage, topology and blending, drawn and compared with known answers.

#include "renderer/core/error.hpp"
#include "renderer/core/math.hpp"
#include "renderer/gpu/shader_interface.hpp"
#include "tests/rig/device_rig.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>
#include <vector>

namespace atrium::gpu {
namespace {

constexpr std::uint32_t side = 64; // pixels, of every target

struct Target {
    Format format = Format::r32_float;
    std::uint32_t bytes = 4; // of a texel
    vec4 clear{0};
    std::uint32_t samples = 1; ///< of several, their mean is read
};

/// The contents of the targets after drawing three vertices `times` times, rows from the top.
std::vector<std::vector<std::byte>> draw(const GraphicsPipelineDesc& desc, const std::vector<Target>& targets,
                                         graph::CullMode cull = graph::CullMode::none, int times = 1)
{
    rig::DeviceRig& d = rig::device();
    std::vector<Buffer> back;
    back.reserve(targets.size());
    graph::Graph g;
    std::vector<graph::Tex> images;
    graph::PassBuilder pass = g.raster("stages");
    for (const Target& target : targets) {
        graph::TexDesc image{.format = target.format, .width = side, .height = side};
        images.push_back(g.texture("target", image));
        image.samples = target.samples;
        if (target.samples == 1) {
            pass.writes(images.back(), graph::Load::clear, target.clear);
        } else {
            pass.writes(g.texture("samples", image), graph::Load::clear, target.clear).resolves(images.back());
        }
    }
    pass.pipeline(desc).record([=](graph::Cmd& cmd) {
        cmd.bind();
        cmd.cull(cull);
        for (int i = 0; i < times; ++i) cmd.draw_fullscreen(); // three vertices
    });
    for (std::size_t i = 0; i < targets.size(); ++i) {
        back.emplace_back(d.device, "back", targets[i].bytes * side * side, VK_BUFFER_USAGE_TRANSFER_DST_BIT,
                          MemoryUse::readback);
        const graph::Buf to = g.import("back", back.back());
        g.keep(to, Access::host_read);
        g.transfer("copy").reads(images[i]).writes(to).record(
            [=, from = images[i]](graph::Cmd& cmd) { cmd.copy(from, to); });
    }
    d.runner.run(g);
    std::vector<std::vector<std::byte>> out;
    for (const Buffer& buffer : back) {
        buffer.invalidate();
        out.emplace_back(buffer.mapped().begin(), buffer.mapped().end());
    }
    return out;
}

template <class T>
T at(const std::vector<std::byte>& texels, std::uint32_t x, std::uint32_t y)
{
    T value;
    std::memcpy(&value, texels.data() + (y * side + x) * sizeof(T), sizeof(T));
    return value;
}

/// Centre of a pixel in clip space, y up.
vec2 centre(std::uint32_t x, std::uint32_t y)
{
    return vec2(2.0f, -2.0f) * (vec2(static_cast<float>(x), static_cast<float>(y)) + 0.5f) / static_cast<float>(side) +
           vec2(-1, 1);
}

GraphicsPipelineDesc patch(std::uint32_t factor)
{
    GraphicsPipelineDesc desc;
    desc.vertex = "gpu/stages_patch.vert";
    desc.tessellation_control = "gpu/stages_patch.tesc";
    desc.tessellation_evaluation = "gpu/stages_patch.tese";
    desc.fragment = "gpu/stages_flat.frag";
    desc.topology = Topology::patches;
    desc.patch_points = 3;
    desc.constants = {factor};
    return desc;
}

/// How far a point lies inside the polygon that the patch becomes; negative outside.
float depth_inside(const vec2& p, std::uint32_t factor)
{
    std::vector<vec2> corners;
    for (std::uint32_t i = 0; i < 3 * factor; ++i) {
        const auto corner = [](std::uint32_t k) {
            const float angle = std::numbers::pi_v<float> * (0.5f + 2.0f / 3.0f * static_cast<float>(k));
            return vec2(std::cos(angle), std::sin(angle));
        };
        const float t = static_cast<float>(i % factor) / static_cast<float>(factor);
        corners.push_back(glm::normalize(glm::mix(corner(i / factor), corner(i / factor + 1), t)));
    }
    float least = 2;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const vec2 along = glm::normalize(corners[(i + 1) % corners.size()] - corners[i]);
        least = std::min(least, glm::dot(p - corners[i], vec2(-along.y, along.x)));
    }
    return least;
}

TEST(stages, a_tessellated_patch_fills_its_polygon_and_faces_as_the_patch_does)
{
    if (!rig::device().device.report().optional.tessellation) GTEST_SKIP() << "no tessellationShader";
    for (const std::uint32_t factor : {1u, 2u, 5u, 16u}) {
        const auto drawn = draw(patch(factor), {{}}, graph::CullMode::back).front();
        int near_edges = 0;
        for (std::uint32_t y = 0; y < side; ++y) {
            for (std::uint32_t x = 0; x < side; ++x) {
                const float inside = depth_inside(centre(x, y), factor);
                if (std::abs(inside) < 1e-3f) { // 1/32 of a pixel: within the rasteriser's rounding
                    ++near_edges;
                    continue;
                }
                EXPECT_EQ(at<float>(drawn, x, y), inside > 0 ? 1.0f : 0.0f) << factor << ": " << x << ", " << y;
            }
        }
        EXPECT_LT(near_edges, 64);
    }
}

TEST(stages, four_samples_cover_as_much_as_the_polygon_does)
{
    if ((rig::device().device.report().sample_counts & 4) == 0) GTEST_SKIP() << "no targets of 4 samples";
    if (!rig::device().device.report().optional.tessellation) GTEST_SKIP() << "no tessellationShader";
    constexpr float pixel = 2.0f / side;
    const auto drawn = draw(patch(4), {{.samples = 4}}, graph::CullMode::back).front();
    float sum = 0;
    int partly = 0;
    for (std::uint32_t y = 0; y < side; ++y) {
        for (std::uint32_t x = 0; x < side; ++x) {
            const float value = at<float>(drawn, x, y), inside = depth_inside(centre(x, y), 4);
            EXPECT_EQ(std::fmod(4 * value, 1.0f), 0) << x << ", " << y;
            if (std::abs(inside) > 0.75f * pixel) { // half a diagonal, and some
                EXPECT_EQ(value, inside > 0 ? 1.0f : 0.0f) << x << ", " << y;
            }
            partly += value > 0 && value < 1 ? 1 : 0;
            sum += value;
        }
    }
    // A fan of twelve triangles. An edge of the patch passes the centre at 1/2; its corners, a quarter of it apart, lie
    // at 0 and sqrt(3)/4 along it from its middle.
    const float inner = std::atan(std::sqrt(3.0f) / 2), outer = std::numbers::pi_v<float> / 3 - inner;
    const float area = 3 * (std::sin(inner) + std::sin(outer));
    EXPECT_NEAR(sum * pixel * pixel, area, 0.01f); // of 2.946; a sample more in each pixel of the edge: .05
    EXPECT_GT(partly, 100);
}

TEST(stages, a_geometry_shader_makes_squares_of_points)
{
    if (!rig::device().device.report().optional.geometry) GTEST_SKIP() << "no geometryShader";
    GraphicsPipelineDesc desc;
    desc.vertex = "gpu/stages_points.vert";
    desc.geometry = "gpu/stages_points.geom";
    desc.fragment = "gpu/stages_flat.frag";
    desc.topology = Topology::points;
    const auto drawn = draw(desc, {{}}).front();
    for (std::uint32_t y = 0; y < side; ++y) {
        for (std::uint32_t x = 0; x < side; ++x) {
            const vec2 p = centre(x, y);
            const float off = std::min({std::abs(p.x + 0.5f), std::abs(p.x), std::abs(p.x - 0.5f)});
            const bool inside = off < 0.125f && std::abs(p.y) < 0.125f;
            EXPECT_EQ(at<float>(drawn, x, y), inside ? 1.0f : 0.0f) << x << ", " << y;
        }
    }
}

TEST(stages, targets_of_one_pass_are_blended_each_in_its_way)
{
    const vec4 source(1, 0.5f, 0.25f, 0.5f), before(0.25f, 0.5f, 1, 0.25f);
    GraphicsPipelineDesc desc;
    desc.vertex = "lib/fullscreen.vert";
    desc.fragment = "gpu/stages_two_targets.frag";
    const Target target{Format::rgba32_float, 16, before};
    const auto expect_both = [&](const vec4& first, const vec4& second) {
        const auto drawn = draw(desc, {target, target}, graph::CullMode::none, 2);
        EXPECT_EQ(at<vec4>(drawn[0], 17, 5), first);
        EXPECT_EQ(at<vec4>(drawn[1], 17, 5), second);
    };
    const vec4 added = before + 2.0f * source;
    const vec3 once = 0.5f * vec3(source) + 0.5f * vec3(before), twice = 0.5f * vec3(source) + 0.5f * once;
    const vec4 mixed(twice, before.w + 2 * source.w); // alpha adds up
    expect_both(source, source);
    desc.blends = {Blend::add, Blend::alpha};
    expect_both(added, mixed);
    desc.blends = {Blend::alpha, Blend::off};
    expect_both(mixed, source);
    desc.blends.clear();
    desc.blend = Blend::add;
    expect_both(added, added);
}

TEST(stages, what_contradicts_itself_or_the_device_is_refused)
{
    Pipelines& pipelines = rig::device().pipelines;
    const auto get = [&](const GraphicsPipelineDesc& desc) { static_cast<void>(pipelines.get(desc)); };
    GraphicsPipelineDesc flat;
    flat.vertex = "lib/fullscreen.vert";
    flat.fragment = "gpu/stages_flat.frag";
    flat.colors = {Format::r32_float};
    GraphicsPipelineDesc bad = flat;
    bad.topology = Topology::patches;
    EXPECT_THROW(get(bad), std::logic_error);
    bad = flat;
    bad.tessellation_control = "gpu/stages_patch.tesc";
    EXPECT_THROW(get(bad), std::logic_error);
    bad = flat;
    bad.blends = {Blend::add, Blend::add};
    EXPECT_THROW(get(bad), std::logic_error);
    bad = flat;
    bad.samples = 128;
    EXPECT_THROW(get(bad), Error);
}

TEST(stages, shaders_of_every_stage_can_be_replaced)
{
    if (!rig::device().device.report().optional.tessellation) GTEST_SKIP() << "no tessellationShader";
    Pipelines& pipelines = rig::device().pipelines;
    GraphicsPipelineDesc desc = patch(3);
    desc.colors = {Format::r32_float};
    for (const std::string& shader : desc.shaders()) {
        EXPECT_EQ(
            interface_conflict(find_interface(rig::find_shader(shader)), find_interface(rig::find_shader(shader))),
            std::nullopt);
        const VkPipeline before = pipelines.get(desc);
        pipelines.replace(shader, rig::find_shader(shader));
        EXPECT_NE(pipelines.get(desc), before) << shader; // the pipeline was made again
    }
}

} // namespace
} // namespace atrium::gpu
