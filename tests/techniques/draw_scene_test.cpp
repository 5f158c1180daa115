// Drawing the scene by material class: which sides, which pipelines.

#include "renderer/techniques/common/draw_scene.hpp"
#include "tests/rig/frame_rig.hpp"
#include "tests/truth/scene_builder.hpp"
#include "tests/truth/shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace atrium {
namespace {

Material of_class(MaterialClass cls)
{
    Material m;
    m.name = to_string(cls);
    m.cls = cls;
    return m;
}

/// A square that faces +z.
BakeData square(const Material& material)
{
    truth::SceneBuilder builder;
    builder.add_mesh("square", builder.add_material(material), truth::quad({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}));
    return builder.finish();
}

bool is_seen(const rig::FrameRig& rig)
{
    return std::isfinite(rig.aov("depth").at(160, 90)[0]);
}

TEST(draw_scene, the_table_of_classes_says_which_sides_are_drawn)
{
    for (const MaterialClassInfo& cls : material_classes) {
        rig::FrameRig rig(square(of_class(cls.cls)));
        rig.set("culling.cone", "off"); // so that faces are culled by the pass alone
        rig.set("culling.triangles", "off");
        rig.look({0, 0, 3}, {0, 0, 0});
        EXPECT_TRUE(is_seen(rig)) << to_string(cls.cls);
        rig.look({0, 0, -3}, {0, 0, 0});
        EXPECT_EQ(is_seen(rig), cls.cls != MaterialClass::opaque) << to_string(cls.cls);
        rig.request.materials = {{"*", {{"two_sided", "on"}}}};
        EXPECT_TRUE(is_seen(rig)) << to_string(cls.cls);
    }
}

TEST(draw_scene, classes_that_a_pass_draws_alike_share_its_pipeline)
{
    truth::SceneBuilder builder;
    float x = -2;
    for (const MaterialClassInfo& cls : material_classes)
        builder.add_mesh(to_string(cls.cls), builder.add_material(of_class(cls.cls)),
                         truth::quad({x++, 0, 0}, {0.9f, 0, 0}, {0, 0.9f, 0}));
    rig::FrameRig rig(builder.finish());
    rig.look({0, 0.5f, 3}, {0, 0.5f, 0});
    rig.light("sun,direction=0:-1:-1,shadow=on");
    rig.set("debug.wireframe", "on");
    rig.set("shadow.cascades", "3");
    rig.set("shadow.cache", "off");
    rig.request.want_picture = true;
    const graph::RunStats stats = rig.render().stats;
    const auto binds = [&](const char* name) {
        const auto pass = std::find_if(stats.passes.begin(), stats.passes.end(),
                                       [&](const graph::PassStats& p) { return p.name == name; });
        return pass == stats.passes.end() ? 0u : pass->pipeline_binds;
    };
    EXPECT_EQ(binds("gbuffer"), 3u);   // cloth is drawn as opaque is
    EXPECT_EQ(binds("wireframe"), 1u); // all alike
    EXPECT_EQ(binds("shadow.0"), 3u * 3u);
}

TEST(draw_scene, a_pipeline_is_completed_for_its_class)
{
    Geometry geometry;
    geometry.materials_diverge = false;
    MaterialClassInfo cls;
    cls.vertex = 7;
    gpu::GraphicsPipelineDesc desc = class_pipeline({}, cls, geometry);
    EXPECT_EQ(desc.input, gpu::VertexInput::scene);
    EXPECT_EQ(desc.constants, (std::vector<std::uint32_t>{0, 7}));
    EXPECT_EQ(desc.topology, gpu::Topology::triangles);

    cls.tessellated = true;
    EXPECT_THROW(static_cast<void>(class_pipeline({}, cls, geometry)), std::logic_error);
    desc.tessellation_control = "a.tesc";
    desc.tessellation_evaluation = "a.tese";
    desc = class_pipeline(desc, cls, geometry);
    EXPECT_EQ(desc.topology, gpu::Topology::patches);
    EXPECT_EQ(desc.patch_points, 3u);
}

} // namespace
} // namespace atrium
