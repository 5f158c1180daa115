#include "renderer/graph/bindings.hpp"

#include "shaders/shared/pass.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <stdexcept>

namespace atrium::graph {
namespace {

constexpr VkDescriptorType image = VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE;
constexpr VkDescriptorType buffer = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
constexpr VkDescriptorType storage_image = VK_DESCRIPTOR_TYPE_STORAGE_IMAGE;

/// A kind of descriptor, its first binding in set 2, and its macro in shaders.
struct Kind {
    VkDescriptorType type;
    std::uint32_t first;
    const char* name;
    const char* macro;
};
constexpr std::array<Kind, 3> kinds{{
    {image, PASS_FIRST_IMAGE, "a sampled image", "PASS_IMAGE"},
    {buffer, PASS_FIRST_BUFFER, "a storage buffer", "PASS_BUFFER"},
    {storage_image, PASS_FIRST_STORAGE_IMAGE, "a storage image", "PASS_STORAGE_IMAGE"},
}};

const char* name_of_type(VkDescriptorType type)
{
    const auto* kind = std::find_if(kinds.begin(), kinds.end(), [&](const Kind& k) { return k.type == type; });
    return kind == kinds.end() ? "a descriptor that no pass can declare" : kind->name;
}

/// A binding as shaders write it: PASS_BUFFER(2).
std::string place_of(std::uint32_t binding)
{
    for (const Kind& kind : kinds) {
        if (binding >= kind.first && binding - kind.first < PASS_BINDINGS_PER_KIND)
            return fmt::format("{}({})", kind.macro, binding - kind.first);
    }
    return fmt::format("binding {}", binding);
}

std::optional<VkDescriptorType> descriptor_of(Access access, bool is_image)
{
    switch (access) {
    case Access::sampled_fragment:
    case Access::sampled_compute:
    case Access::sampled_vertex:
        return is_image ? image : buffer;
    case Access::storage_read:
    case Access::storage_write:
    case Access::storage_fragment:
        return is_image ? storage_image : buffer;
    default:
        return std::nullopt;
    }
}

} // namespace

std::vector<BoundUse> bind_uses(const Pass& pass, const std::function<bool(ResourceIndex)>& is_image)
{
    std::vector<BoundUse> out;
    if (pass.kind == PassKind::transfer) return out;
    for (const Kind& kind : kinds) {
        std::uint32_t count = 0;
        for (std::size_t i = 0; i < pass.uses.size(); ++i) {
            if (descriptor_of(pass.uses[i].access, is_image(pass.uses[i].resource)) != kind.type) continue;
            if (count == PASS_BINDINGS_PER_KIND) {
                throw std::logic_error(fmt::format("graph: pass \"{}\" declares {} more than {} times", pass.name,
                                                   kind.name, PASS_BINDINGS_PER_KIND));
            }
            out.push_back({{kind.first + count++, kind.type}, i});
        }
    }
    return out;
}

void check_bindings(const Pass& pass, const std::vector<BoundUse>& declared, const std::vector<ShaderBindings>& shaders,
                    const std::function<std::string(ResourceIndex)>& name_of)
{
    std::vector<bool> bound(declared.size(), false);
    for (const ShaderBindings& shader : shaders) {
        for (const gpu::PassBinding& wanted : shader.bindings) {
            const auto found = std::find_if(declared.begin(), declared.end(),
                                            [&](const BoundUse& d) { return d.at.binding == wanted.binding; });
            if (found == declared.end()) {
                throw std::logic_error(
                    fmt::format("graph: shader {} binds {} at {}, and pass \"{}\" declares nothing for it",
                                shader.shader, name_of_type(wanted.type), place_of(wanted.binding), pass.name));
            }
            if (found->at.type != wanted.type) {
                throw std::logic_error(
                    fmt::format("graph: shader {} binds {} at {}, where pass \"{}\" declares \"{}\" as {}",
                                shader.shader, name_of_type(wanted.type), place_of(wanted.binding), pass.name,
                                name_of(pass.uses[found->use].resource), name_of_type(found->at.type)));
            }
            bound[static_cast<std::size_t>(found - declared.begin())] = true;
        }
    }
    for (std::size_t i = 0; i < declared.size(); ++i) {
        if (bound[i]) continue;
        std::string names;
        for (const ShaderBindings& shader : shaders) names += (names.empty() ? "" : ", ") + shader.shader;
        throw std::logic_error(fmt::format("graph: pass \"{}\" declares \"{}\" as {} at {}, and no shader binds it: {}",
                                           pass.name, name_of(pass.uses[declared[i].use].resource),
                                           name_of_type(declared[i].at.type), place_of(declared[i].at.binding), names));
    }
}

} // namespace atrium::graph
