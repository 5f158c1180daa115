// ARCHITECTURE.md's worked examples of passes, compiled and drawn with the same text.

#include "tests/examples/outline.hpp"
#include "tests/examples/surface_count.hpp"

#include "renderer/frame_constants.hpp"
#include "tests/rig/frame_rig.hpp"
#include "tests/truth/shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <fstream>
#include <string>
#include <vector>

namespace atrium {
namespace {

/// The result of a pass on a frame, read back: an image of 4 bytes per texel.
template <class Add>
std::vector<std::byte> draw_with(rig::FrameRig& rig, const Add& add)
{
    Engine& engine = rig::engine();
    engine.set_frame_constants(rig.request);
    graph::Graph g(engine.runner(), {rig.request.size, rig.request.size});
    const View view = make_view(describe_view(rig.request, engine.scene().bounds()));
    const LightSet lights = make_light_set(rig.request.lights, 0);
    const FrameContext context{rig.request.settings, engine.scene(), view, lights};
    const graph::Tex image = add(g, make_renderer(RenderPath::deferred)->add_passes(g, context));

    const std::uint64_t bytes = std::uint64_t{4} * rig.request.size.x * rig.request.size.y;
    const gpu::Buffer buffer(engine.device(), "example", bytes, VK_BUFFER_USAGE_TRANSFER_DST_BIT,
                             gpu::MemoryUse::readback);
    const graph::Buf target = g.import("example", buffer);
    g.keep(target, gpu::Access::host_read);
    g.transfer("read back").reads(image).writes(target).record([=](graph::Cmd& cmd) { cmd.copy(image, target); });
    static_cast<void>(engine.runner().run(g));
    buffer.invalidate();
    return {buffer.mapped().begin(), buffer.mapped().end()};
}

TEST(example, outline_draws_dark_lines_between_meshes_and_nowhere_else)
{
    rig::FrameRig rig(truth::box_on_floor());
    rig.set("ambient.intensity", "2");
    rig.look({2, 2, 2}, {0, 0.3f, 0});
    const ImageF mesh = rig.aov("mesh");
    const auto bytes = draw_with(rig, [&](graph::Graph& g, const SceneImages& scene) {
        const graph::Tex picture = add_tonemap(g, scene.hdr, rig.request.settings.tonemap);
        return add_outline(g, scene.aov_inputs.gbuffer, picture, 1.0f);
    });
    Image8 image(320, 180, 4);
    std::memcpy(image.values.data(), bytes.data(), bytes.size());
    int lines = 0;
    for (int y = 2; y < 178; ++y) {
        for (int x = 2; x < 318; ++x) {
            bool inside = true, edge = false;
            for (int dy = -2; dy <= 2; ++dy) {
                for (int dx = -2; dx <= 2; ++dx) inside = inside && *mesh.at(x, y) == *mesh.at(x + dx, y + dy);
            }
            edge = *mesh.at(x, y) != *mesh.at(x + 1, y);
            const bool dark = image.at(x, y)[0] < 20;
            if (inside) {
                ASSERT_FALSE(dark) << x << "," << y;
            }
            if (edge) lines += image.at(x, y)[0] < 20 || image.at(x + 1, y)[0] < 20 ? 1 : 0;
        }
    }
    EXPECT_GT(lines, 40) << "the box's silhouette is outlined";
}

TEST(example, every_pass_that_draws_the_scene_gets_the_same_depths)
{
    rig::FrameRig rig(rig::courtyard_bake());
    rig.look({0, 1.7f, 6}, {0, 1, 0});
    for (const char* culling : {"on", "off"}) {
        for (const char* kind : {"culling.occlusion", "culling.triangles"}) rig.set(kind, culling);
        const ImageF depth = rig.aov("depth");
        const auto bytes = draw_with(rig, [](graph::Graph& g, const SceneImages& scene) {
            const AovInputs& in = scene.aov_inputs;
            return add_surface_count(g, in.gbuffer, in.draws.front(), in.geometry);
        });
        std::vector<float> counts(depth.values.size());
        ASSERT_EQ(bytes.size(), counts.size() * sizeof(float));
        std::memcpy(counts.data(), bytes.data(), bytes.size());
        std::size_t seen = 0;
        for (std::size_t i = 0; i < counts.size(); ++i) {
            if (std::isinf(depth.values[i])) continue;
            ++seen;
            ASSERT_GE(counts[i], 1) << "pixel " << i << ": the pass got a smaller depth than the G-buffer's";
        }
        EXPECT_GT(seen, counts.size() / 2);
    }
}

TEST(example, a_pass_takes_less_than_60_lines)
{
    std::size_t lines = 0;
    for (const char* name : {"outline.hpp", "outline.frag"}) {
        std::ifstream in(std::string(ATRIUM_SOURCE) + "/tests/examples/" + name);
        std::string line;
        while (std::getline(in, line)) ++lines;
    }
    EXPECT_GT(lines, 10u);
    EXPECT_LT(lines + 2, 60u) << "and a line each in frame.cpp and shaders/CMakeLists.txt";
}

} // namespace
} // namespace atrium
