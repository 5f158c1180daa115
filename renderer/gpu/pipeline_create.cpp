// From the small descriptions to Vulkan's large ones.

#include "renderer/core/error.hpp"
#include "renderer/gpu/pipelines.hpp"
#include "renderer/gpu/result.hpp"

#include <fmt/format.h>

#include <array>
#include <stdexcept>

namespace atrium::gpu {
namespace {

/// Specialisation constants 0, 1, … as 32-bit words.
struct Specialization {
    std::vector<VkSpecializationMapEntry> entries;
    VkSpecializationInfo info{};

    explicit Specialization(const std::vector<std::uint32_t>& constants)
    {
        for (std::uint32_t i = 0; i < constants.size(); ++i) entries.push_back({i, 4 * i, 4});
        info = {static_cast<std::uint32_t>(entries.size()), entries.data(), constants.size() * 4, constants.data()};
    }
};

/// The layout of atrium::Vertex (renderer/scene/scene.hpp).
constexpr std::array<VkVertexInputAttributeDescription, 4> scene_attributes{{
    {0, 0, VK_FORMAT_R32G32B32_SFLOAT, 0},
    {1, 0, VK_FORMAT_R32_UINT, 12},
    {2, 0, VK_FORMAT_R32_UINT, 16},
    {3, 0, VK_FORMAT_R32G32_SFLOAT, 20},
}};
constexpr VkVertexInputBindingDescription scene_binding{0, 28, VK_VERTEX_INPUT_RATE_VERTEX};

VkPrimitiveTopology vk(Topology topology)
{
    switch (topology) {
    case Topology::triangles:
        return VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
    case Topology::lines:
        return VK_PRIMITIVE_TOPOLOGY_LINE_LIST;
    case Topology::points:
        return VK_PRIMITIVE_TOPOLOGY_POINT_LIST;
    case Topology::patches:
        return VK_PRIMITIVE_TOPOLOGY_PATCH_LIST;
    }
    return VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
}

VkPipelineColorBlendAttachmentState blend_state(Blend blend)
{
    VkPipelineColorBlendAttachmentState state{};
    state.colorWriteMask =
        VK_COLOR_COMPONENT_R_BIT | VK_COLOR_COMPONENT_G_BIT | VK_COLOR_COMPONENT_B_BIT | VK_COLOR_COMPONENT_A_BIT;
    state.blendEnable = blend != Blend::off;
    state.srcColorBlendFactor = blend == Blend::alpha ? VK_BLEND_FACTOR_SRC_ALPHA : VK_BLEND_FACTOR_ONE;
    state.dstColorBlendFactor = blend == Blend::alpha ? VK_BLEND_FACTOR_ONE_MINUS_SRC_ALPHA : VK_BLEND_FACTOR_ONE;
    state.srcAlphaBlendFactor = VK_BLEND_FACTOR_ONE;
    state.dstAlphaBlendFactor = VK_BLEND_FACTOR_ONE;
    return state;
}

std::vector<VkPipelineColorBlendAttachmentState> blend_states(const GraphicsPipelineDesc& desc)
{
    std::vector<VkPipelineColorBlendAttachmentState> states(desc.colors.size(), blend_state(desc.blend));
    for (std::size_t i = 0; i < desc.blends.size(); ++i) states[i] = blend_state(desc.blends[i]);
    return states;
}

/// Throws std::logic_error if the parts of a description contradict each other.
void check_description(const GraphicsPipelineDesc& desc, const std::string& name)
{
    const auto refuse = [&](const char* why) { throw std::logic_error(fmt::format("pipeline of {}: {}", name, why)); };
    if (desc.tessellation_control.empty() != desc.tessellation_evaluation.empty())
        refuse("one tessellation stage without the other");
    if ((desc.topology == Topology::patches) != !desc.tessellation_control.empty())
        refuse("tessellation needs patches, and patches need tessellation");
    if ((desc.topology == Topology::patches) != (desc.patch_points > 0)) refuse("patches need control points");
    if (!desc.blends.empty() && desc.blends.size() != desc.colors.size()) refuse("not one blending per target");
}

/// Throws Error(environment) if the device lacks what a pipeline needs.
void check_features(const GraphicsPipelineDesc& desc, const std::string& name, const DeviceReport& device)
{
    const auto refuse = [&](const std::string& lacked) {
        throw Error(ExitCode::environment, fmt::format("the device cannot run the pipeline of {}", name), device.name,
                    fmt::format("it lacks {}", lacked), "choose another device; `atrium devices` lists them");
    };
    if (!desc.tessellation_control.empty() && !device.optional.tessellation) refuse("tessellationShader");
    if (!desc.geometry.empty() && !device.optional.geometry) refuse("geometryShader");
    if ((device.sample_counts & desc.samples) == 0) refuse(fmt::format("{} samples per pixel", desc.samples));
}

VkPipelineShaderStageCreateInfo stage_info(VkShaderStageFlagBits stage, VkShaderModule module,
                                           const Specialization& constants)
{
    VkPipelineShaderStageCreateInfo info{VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO};
    info.stage = stage;
    info.module = module;
    info.pName = "main";
    info.pSpecializationInfo = &constants.info;
    return info;
}

VkPipelineVertexInputStateCreateInfo vertex_input(VertexInput kind)
{
    VkPipelineVertexInputStateCreateInfo input{VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO};
    if (kind == VertexInput::scene) {
        input.vertexBindingDescriptionCount = 1;
        input.pVertexBindingDescriptions = &scene_binding;
        input.vertexAttributeDescriptionCount = static_cast<std::uint32_t>(scene_attributes.size());
        input.pVertexAttributeDescriptions = scene_attributes.data();
    }
    return input;
}

VkPipelineDepthStencilStateCreateInfo depth_state(const GraphicsPipelineDesc& desc)
{
    VkPipelineDepthStencilStateCreateInfo depth{VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO};
    depth.depthTestEnable = desc.depth_test != DepthTest::off;
    depth.depthWriteEnable = desc.depth_write;
    // equal_zero: full-screen triangles lie in the far plane, at depth 0, and so pass only where nothing was drawn.
    depth.depthCompareOp =
        desc.depth_test == DepthTest::equal_zero ? VK_COMPARE_OP_EQUAL : VK_COMPARE_OP_GREATER_OR_EQUAL;
    return depth;
}

} // namespace

VkPipeline Pipelines::create(const GraphicsPipelineDesc& desc)
{
    const std::string& name = desc.fragment.empty() ? desc.vertex : desc.fragment;
    check_description(desc, name);
    check_features(desc, name, device_.report());
    const Specialization constants(desc.constants);
    std::vector<VkPipelineShaderStageCreateInfo> stages;
    const auto add_stage = [&](VkShaderStageFlagBits stage, const std::string& shader) {
        if (!shader.empty()) stages.push_back(stage_info(stage, module(shader), constants));
    };
    add_stage(VK_SHADER_STAGE_VERTEX_BIT, desc.vertex);
    add_stage(VK_SHADER_STAGE_TESSELLATION_CONTROL_BIT, desc.tessellation_control);
    add_stage(VK_SHADER_STAGE_TESSELLATION_EVALUATION_BIT, desc.tessellation_evaluation);
    add_stage(VK_SHADER_STAGE_GEOMETRY_BIT, desc.geometry);
    add_stage(VK_SHADER_STAGE_FRAGMENT_BIT, desc.fragment);

    const VkPipelineVertexInputStateCreateInfo input = vertex_input(desc.input);
    VkPipelineInputAssemblyStateCreateInfo assembly{VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO};
    assembly.topology = vk(desc.topology);
    // With the origin at the lower left, `ccw` in a shader has the meaning of the GLSL specification: triangles keep
    // the winding of their patch.
    VkPipelineTessellationDomainOriginStateCreateInfo origin{
        VK_STRUCTURE_TYPE_PIPELINE_TESSELLATION_DOMAIN_ORIGIN_STATE_CREATE_INFO};
    origin.domainOrigin = VK_TESSELLATION_DOMAIN_ORIGIN_LOWER_LEFT;
    VkPipelineTessellationStateCreateInfo tessellation{VK_STRUCTURE_TYPE_PIPELINE_TESSELLATION_STATE_CREATE_INFO};
    tessellation.pNext = &origin;
    tessellation.patchControlPoints = desc.patch_points;
    VkPipelineViewportStateCreateInfo viewport{VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO};
    viewport.viewportCount = viewport.scissorCount = 1;
    VkPipelineRasterizationStateCreateInfo raster{VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO};
    raster.frontFace = VK_FRONT_FACE_COUNTER_CLOCKWISE;
    raster.lineWidth = 1;
    raster.polygonMode = desc.lines ? VK_POLYGON_MODE_LINE : VK_POLYGON_MODE_FILL;
    VkPipelineMultisampleStateCreateInfo multisample{VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO};
    multisample.rasterizationSamples =
        static_cast<VkSampleCountFlagBits>(desc.samples); // the flag's value is the sample count
    const VkPipelineDepthStencilStateCreateInfo depth = depth_state(desc);
    const std::vector<VkPipelineColorBlendAttachmentState> blends = blend_states(desc);
    VkPipelineColorBlendStateCreateInfo blend{VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO};
    blend.attachmentCount = static_cast<std::uint32_t>(blends.size());
    blend.pAttachments = blends.data();
    const std::array dynamic{VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR, VK_DYNAMIC_STATE_CULL_MODE};
    VkPipelineDynamicStateCreateInfo dynamics{VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO};
    dynamics.dynamicStateCount = static_cast<std::uint32_t>(dynamic.size());
    dynamics.pDynamicStates = dynamic.data();

    std::vector<VkFormat> colors;
    for (const Format f : desc.colors) colors.push_back(vk(f));
    VkPipelineRenderingCreateInfo rendering{VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO};
    rendering.colorAttachmentCount = static_cast<std::uint32_t>(colors.size());
    rendering.pColorAttachmentFormats = colors.data();
    rendering.depthAttachmentFormat = vk(desc.depth);

    VkGraphicsPipelineCreateInfo create{VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO};
    create.pNext = &rendering;
    create.stageCount = static_cast<std::uint32_t>(stages.size());
    create.pStages = stages.data();
    create.pVertexInputState = &input;
    create.pInputAssemblyState = &assembly;
    if (desc.topology == Topology::patches) create.pTessellationState = &tessellation;
    create.pViewportState = &viewport;
    create.pRasterizationState = &raster;
    create.pMultisampleState = &multisample;
    create.pDepthStencilState = &depth;
    create.pColorBlendState = &blend;
    create.pDynamicState = &dynamics;
    create.layout = descriptors_.pipeline_layout(desc.pass_layout);
    VkPipeline pipeline = VK_NULL_HANDLE;
    check(vkCreateGraphicsPipelines(device_.handle(), cache_, 1, &create, nullptr, &pipeline),
          fmt::format("compile the pipeline of {}", name));
    device_.name(VK_OBJECT_TYPE_PIPELINE, reinterpret_cast<std::uint64_t>(pipeline), name);
    return pipeline;
}

VkPipeline Pipelines::create(const ComputePipelineDesc& desc)
{
    const Specialization constants(desc.constants);
    VkComputePipelineCreateInfo create{VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO};
    create.stage = stage_info(VK_SHADER_STAGE_COMPUTE_BIT, module(desc.shader), constants);
    create.layout = descriptors_.pipeline_layout(desc.pass_layout);
    VkPipeline pipeline = VK_NULL_HANDLE;
    check(vkCreateComputePipelines(device_.handle(), cache_, 1, &create, nullptr, &pipeline),
          fmt::format("compile the pipeline of {}", desc.shader));
    device_.name(VK_OBJECT_TYPE_PIPELINE, reinterpret_cast<std::uint64_t>(pipeline), desc.shader);
    return pipeline;
}

} // namespace atrium::gpu
