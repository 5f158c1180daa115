#pragma once
// A window's images, to be drawn into one after the other.

#include "renderer/core/math.hpp"
#include "renderer/gpu/present_mode.hpp"
#include "renderer/gpu/resources.hpp"

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace atrium::gpu {

/// What a window system gives and wants. Empty: nothing is presented, and no extension asked for.
struct WindowSystem {
    std::vector<std::string> instance_extensions;
    std::function<VkSurfaceKHR(VkInstance)> create_surface; ///< throws Error
    explicit operator bool() const { return static_cast<bool>(create_surface); }
};

/// The best of a window's modes for what is wanted; FIFO, which every window has, where it offers none for it.
[[nodiscard]] VkPresentModeKHR choose_present_mode(PresentMode wanted, std::span<const VkPresentModeKHR> offered);

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
    /// Whether the window offered what the last resize() wanted; else its mode is PresentMode::on.
    [[nodiscard]] bool has_wanted_mode() const { return has_wanted_mode_; }

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
    bool has_wanted_mode_ = true;
    std::uint32_t current_ = 0;
};

} // namespace atrium::gpu
