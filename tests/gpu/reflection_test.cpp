// Structs shared by C++ and GLSL: the offsets that the compiled shaders have are those of C++.

#include "shaders/shared/aov.h"
#include "shaders/shared/culling.h"
#include "shaders/shared/frame.h"
#include "shaders/shared/lighting.h"
#include "shaders/shared/ltc.h"
#include "shaders/shared/scene.h"
#include "shaders/shared/shadow.h"
#include "tests/rig/device_rig.hpp"

#include <gtest/gtest.h>
#include <spirv_cross_c.h>

#include <map>
#include <string>

namespace atrium {
namespace {

using Offsets = std::map<std::string, unsigned>;

/// Adds the members of a struct and of all structs inside it, as "Struct.member".
void add_members(spvc_compiler compiler, spvc_type_id id, Offsets& out)
{
    const spvc_type type = spvc_compiler_get_type_handle(compiler, id);
    if (spvc_type_get_basetype(type) != SPVC_BASETYPE_STRUCT) return;
    const spvc_type_id base = spvc_type_get_base_type_id(type);
    for (unsigned i = 0; i < spvc_type_get_num_member_types(type); ++i) {
        unsigned offset = 0;
        spvc_compiler_type_struct_member_offset(compiler, type, i, &offset);
        out[std::string(spvc_compiler_get_name(compiler, base)) + "." +
            spvc_compiler_get_member_name(compiler, base, i)] = offset;
        add_members(
            compiler,
            spvc_type_get_base_type_id(spvc_compiler_get_type_handle(compiler, spvc_type_get_member_type(type, i))),
            out);
    }
}

Offsets offsets_in(const char* shader)
{
    const auto code = rig::find_shader(shader);
    Offsets out;
    spvc_context context = nullptr;
    spvc_parsed_ir ir = nullptr;
    spvc_compiler compiler = nullptr;
    spvc_resources resources = nullptr;
    spvc_context_create(&context);
    EXPECT_EQ(spvc_context_parse_spirv(context, code.data(), code.size(), &ir), SPVC_SUCCESS) << shader;
    spvc_context_create_compiler(context, SPVC_BACKEND_NONE, ir, SPVC_CAPTURE_MODE_TAKE_OWNERSHIP, &compiler);
    spvc_compiler_create_shader_resources(compiler, &resources);
    for (const auto kind :
         {SPVC_RESOURCE_TYPE_UNIFORM_BUFFER, SPVC_RESOURCE_TYPE_STORAGE_BUFFER, SPVC_RESOURCE_TYPE_PUSH_CONSTANT}) {
        const spvc_reflected_resource* list = nullptr;
        std::size_t count = 0;
        spvc_resources_get_resource_list_for_type(resources, kind, &list, &count);
        for (std::size_t i = 0; i < count; ++i) add_members(compiler, list[i].base_type_id, out);
    }
    spvc_context_destroy(context);
    return out;
}

#define EXPECT_MEMBER(offsets, Struct, member)                                                                         \
    EXPECT_TRUE((offsets).contains(#Struct "." #member)) << #Struct "." #member;                                       \
    EXPECT_EQ((offsets).at(#Struct "." #member), offsetof(shared::Struct, member)) << #Struct "." #member

TEST(shared_structs, frame_constants_and_lights_have_one_layout)
{
    const Offsets o = offsets_in("techniques/lighting/lighting.frag");
    EXPECT_MEMBER(o, FrameConstants, eye);
    EXPECT_MEMBER(o, FrameConstants, near);
    EXPECT_MEMBER(o, FrameConstants, right);
    EXPECT_MEMBER(o, FrameConstants, exposure);
    EXPECT_MEMBER(o, FrameConstants, ray_forward);
    EXPECT_MEMBER(o, FrameConstants, size);
    EXPECT_MEMBER(o, FrameConstants, ambient_ground);
    EXPECT_MEMBER(o, FrameConstants, light_count);
    EXPECT_MEMBER(o, FrameConstants, flags);
    EXPECT_MEMBER(o, FrameConstants, sky_ground);
    EXPECT_MEMBER(o, FrameConstants, lights);
    EXPECT_MEMBER(o, GpuLight, direction);
    EXPECT_MEMBER(o, GpuLight, color);
    EXPECT_MEMBER(o, GpuLight, half_right);
    EXPECT_MEMBER(o, GpuLight, sin2_radius);
    EXPECT_MEMBER(o, LightingPush, scale);
    EXPECT_MEMBER(o, LtcEntry, skew);
    EXPECT_MEMBER(o, LtcEntry, fresnel);
}

TEST(shared_structs, scene_tables_have_one_layout)
{
    const Offsets o = offsets_in("techniques/gbuffer/gbuffer.vert");
    EXPECT_MEMBER(o, GpuMaterial, flags);
    EXPECT_MEMBER(o, GpuMaterial, slots);
    EXPECT_MEMBER(o, GpuRecord, prev_rows);
    EXPECT_MEMBER(o, GpuRecord, material);
    EXPECT_MEMBER(o, GpuRecord, vertex_offset);
}

TEST(shared_structs, shadows_have_one_layout)
{
    const Offsets o = offsets_in("techniques/shadow/visibility.frag");
    EXPECT_MEMBER(o, ShadowFace, y);
    EXPECT_MEMBER(o, ShadowFace, scale);
    EXPECT_MEMBER(o, VisibilityPush, near);
    EXPECT_MEMBER(o, VisibilityPush, height_per_spread);
    EXPECT_MEMBER(o, VisibilityPush, cos_outer);
    EXPECT_MEMBER(o, VisibilityPush, side);
    EXPECT_MEMBER(o, VisibilityPush, cells);
    EXPECT_MEMBER(o, VisibilityPush, from_centre);
}

TEST(shared_structs, culling_has_one_layout)
{
    const Offsets o = offsets_in("techniques/culling/cull.comp");
    EXPECT_MEMBER(o, GpuCluster, cone_axis);
    EXPECT_MEMBER(o, GpuCluster, index_count);
    EXPECT_MEMBER(o, DrawTask, cluster);
    EXPECT_MEMBER(o, DrawCommand, first_instance);
    EXPECT_MEMBER(o, CullPush, flags);
}

} // namespace
} // namespace atrium
