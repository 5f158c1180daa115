#pragma once
// A window's images, to be drawn into one after the other.

#include "renderer/core/math.hpp"
#include "renderer/gpu/resources.hpp"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace atrium::gpu {

/// What a window system gives and wants. Empty: nothing is presented, and no extension asked for.
struct WindowSystem {
    std::vector<std::string> instance_extensions;
    std::function<VkSurfaceKHR(VkInstance)> create_surface; ///< throws Error
    explicit operator bool() const { return static_cast<bool>(create_surface); }
};

/// How images wait for the display.
enum class PresentMode : std::uint8_t {
    vsync,    ///< in turn, one for each of its refreshes
    mailbox,  ///< the newest at each refresh; vsync where there is none such
    immediate ///< at once, be it torn; vsync where there is none such
};

class Swapchain {
public:
    /// Throws Error(environment) where the device cannot present to the window.
    Swapchain(const Instance& instance, const Device& device, const WindowSystem& window);
    ~Swapchain();
    Swapchain(const Swapchain&) = delete;
    Swapchain& operator=(const Swapchain&) = delete;

    /// New images for a window of so many pixels. False where it has none now (it is minimised).
    bool resize(uvec2 size, PresentMode mode);
    [[nodiscard]] uvec2 size() const { return size_; }

    /// An image to draw into, BGRA8 or RGBA8, whose values go to the display as they are (sRGB-encoded). None where the
    /// window has changed: resize() first. Drawing has to wait for `sync.wait` and signal `sync.signal`.
    struct Target {
        const Image* image = nullptr;
        SubmitSync sync;
    };
    [[nodiscard]] std::optional<Target> acquire();
    /// Shows the image acquired last, once what was submitted with its sync is done. False where the window has
    /// changed.
    bool present();

private:
    void release();
    VkSemaphore make_semaphore() const;

    const Instance& instance_;
    const Device& device_;
    VkSurfaceKHR surface_ = VK_NULL_HANDLE;
    VkSwapchainKHR swapchain_ = VK_NULL_HANDLE;
    VkSemaphore acquired_ = VK_NULL_HANDLE;
    std::vector<Image> images_;
    /// One per image: presenting is over with a semaphore only when its image comes again.
    std::vector<VkSemaphore> drawn_;
    uvec2 size_{0};
    std::uint32_t current_ = 0;
};

} // namespace atrium::gpu
