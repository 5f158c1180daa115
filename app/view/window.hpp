#pragma once
// A window of the desktop's: its size, its events, the keys held down, what was dropped on it.

#include "app/view/input_queue.hpp"
#include "renderer/core/math.hpp"
#include "renderer/gpu/swapchain.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

struct GLFWwindow;

namespace atrium::app {

/// Where the window was when it was last closed, in screen coordinates.
struct WindowPlace {
    ivec2 position{-1}; ///< -1: wherever the desktop puts it
    ivec2 size{1280, 720};
    bool maximised = false;
    bool operator==(const WindowPlace&) const = default;
};

/// A key that went down: GLFW_KEY_…, and GLFW_MOD_… held with it.
struct KeyPress {
    int key = 0, mods = 0;
    bool operator==(const KeyPress&) const = default;
};

class Window {
public:
    /// Not seen until show(). Throws Error(environment) where there is no display, or none that Vulkan can draw to.
    Window(const std::string& title, const WindowPlace& place);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    [[nodiscard]] gpu::WindowSystem window_system() const;
    [[nodiscard]] GLFWwindow* handle() const { return window_; }

    /// Handles events; waits for the first at most so many seconds. Returns whether there were any.
    bool poll(double seconds);
    [[nodiscard]] bool closed() const;
    [[nodiscard]] uvec2 pixels() const; ///< (0, 0) while minimised
    [[nodiscard]] float scale() const;  ///< of the monitor that it is on: 2 on one of twice the density
    [[nodiscard]] WindowPlace place() const;
    void show();
    void set_title(const std::string& title);
    void toggle_full_screen();

    /// What keyboard and mouse did that nobody has taken yet.
    [[nodiscard]] InputQueue& input() { return input_; }
    /// Now, or since this was last asked.
    [[nodiscard]] bool held(int key) const;
    /// The file dropped on it since the last call; the first of several.
    [[nodiscard]] std::optional<std::filesystem::path> take_dropped();

private:
    static void on_event(Window& window) { window.events_ = true; }
    void on_input(const InputEvent& event);
    /// Not 1 where the desktop counts the mouse in units of several pixels, as Wayland does at high density.
    [[nodiscard]] vec2 pixels_per_coordinate() const;
    void listen();
    GLFWwindow* window_ = nullptr;
    bool events_ = false;
    WindowPlace windowed_; ///< before full screen
    InputQueue input_;
    std::optional<std::filesystem::path> dropped_;
};

} // namespace atrium::app
