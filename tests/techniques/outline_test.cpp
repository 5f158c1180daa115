// ARCHITECTURE.md's worked example of a pass, compiled and drawn as it stands there.

#include "tests/examples/outline.hpp"

#include "renderer/frame_constants.hpp"
#include "tests/rig/frame_rig.hpp"
#include "tests/truth/shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <string>

namespace atrium {
namespace {

/// The frame with the example's pass behind it, read back.
Image8 draw_outlined(rig::FrameRig& rig)
{
    Engine& engine = rig::engine();
    engine.set_frame_constants(rig.request);
    graph::Graph g;
    const View view = make_view(describe_view(rig.request, engine.scene().bounds()));
    const LightSet lights = make_light_set(rig.request.lights, 0);
    const FrameContext context{rig.request.settings, engine.scene(), view, lights};
    const SceneImages scene = make_renderer(RenderPath::deferred)->add_passes(g, context);
    const graph::Tex picture = add_tonemap(g, scene.hdr, rig.request.settings.tonemap);
    const graph::Tex outlined = add_outline(g, scene.aov_inputs.gbuffer, picture, 1.0f);

    const std::uint64_t bytes = std::uint64_t{4} * rig.request.size.x * rig.request.size.y;
    const gpu::Buffer buffer(engine.device(), "outlined", bytes, VK_BUFFER_USAGE_TRANSFER_DST_BIT,
                             gpu::MemoryUse::readback);
    const graph::Buf target = g.import("outlined", buffer);
    g.keep(target, gpu::Access::host_read);
    g.transfer("read back").reads(outlined).writes(target).record([=](graph::Cmd& cmd) { cmd.copy(outlined, target); });
    static_cast<void>(engine.runner().run(g));
    buffer.invalidate();
    Image8 image(static_cast<int>(rig.request.size.x), static_cast<int>(rig.request.size.y), 4);
    std::memcpy(image.values.data(), buffer.mapped().data(), bytes);
    return image;
}

TEST(example, outline_draws_dark_lines_between_meshes_and_nowhere_else)
{
    rig::FrameRig rig(truth::box_on_floor());
    rig.set("ambient.intensity", "2");
    rig.look({2, 2, 2}, {0, 0.3f, 0});
    const ImageF mesh = rig.aov("mesh");
    const Image8 image = draw_outlined(rig);
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
