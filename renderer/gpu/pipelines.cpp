#include "renderer/gpu/pipelines.hpp"

#include "renderer/core/atomic_file.hpp"
#include "renderer/core/error.hpp"
#include "renderer/core/jobs.hpp"
#include "renderer/core/log.hpp"
#include "renderer/gpu/result.hpp"
#include "renderer/gpu/shader_interface.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <functional>
#include <iterator>
#include <utility>

namespace atrium::gpu {
namespace {

std::vector<char> read_whole(const std::filesystem::path& file)
{
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

/// Drivers must refuse foreign caches, and some did not: compare the header ourselves.
bool cache_is_ours(const std::vector<char>& data, VkPhysicalDevice device)
{
    VkPipelineCacheHeaderVersionOne header{};
    if (data.size() < sizeof(header)) return false;
    std::memcpy(&header, data.data(), sizeof(header));
    VkPhysicalDeviceProperties p{};
    vkGetPhysicalDeviceProperties(device, &p);
    return header.headerSize >= sizeof(header) && header.headerVersion == VK_PIPELINE_CACHE_HEADER_VERSION_ONE &&
           header.vendorID == p.vendorID && header.deviceID == p.deviceID &&
           !std::memcmp(header.pipelineCacheUUID, p.pipelineCacheUUID, VK_UUID_SIZE);
}

bool uses(const GraphicsPipelineDesc& desc, const std::string& shader)
{
    const std::vector<std::string> all = desc.shaders();
    return std::find(all.begin(), all.end(), shader) != all.end();
}

} // namespace

std::vector<std::string> GraphicsPipelineDesc::shaders() const
{
    std::vector<std::string> all{vertex, tessellation_control, tessellation_evaluation, geometry, fragment};
    std::erase(all, "");
    return all;
}

Pipelines::Pipelines(const Device& device, const Descriptors& descriptors, ShaderLookup shaders,
                     const std::filesystem::path& cache_folder)
    : device_(device), descriptors_(descriptors), shaders_(std::move(shaders)),
      cache_file_(cache_folder.empty() ? cache_folder : cache_folder / "pipelines.bin")
{
    std::vector<char> data;
    if (!cache_file_.empty()) data = read_whole(cache_file_);
    if (!cache_is_ours(data, device.physical())) data.clear();
    VkPipelineCacheCreateInfo create{VK_STRUCTURE_TYPE_PIPELINE_CACHE_CREATE_INFO};
    create.initialDataSize = data.size();
    create.pInitialData = data.data();
    check(vkCreatePipelineCache(device.handle(), &create, nullptr, &cache_), "create the pipeline cache");
    cache_size_at_start_ = data.size();
}

Pipelines::~Pipelines()
{
    try {
        std::size_t size = 0;
        if (!cache_file_.empty() && vkGetPipelineCacheData(device_.handle(), cache_, &size, nullptr) == VK_SUCCESS &&
            size > cache_size_at_start_) {
            std::vector<char> data(size);
            if (vkGetPipelineCacheData(device_.handle(), cache_, &size, data.data()) == VK_SUCCESS) {
                std::filesystem::create_directories(cache_file_.parent_path());
                write_text_file(cache_file_, {data.data(), size});
            }
        }
    } catch (const std::exception& e) {
        log_verbose(fmt::format("pipeline cache not kept: {}", e.what())); // Slower next time, nothing worse.
    }
    for (const auto& [desc, pipeline] : graphics_) destroy(pipeline);
    for (const auto& [desc, pipeline] : compute_) destroy(pipeline);
    for (const auto& [name, shader] : modules_) vkDestroyShaderModule(device_.handle(), shader, nullptr);
    vkDestroyPipelineCache(device_.handle(), cache_, nullptr);
}

void Pipelines::destroy(VkPipeline pipeline) const
{
    vkDestroyPipeline(device_.handle(), pipeline, nullptr);
}

VkShaderModule Pipelines::create_module(const std::string& name, std::span<const std::uint32_t> code) const
{
    VkShaderModuleCreateInfo create{VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO};
    create.codeSize = code.size_bytes();
    create.pCode = code.data();
    VkShaderModule shader = VK_NULL_HANDLE;
    check(vkCreateShaderModule(device_.handle(), &create, nullptr, &shader), fmt::format("create shader {}", name));
    return shader;
}

std::span<const std::uint32_t> Pipelines::code_of(const std::string& name) const
{
    const std::span<const std::uint32_t> code = shaders_(name);
    if (code.empty()) {
        throw Error(ExitCode::internal, fmt::format("no shader is called {}", name), "",
                    "it is not in shaders/CMakeLists.txt", "add it to the list there");
    }
    return code;
}

VkShaderModule Pipelines::module(const std::string& name)
{
    const std::lock_guard lock(mutex_);
    if (const auto found = modules_.find(name); found != modules_.end()) return found->second;
    return modules_.emplace(name, create_module(name, code_of(name))).first->second;
}

const std::vector<PassBinding>& Pipelines::pass_bindings(const std::string& shader)
{
    const auto [known, fresh] = pass_bindings_.try_emplace(shader);
    if (fresh) known->second = find_pass_bindings(code_of(shader));
    return known->second;
}

void Pipelines::replace(const std::string& shader, std::span<const std::uint32_t> code)
{
    if (const auto conflict = interface_conflict(find_interface(shaders_(shader)), find_interface(code))) {
        throw Error(ExitCode::input, fmt::format("{} no longer fits the program", shader), *conflict,
                    "the program was built for other inputs and outputs of this shader",
                    "take that back, or build the program again");
    }
    const VkShaderModule before = module(shader);
    modules_[shader] = create_module(shader, code);
    Made<GraphicsPipelineDesc> graphics;
    Made<ComputePipelineDesc> compute;
    try {
        for (const auto& [desc, old] : graphics_)
            if (uses(desc, shader)) graphics[desc] = create(desc);
        for (const auto& [desc, old] : compute_)
            if (desc.shader == shader) compute[desc] = create(desc);
    } catch (...) {
        for (const auto& [desc, pipeline] : graphics) destroy(pipeline);
        for (const auto& [desc, pipeline] : compute) destroy(pipeline);
        vkDestroyShaderModule(device_.handle(), std::exchange(modules_[shader], before), nullptr);
        throw;
    }
    for (const auto& [desc, pipeline] : graphics) destroy(std::exchange(graphics_[desc], pipeline));
    for (const auto& [desc, pipeline] : compute) destroy(std::exchange(compute_[desc], pipeline));
    vkDestroyShaderModule(device_.handle(), before, nullptr);
}

void Pipelines::prepare(std::span<const GraphicsPipelineDesc> graphics, std::span<const ComputePipelineDesc> compute)
{
    std::vector<std::function<void()>> jobs;
    for (const auto& desc : graphics) {
        if (const auto [slot, fresh] = graphics_.try_emplace(desc, VK_NULL_HANDLE); fresh) {
            jobs.emplace_back([this, slot = slot] { slot->second = create(slot->first); });
        }
    }
    for (const auto& desc : compute) {
        if (const auto [slot, fresh] = compute_.try_emplace(desc, VK_NULL_HANDLE); fresh) {
            jobs.emplace_back([this, slot = slot] { slot->second = create(slot->first); });
        }
    }
    if (jobs.empty()) return;
    try {
        parallel_for(jobs.size(), [&](std::size_t i) { jobs[i](); });
    } catch (...) {
        std::erase_if(graphics_, [](const auto& entry) { return !entry.second; });
        std::erase_if(compute_, [](const auto& entry) { return !entry.second; });
        throw;
    }
}

VkPipeline Pipelines::get(const GraphicsPipelineDesc& desc)
{
    prepare({&desc, 1}, {});
    return graphics_.at(desc);
}

VkPipeline Pipelines::get(const ComputePipelineDesc& desc)
{
    prepare({}, {&desc, 1});
    return compute_.at(desc);
}

} // namespace atrium::gpu
