#include "renderer/gpu/swapchain.hpp"

#include "renderer/core/error.hpp"
#include "renderer/gpu/result.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace atrium::gpu {
namespace {

/// Formats whose stores are not encoded once more: pictures come sRGB-encoded.
std::optional<std::pair<Format, VkColorSpaceKHR>> choose_format(VkPhysicalDevice device, VkSurfaceKHR surface)
{
    std::uint32_t count = 0;
    check(vkGetPhysicalDeviceSurfaceFormatsKHR(device, surface, &count, nullptr), "list the window's formats");
    std::vector<VkSurfaceFormatKHR> formats(count);
    check(vkGetPhysicalDeviceSurfaceFormatsKHR(device, surface, &count, formats.data()), "list the window's formats");
    for (const Format wanted : {Format::bgra8_unorm, Format::rgba8_unorm}) {
        for (const VkSurfaceFormatKHR& f : formats) {
            if (f.format == vk(wanted) && f.colorSpace == VK_COLOR_SPACE_SRGB_NONLINEAR_KHR)
                return std::pair{wanted, f.colorSpace};
        }
    }
    return std::nullopt;
}

std::vector<VkPresentModeKHR> offered_modes(VkPhysicalDevice device, VkSurfaceKHR surface)
{
    std::uint32_t count = 0;
    check(vkGetPhysicalDeviceSurfacePresentModesKHR(device, surface, &count, nullptr), "list the window's modes");
    std::vector<VkPresentModeKHR> modes(count);
    check(vkGetPhysicalDeviceSurfacePresentModesKHR(device, surface, &count, modes.data()), "list the window's modes");
    return modes;
}

/// Results that say that the window changed.
bool is_stale(VkResult result)
{
    return result == VK_ERROR_OUT_OF_DATE_KHR || result == VK_SUBOPTIMAL_KHR;
}

} // namespace

VkPresentModeKHR choose_present_mode(PresentMode wanted, std::span<const VkPresentModeKHR> offered)
{
    const auto has = [&](VkPresentModeKHR mode) {
        return std::find(offered.begin(), offered.end(), mode) != offered.end();
    };
    switch (wanted) {
    case PresentMode::on:
        break;
    case PresentMode::adaptive:
        if (has(VK_PRESENT_MODE_FIFO_RELAXED_KHR)) return VK_PRESENT_MODE_FIFO_RELAXED_KHR;
        break;
    case PresentMode::off:
        for (const VkPresentModeKHR mode : {VK_PRESENT_MODE_IMMEDIATE_KHR, VK_PRESENT_MODE_MAILBOX_KHR}) {
            if (has(mode)) return mode;
        }
        break;
    }
    return VK_PRESENT_MODE_FIFO_KHR;
}

Swapchain::Swapchain(const Instance& instance, const Device& device, const WindowSystem& window)
    : instance_(instance), device_(device), surface_(window.create_surface(instance.handle()))
{
    VkBool32 presents = VK_FALSE;
    const DeviceReport& report = device.report();
    check(vkGetPhysicalDeviceSurfaceSupportKHR(report.handle, report.queue_family, surface_, &presents),
          "ask whether the device can present");
    if (!presents || !choose_format(report.handle, surface_)) {
        vkDestroySurfaceKHR(instance.handle(), surface_, nullptr);
        throw Error(ExitCode::environment, fmt::format("{} cannot draw into this window", report.name), "atrium view",
                    presents ? "the window has no 8-bit format for encoded colours"
                             : "its queue cannot present to this display",
                    "choose another with --device; `atrium devices` lists them");
    }
}

Swapchain::~Swapchain()
{
    release();
    if (swapchain_) vkDestroySwapchainKHR(device_.handle(), swapchain_, nullptr);
    vkDestroySurfaceKHR(instance_.handle(), surface_, nullptr);
}

void Swapchain::release()
{
    vkDeviceWaitIdle(device_.handle());
    images_.clear();
    for (const VkSemaphore s : drawn_) vkDestroySemaphore(device_.handle(), s, nullptr);
    drawn_.clear();
    if (acquired_) vkDestroySemaphore(device_.handle(), acquired_, nullptr);
    acquired_ = VK_NULL_HANDLE;
}

VkSemaphore Swapchain::make_semaphore() const
{
    const VkSemaphoreCreateInfo create{VK_STRUCTURE_TYPE_SEMAPHORE_CREATE_INFO};
    VkSemaphore semaphore = VK_NULL_HANDLE;
    check(vkCreateSemaphore(device_.handle(), &create, nullptr, &semaphore), "create a semaphore");
    return semaphore;
}

bool Swapchain::resize(uvec2 size, PresentMode mode)
{
    const VkPhysicalDevice physical = device_.physical();
    VkSurfaceCapabilitiesKHR can{};
    check(vkGetPhysicalDeviceSurfaceCapabilitiesKHR(physical, surface_, &can), "measure the window");
    VkExtent2D extent = can.currentExtent;
    if (extent.width == UINT32_MAX) { // the window takes what it is given
        extent = {std::clamp(size.x, can.minImageExtent.width, can.maxImageExtent.width),
                  std::clamp(size.y, can.minImageExtent.height, can.maxImageExtent.height)};
    }
    release();
    size_ = uvec2(0);
    if (extent.width == 0 || extent.height == 0) return false;

    const auto [format, space] = *choose_format(physical, surface_);
    VkSwapchainCreateInfoKHR create{VK_STRUCTURE_TYPE_SWAPCHAIN_CREATE_INFO_KHR};
    create.surface = surface_;
    create.minImageCount = can.minImageCount + 1;
    if (can.maxImageCount > 0) create.minImageCount = std::min(create.minImageCount, can.maxImageCount);
    create.imageFormat = vk(format);
    create.imageColorSpace = space;
    create.imageExtent = extent;
    create.imageArrayLayers = 1;
    create.imageUsage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT;
    create.preTransform = can.currentTransform;
    create.compositeAlpha = VK_COMPOSITE_ALPHA_OPAQUE_BIT_KHR;
    create.presentMode = choose_present_mode(mode, offered_modes(physical, surface_));
    create.clipped = VK_TRUE;
    create.oldSwapchain = swapchain_;
    VkSwapchainKHR made = VK_NULL_HANDLE;
    check(vkCreateSwapchainKHR(device_.handle(), &create, nullptr, &made), "create the window's images");
    if (swapchain_) vkDestroySwapchainKHR(device_.handle(), swapchain_, nullptr);
    swapchain_ = made;

    std::uint32_t count = 0;
    check(vkGetSwapchainImagesKHR(device_.handle(), swapchain_, &count, nullptr), "list the window's images");
    std::vector<VkImage> handles(count);
    check(vkGetSwapchainImagesKHR(device_.handle(), swapchain_, &count, handles.data()), "list the window's images");
    for (std::uint32_t i = 0; i < count; ++i) {
        const ImageDesc desc{format, extent.width, extent.height, 1, 1, create.imageUsage};
        images_.push_back(Image::of_others(device_, fmt::format("window {}", i), desc, handles[i]));
        drawn_.push_back(make_semaphore());
    }
    acquired_ = make_semaphore();
    size_ = {extent.width, extent.height};
    has_wanted_mode_ = mode == PresentMode::on || create.presentMode != VK_PRESENT_MODE_FIFO_KHR;
    return true;
}

std::optional<Swapchain::Target> Swapchain::acquire()
{
    if (images_.empty()) return std::nullopt;
    const VkResult result =
        vkAcquireNextImageKHR(device_.handle(), swapchain_, UINT64_MAX, acquired_, VK_NULL_HANDLE, &current_);
    if (result == VK_ERROR_OUT_OF_DATE_KHR) return std::nullopt;
    if (result != VK_SUBOPTIMAL_KHR) check(result, "get an image of the window");
    return Target{&images_[current_], {acquired_, drawn_[current_]}};
}

bool Swapchain::present()
{
    VkPresentInfoKHR info{VK_STRUCTURE_TYPE_PRESENT_INFO_KHR};
    info.waitSemaphoreCount = 1;
    info.pWaitSemaphores = &drawn_[current_];
    info.swapchainCount = 1;
    info.pSwapchains = &swapchain_;
    info.pImageIndices = &current_;
    const VkResult result = vkQueuePresentKHR(device_.queue(), &info);
    if (is_stale(result)) return false;
    check(result, "show an image in the window");
    return true;
}

} // namespace atrium::gpu
