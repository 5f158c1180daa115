#include "renderer/gpu/shader_interface.hpp"

#include "renderer/core/error.hpp"

#include <fmt/format.h>
#include <spirv_cross_c.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace atrium::gpu {
namespace {

/// SPIRV-Cross's view of one shader.
class Reflection {
public:
    explicit Reflection(std::span<const std::uint32_t> code)
    {
        spvc_parsed_ir ir = nullptr;
        if (spvc_context_create(&context_) != SPVC_SUCCESS ||
            spvc_context_parse_spirv(context_, code.data(), code.size(), &ir) != SPVC_SUCCESS ||
            spvc_context_create_compiler(context_, SPVC_BACKEND_NONE, ir, SPVC_CAPTURE_MODE_TAKE_OWNERSHIP,
                                         &compiler_) != SPVC_SUCCESS) {
            const std::string why = context_ ? spvc_context_get_last_error_string(context_) : "out of memory";
            spvc_context_destroy(context_);
            throw Error(ExitCode::input, "a shader's code cannot be read", "", why, "compile it again");
        }
        spvc_compiler_create_shader_resources(compiler_, &resources_);
    }
    ~Reflection() { spvc_context_destroy(context_); }
    Reflection(const Reflection&) = delete;
    Reflection& operator=(const Reflection&) = delete;

    [[nodiscard]] std::span<const spvc_reflected_resource> list(spvc_resource_type kind) const
    {
        const spvc_reflected_resource* first = nullptr;
        std::size_t count = 0;
        spvc_resources_get_resource_list_for_type(resources_, kind, &first, &count);
        return {first, count};
    }
    [[nodiscard]] std::span<const spvc_specialization_constant> constants() const
    {
        const spvc_specialization_constant* first = nullptr;
        std::size_t count = 0;
        spvc_compiler_get_specialization_constants(compiler_, &first, &count);
        return {first, count};
    }
    [[nodiscard]] spvc_type_id type_of(const spvc_specialization_constant& constant) const
    {
        return spvc_constant_get_type(spvc_compiler_get_constant_handle(compiler_, constant.id));
    }
    [[nodiscard]] unsigned decoration(const spvc_reflected_resource& r, SpvDecoration which) const
    {
        return spvc_compiler_get_decoration(compiler_, r.id, which);
    }
    [[nodiscard]] std::string work_group() const
    {
        const auto size = [&](unsigned axis) {
            return spvc_compiler_get_execution_mode_argument_by_index(compiler_, SpvExecutionModeLocalSize, axis);
        };
        return fmt::format("{} x {} x {}", size(0), size(1), size(2));
    }
    /// A type with all that is inside it: numbers, sizes, offsets.
    [[nodiscard]] std::string layout(spvc_type_id id) const
    {
        const spvc_type type = spvc_compiler_get_type_handle(compiler_, id);
        std::string out =
            fmt::format("{}:{}x{}x{}", static_cast<int>(spvc_type_get_basetype(type)), spvc_type_get_bit_width(type),
                        spvc_type_get_vector_size(type), spvc_type_get_columns(type));
        for (unsigned i = 0; i < spvc_type_get_num_array_dimensions(type); ++i)
            out += fmt::format("[{}]", spvc_type_get_array_dimension(type, i));
        const spvc_basetype base = spvc_type_get_basetype(type);
        if (base == SPVC_BASETYPE_IMAGE) out += image_layout(type);
        if (base == SPVC_BASETYPE_STRUCT) out += struct_layout(type);
        return out;
    }

private:
    [[nodiscard]] std::string image_layout(spvc_type type) const
    {
        return fmt::format("({} {} {} {})", static_cast<int>(spvc_type_get_image_dimension(type)),
                           layout(spvc_type_get_image_sampled_type(type)), spvc_type_get_image_arrayed(type),
                           spvc_type_get_image_multisampled(type));
    }
    [[nodiscard]] std::string struct_layout(spvc_type type) const
    {
        std::string out = "{";
        for (unsigned i = 0; i < spvc_type_get_num_member_types(type); ++i) {
            unsigned offset = 0, stride = 0;
            spvc_compiler_type_struct_member_offset(compiler_, type, i, &offset);
            const spvc_type_id member = spvc_type_get_member_type(type, i);
            if (spvc_type_get_num_array_dimensions(spvc_compiler_get_type_handle(compiler_, member)) > 0)
                spvc_compiler_type_struct_member_array_stride(compiler_, type, i, &stride);
            out += fmt::format(" {}/{} {}", offset, stride, layout(member));
        }
        return out + " }";
    }

    spvc_context context_ = nullptr;
    spvc_compiler compiler_ = nullptr;
    spvc_resources resources_ = nullptr;
};

constexpr std::string_view output_name = "output";

} // namespace

ShaderInterface find_interface(std::span<const std::uint32_t> code)
{
    const Reflection shader(code);
    ShaderInterface out;
    for (const auto kind :
         {SPVC_RESOURCE_TYPE_UNIFORM_BUFFER, SPVC_RESOURCE_TYPE_STORAGE_BUFFER, SPVC_RESOURCE_TYPE_SEPARATE_IMAGE,
          SPVC_RESOURCE_TYPE_SEPARATE_SAMPLERS, SPVC_RESOURCE_TYPE_STORAGE_IMAGE, SPVC_RESOURCE_TYPE_SAMPLED_IMAGE}) {
        for (const auto& r : shader.list(kind)) {
            out[fmt::format("set {}, binding {}", shader.decoration(r, SpvDecorationDescriptorSet),
                            shader.decoration(r, SpvDecorationBinding))] =
                fmt::format("{} {}", static_cast<int>(kind), shader.layout(r.type_id));
        }
    }
    for (const auto& r : shader.list(SPVC_RESOURCE_TYPE_PUSH_CONSTANT))
        out["push constants"] = shader.layout(r.base_type_id);
    for (const auto& constant : shader.constants())
        out[fmt::format("constant {}", constant.constant_id)] = shader.layout(shader.type_of(constant));
    for (const auto& [kind, name] : {std::pair{SPVC_RESOURCE_TYPE_STAGE_INPUT, std::string_view("input")},
                                     std::pair{SPVC_RESOURCE_TYPE_STAGE_OUTPUT, output_name}}) {
        for (const auto& r : shader.list(kind)) {
            out[fmt::format("{} {}", name, shader.decoration(r, SpvDecorationLocation))] =
                fmt::format("{} flat {}", shader.layout(r.type_id), shader.decoration(r, SpvDecorationFlat));
        }
    }
    out["work group"] = shader.work_group();
    return out;
}

std::vector<PassBinding> find_pass_bindings(std::span<const std::uint32_t> code)
{
    constexpr std::array kinds{
        std::pair{SPVC_RESOURCE_TYPE_UNIFORM_BUFFER, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER},
        std::pair{SPVC_RESOURCE_TYPE_STORAGE_BUFFER, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER},
        std::pair{SPVC_RESOURCE_TYPE_SEPARATE_IMAGE, VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE},
        std::pair{SPVC_RESOURCE_TYPE_SEPARATE_SAMPLERS, VK_DESCRIPTOR_TYPE_SAMPLER},
        std::pair{SPVC_RESOURCE_TYPE_SAMPLED_IMAGE, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER},
        std::pair{SPVC_RESOURCE_TYPE_STORAGE_IMAGE, VK_DESCRIPTOR_TYPE_STORAGE_IMAGE},
        std::pair{SPVC_RESOURCE_TYPE_ACCELERATION_STRUCTURE, VK_DESCRIPTOR_TYPE_ACCELERATION_STRUCTURE_KHR},
    };
    const Reflection shader(code);
    std::vector<PassBinding> out;
    for (const auto& [kind, type] : kinds) {
        for (const auto& r : shader.list(kind)) {
            if (shader.decoration(r, SpvDecorationDescriptorSet) == 2)
                out.push_back({shader.decoration(r, SpvDecorationBinding), type});
        }
    }
    std::sort(out.begin(), out.end());
    return out;
}

std::optional<std::string> interface_conflict(const ShaderInterface& built, const ShaderInterface& fresh)
{
    for (const auto& [item, layout] : fresh) {
        const auto other = built.find(item);
        if (other == built.end()) return fmt::format("{} is new", item);
        if (other->second != layout) return fmt::format("another layout or type of {}", item);
    }
    for (const auto& [item, layout] : built) {
        if (item.starts_with(output_name) && !fresh.contains(item)) return fmt::format("{} is missing", item);
    }
    return std::nullopt;
}

} // namespace atrium::gpu
