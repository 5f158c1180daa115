// Which device: what Atrium requires of one, and why each of the others is refused.

#include "renderer/core/error.hpp"
#include "renderer/gpu/instance.hpp"
#include "renderer/gpu/result.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstring>
#include <optional>

namespace atrium::gpu {
namespace {

struct Features {
    VkPhysicalDeviceFeatures2 core{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2};
    VkPhysicalDeviceVulkan11Features v11{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_1_FEATURES};
    VkPhysicalDeviceVulkan12Features v12{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES};
    VkPhysicalDeviceVulkan13Features v13{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES};

    explicit Features(VkPhysicalDevice device)
    {
        core.pNext = &v11;
        v11.pNext = &v12;
        v12.pNext = &v13;
        vkGetPhysicalDeviceFeatures2(device, &core);
    }
};

std::vector<std::string> missing_features(VkPhysicalDevice device)
{
    const Features f(device);
    const std::array<std::pair<VkBool32, const char*>, 16> required{{
        {f.core.features.robustBufferAccess, "robustBufferAccess (damaged files must not reach foreign memory)"},
        {f.core.features.multiDrawIndirect, "multiDrawIndirect (culled clusters are drawn by it)"},
        {f.core.features.drawIndirectFirstInstance, "drawIndirectFirstInstance (a draw's record index)"},
        {f.core.features.independentBlend, "independentBlend (G-buffer)"},
        {f.v11.shaderDrawParameters, "shaderDrawParameters (a draw's record index)"},
        {f.v12.drawIndirectCount, "drawIndirectCount (culled clusters)"},
        {f.v12.descriptorIndexing, "descriptorIndexing (the bindless table)"},
        {f.v12.runtimeDescriptorArray, "runtimeDescriptorArray (the bindless table)"},
        {f.v12.descriptorBindingPartiallyBound, "descriptorBindingPartiallyBound (the bindless table)"},
        {f.v12.descriptorBindingSampledImageUpdateAfterBind,
         "descriptorBindingSampledImageUpdateAfterBind (the bindless table)"},
        {f.v12.shaderSampledImageArrayNonUniformIndexing,
         "shaderSampledImageArrayNonUniformIndexing (materials in one draw)"},
        {f.v12.scalarBlockLayout, "scalarBlockLayout (structs shared with the shaders)"},
        {f.v12.hostQueryReset, "hostQueryReset (timers)"},
        {f.v13.dynamicRendering, "dynamicRendering"},
        {f.v13.maintenance4, "maintenance4 (group sizes in SPIR-V)"},
        {f.v13.synchronization2, "synchronization2 (barriers of the frame graph)"},
    }};
    std::vector<std::string> missing;
    for (const auto& [present, name] : required) {
        if (!present) missing.push_back(fmt::format("lacks {}", name));
    }
    return missing;
}

std::optional<std::uint32_t> find_queue_family(VkPhysicalDevice device)
{
    std::uint32_t count = 0;
    vkGetPhysicalDeviceQueueFamilyProperties(device, &count, nullptr);
    std::vector<VkQueueFamilyProperties> families(count);
    vkGetPhysicalDeviceQueueFamilyProperties(device, &count, families.data());
    constexpr VkQueueFlags wanted = VK_QUEUE_GRAPHICS_BIT | VK_QUEUE_COMPUTE_BIT;
    for (std::uint32_t i = 0; i < count; ++i) {
        if ((families[i].queueFlags & wanted) == wanted && families[i].timestampValidBits > 0) return i;
    }
    return std::nullopt;
}

bool has_device_extension(VkPhysicalDevice device, const char* name)
{
    std::uint32_t count = 0;
    vkEnumerateDeviceExtensionProperties(device, nullptr, &count, nullptr);
    std::vector<VkExtensionProperties> extensions(count);
    vkEnumerateDeviceExtensionProperties(device, nullptr, &count, extensions.data());
    return std::any_of(extensions.begin(), extensions.end(),
                       [&](const auto& e) { return !std::strcmp(e.extensionName, name); });
}

const char* type_name(VkPhysicalDeviceType type)
{
    switch (type) {
    case VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU:
        return "discrete GPU";
    case VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU:
        return "integrated GPU";
    case VK_PHYSICAL_DEVICE_TYPE_VIRTUAL_GPU:
        return "virtual GPU";
    case VK_PHYSICAL_DEVICE_TYPE_CPU:
        return "CPU";
    default:
        return "other";
    }
}

int rank(const DeviceReport& report)
{
    const std::array order{"discrete GPU", "integrated GPU", "virtual GPU", "CPU"};
    const auto found = std::find(order.begin(), order.end(), report.type);
    return static_cast<int>(found - order.begin());
}

DeviceReport describe(VkPhysicalDevice device, std::uint32_t index)
{
    VkPhysicalDeviceSubgroupProperties subgroup{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_SUBGROUP_PROPERTIES};
    VkPhysicalDeviceDriverProperties driver{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DRIVER_PROPERTIES};
    driver.pNext = &subgroup;
    VkPhysicalDeviceProperties2 properties{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2};
    VkPhysicalDeviceProperties basic{};
    vkGetPhysicalDeviceProperties(device, &basic);

    DeviceReport report;
    report.handle = device;
    report.index = index;
    report.name = basic.deviceName;
    report.type = type_name(basic.deviceType);
    report.is_cpu = basic.deviceType == VK_PHYSICAL_DEVICE_TYPE_CPU;
    if (basic.apiVersion < VK_API_VERSION_1_3) {
        report.refusals.push_back(fmt::format("offers Vulkan {}.{}, 1.3 is needed",
                                              VK_API_VERSION_MAJOR(basic.apiVersion),
                                              VK_API_VERSION_MINOR(basic.apiVersion)));
        return report; // The structures below need 1.2 and 1.3.
    }
    properties.pNext = &driver;
    vkGetPhysicalDeviceProperties2(device, &properties);
    report.subgroup_size = subgroup.subgroupSize;
    report.subpixel_bits = basic.limits.subPixelPrecisionBits;
    report.widest_image = basic.limits.maxImageDimension2D;
    report.sample_counts = basic.limits.framebufferColorSampleCounts & basic.limits.framebufferDepthSampleCounts;
    report.storage_range = basic.limits.maxStorageBufferRange;
    report.driver = fmt::format("{} {}", driver.driverName, driver.driverInfo);
    report.refusals = missing_features(device);
    if (const auto family = find_queue_family(device)) {
        report.queue_family = *family;
    } else {
        report.refusals.emplace_back("has no queue family with graphics, compute and timestamps");
    }
    VkFormatProperties depth{};
    vkGetPhysicalDeviceFormatProperties(device, VK_FORMAT_D32_SFLOAT, &depth);
    if (!(depth.optimalTilingFeatures & VK_FORMAT_FEATURE_SAMPLED_IMAGE_BIT)) {
        report.refusals.emplace_back("cannot sample D32 images");
    }

    const Features f(device);
    report.optional.anisotropy = f.core.features.samplerAnisotropy;
    report.optional.block_compression = f.core.features.textureCompressionBC;
    report.optional.geometry = f.core.features.geometryShader;
    report.optional.tessellation = f.core.features.tessellationShader;
    report.optional.lines = f.core.features.fillModeNonSolid;
    report.optional.host_memory_import = has_device_extension(device, VK_EXT_EXTERNAL_MEMORY_HOST_EXTENSION_NAME);
    report.optional.subgroup_ballot = (subgroup.supportedOperations & VK_SUBGROUP_FEATURE_BALLOT_BIT) &&
                                      (subgroup.supportedStages & VK_SHADER_STAGE_COMPUTE_BIT);
    if (!report.optional.anisotropy)
        report.absent_optionals.emplace_back("samplerAnisotropy: trilinear filtering only");
    if (!report.optional.lines) report.absent_optionals.emplace_back("fillModeNonSolid: debug.wireframe has no effect");
    if (!report.optional.geometry)
        report.absent_optionals.emplace_back("geometryShader: passes with geometry shaders are refused");
    if (!report.optional.tessellation)
        report.absent_optionals.emplace_back("tessellationShader: passes with tessellation are refused");
    if (!report.optional.block_compression) {
        report.absent_optionals.emplace_back("textureCompressionBC: bakes made with --textures bc are refused");
    }
    if (!report.optional.host_memory_import) {
        report.absent_optionals.emplace_back("VK_EXT_external_memory_host: scenes are loaded through a staging buffer");
    }
    if (!report.optional.subgroup_ballot)
        report.absent_optionals.emplace_back("subgroup ballots: culling.triangles has no effect");
    return report;
}

bool contains_ignoring_case(const std::string& text, const std::string& part)
{
    const auto lower = [](unsigned char c) { return std::tolower(c); };
    return std::search(text.begin(), text.end(), part.begin(), part.end(), [&](char a, char b) {
               return lower(static_cast<unsigned char>(a)) == lower(static_cast<unsigned char>(b));
           }) != text.end();
}

std::string why_none(const std::vector<DeviceReport>& reports)
{
    if (reports.empty()) return "the Vulkan loader finds no driver at all";
    std::string why;
    for (const DeviceReport& r : reports) {
        for (const std::string& reason : r.refusals) {
            why += fmt::format("{}{} ({}): {}", why.empty() ? "" : "\n         ", r.name, r.type, reason);
        }
    }
    return why;
}

} // namespace

std::vector<DeviceReport> list_devices(const Instance& instance)
{
    std::uint32_t count = 0;
    check(vkEnumeratePhysicalDevices(instance.handle(), &count, nullptr), "list the Vulkan devices");
    std::vector<VkPhysicalDevice> devices(count);
    check(vkEnumeratePhysicalDevices(instance.handle(), &count, devices.data()), "list the Vulkan devices");
    std::vector<DeviceReport> reports;
    for (std::uint32_t i = 0; i < count; ++i) reports.push_back(describe(devices[i], i));
    return reports;
}

DeviceReport choose_device(const Instance& instance, const std::string& wanted)
{
    const std::vector<DeviceReport> reports = list_devices(instance);
    const bool by_index =
        !wanted.empty() && std::all_of(wanted.begin(), wanted.end(), [](unsigned char c) { return std::isdigit(c); });
    const DeviceReport* best = nullptr;
    bool matched = false;
    for (const DeviceReport& r : reports) {
        if (!wanted.empty() && !(by_index ? std::to_string(r.index) == wanted : contains_ignoring_case(r.name, wanted)))
            continue;
        matched = true;
        if (r.refusals.empty() && (!best || rank(r) < rank(*best))) best = &r;
    }
    if (best) return *best;
    if (!wanted.empty() && !matched) {
        throw Error(ExitCode::usage, fmt::format("no device is called \"{}\"", wanted), "--device",
                    fmt::format("{} device(s) were found", reports.size()), "`atrium devices` lists them");
    }
    throw Error(
        ExitCode::environment, "no Vulkan device is suitable", wanted.empty() ? "" : "--device", why_none(reports),
        "install a driver for Vulkan 1.3 with descriptor indexing; without a GPU: mesa-vulkan-drivers 24 or newer "
        "(Debian 12: from bookworm-backports, scripts/setup does it)");
}

} // namespace atrium::gpu
