#include "renderer/gpu/instance.hpp"

#include "renderer/core/error.hpp"
#include "renderer/gpu/result.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

namespace atrium::gpu {
namespace {

VKAPI_ATTR VkBool32 VKAPI_CALL on_message(VkDebugUtilsMessageSeverityFlagBitsEXT, VkDebugUtilsMessageTypeFlagsEXT,
                                          const VkDebugUtilsMessengerCallbackDataEXT* data, void* user)
{
    static_cast<ValidationLog*>(user)->add(
        fmt::format("validation: {}: {}", data->pMessageIdName ? data->pMessageIdName : "?", data->pMessage));
    return VK_FALSE;
}

bool has_layer(const char* name)
{
    std::uint32_t count = 0;
    vkEnumerateInstanceLayerProperties(&count, nullptr);
    std::vector<VkLayerProperties> layers(count);
    vkEnumerateInstanceLayerProperties(&count, layers.data());
    return std::any_of(layers.begin(), layers.end(), [&](const auto& l) { return !std::strcmp(l.layerName, name); });
}

bool has_extension(const char* layer, const char* name)
{
    std::uint32_t count = 0;
    vkEnumerateInstanceExtensionProperties(layer, &count, nullptr);
    std::vector<VkExtensionProperties> extensions(count);
    vkEnumerateInstanceExtensionProperties(layer, &count, extensions.data());
    return std::any_of(extensions.begin(), extensions.end(),
                       [&](const auto& e) { return !std::strcmp(e.extensionName, name); });
}

} // namespace

Instance::Instance(bool validate, const std::vector<std::string>& further)
{
    std::vector<const char*> layers, extensions;
    for (const std::string& name : further) extensions.push_back(name.c_str());
    if (validate) {
        if (!has_layer(validation_layer)) {
            throw Error(ExitCode::environment, "validation was asked for, but its layer is not installed", "--validate",
                        fmt::format("the Vulkan loader does not find {}", validation_layer),
                        fmt::format("install the package {}, or leave --validate out", validation_package));
        }
        layers.push_back(validation_layer);
    }
    debug_utils_ = has_extension(nullptr, VK_EXT_DEBUG_UTILS_EXTENSION_NAME) ||
                   (validate && has_extension(validation_layer, VK_EXT_DEBUG_UTILS_EXTENSION_NAME));
    if (debug_utils_) extensions.push_back(VK_EXT_DEBUG_UTILS_EXTENSION_NAME);
    if (validate) extensions.push_back(VK_EXT_VALIDATION_FEATURES_EXTENSION_NAME);

    // 1.3, not the loader's newest: Debian 12's validation layer does not know what came later.
    VkApplicationInfo application{VK_STRUCTURE_TYPE_APPLICATION_INFO};
    application.pApplicationName = "atrium";
    application.apiVersion = VK_API_VERSION_1_3;

    const VkValidationFeatureEnableEXT synchronization = VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT;
    VkValidationFeaturesEXT features{VK_STRUCTURE_TYPE_VALIDATION_FEATURES_EXT};
    features.enabledValidationFeatureCount = 1;
    features.pEnabledValidationFeatures = &synchronization;

    VkDebugUtilsMessengerCreateInfoEXT messenger{VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT};
    messenger.pNext = &features;
    messenger.messageSeverity =
        VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT;
    messenger.messageType = VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT;
    messenger.pfnUserCallback = on_message;
    messenger.pUserData = log_.get();

    VkInstanceCreateInfo create{VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO};
    if (validate) create.pNext = &messenger;
    create.pApplicationInfo = &application;
    create.enabledLayerCount = static_cast<std::uint32_t>(layers.size());
    create.ppEnabledLayerNames = layers.data();
    create.enabledExtensionCount = static_cast<std::uint32_t>(extensions.size());
    create.ppEnabledExtensionNames = extensions.data();
    check(vkCreateInstance(&create, nullptr, &instance_), "create a Vulkan instance");

    if (validate) {
        messenger.pNext = nullptr;
        const auto create_messenger = reinterpret_cast<PFN_vkCreateDebugUtilsMessengerEXT>(
            vkGetInstanceProcAddr(instance_, "vkCreateDebugUtilsMessengerEXT"));
        check(create_messenger(instance_, &messenger, nullptr, &messenger_), "listen to the validation layer");
    }
}

Instance::~Instance()
{
    if (messenger_) {
        const auto destroy = reinterpret_cast<PFN_vkDestroyDebugUtilsMessengerEXT>(
            vkGetInstanceProcAddr(instance_, "vkDestroyDebugUtilsMessengerEXT"));
        destroy(instance_, messenger_, nullptr);
    }
    vkDestroyInstance(instance_, nullptr);
}

} // namespace atrium::gpu
