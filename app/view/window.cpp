#include "app/view/window.hpp"

#include "renderer/core/error.hpp"

#define GLFW_INCLUDE_VULKAN
#include <GLFW/glfw3.h>

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace atrium::app {
namespace {

/// What GLFW said last; its own words are the best there are.
std::string last_error()
{
    const char* text = nullptr;
    glfwGetError(&text);
    return text ? text : "the window system gave no reason";
}

[[noreturn]] void fail(const std::string& what)
{
    const std::string why = last_error();
    glfwTerminate();
    throw Error(ExitCode::environment, what, "atrium view", why,
                "run it where there is a display (DISPLAY or WAYLAND_DISPLAY), or use `atrium render`");
}

Window& self(GLFWwindow* window)
{
    return *static_cast<Window*>(glfwGetWindowUserPointer(window));
}

/// Whether a button is held: what was taken in the window then goes on outside.
bool drags(GLFWwindow* window)
{
    for (int button = 0; button <= GLFW_MOUSE_BUTTON_LAST; ++button)
        if (glfwGetMouseButton(window, button) == GLFW_PRESS) return true;
    return false;
}

/// The monitor that holds the window's middle.
GLFWmonitor* monitor_of(const WindowPlace& place)
{
    int count = 0;
    GLFWmonitor** monitors = glfwGetMonitors(&count);
    const ivec2 middle = place.position + place.size / 2;
    for (int i = 0; i < count; ++i) {
        ivec2 at, size;
        glfwGetMonitorWorkarea(monitors[i], &at.x, &at.y, &size.x, &size.y);
        const ivec2 inside = middle - at;
        if (inside.x >= 0 && inside.y >= 0 && inside.x < size.x && inside.y < size.y) return monitors[i];
    }
    return glfwGetPrimaryMonitor();
}

} // namespace

Window::Window(const std::string& title, const WindowPlace& place) : windowed_(place)
{
    if (!glfwInit()) fail("no window can be opened");
    if (!glfwVulkanSupported()) fail("Vulkan cannot draw into windows here");
    glfwWindowHint(GLFW_CLIENT_API, GLFW_NO_API);
    glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
    glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
    const ivec2 size = glm::max(place.size, ivec2(320, 200));
    window_ = glfwCreateWindow(size.x, size.y, title.c_str(), nullptr, nullptr);
    if (!window_) fail("no window can be opened");
    glfwSetWindowSizeLimits(window_, 320, 200, GLFW_DONT_CARE, GLFW_DONT_CARE);
    // Only where it is still on a monitor: they may have been changed since.
    if (place.position.x >= 0 && monitor_of(place)) glfwSetWindowPos(window_, place.position.x, place.position.y);
    if (place.maximised) glfwMaximizeWindow(window_);
    glfwSetWindowUserPointer(window_, this);
    glfwSetInputMode(window_, GLFW_STICKY_KEYS, GLFW_TRUE); // a key that came and went within a slow frame counts
    listen();
}

Window::~Window()
{
    glfwDestroyWindow(window_);
    glfwTerminate();
}

void Window::listen()
{
    glfwSetKeyCallback(window_, [](GLFWwindow* w, int key, int scancode, int action, int mods) {
        // The interface repeats a key that is held by itself.
        if (action != GLFW_REPEAT) self(w).on_input(KeyChange{key, scancode, action, mods});
    });
    glfwSetCharCallback(window_, [](GLFWwindow* w, unsigned character) { self(w).on_input(TextInput{character}); });
    glfwSetMouseButtonCallback(window_, [](GLFWwindow* w, int button, int action, int) {
        self(w).on_input(MouseButton{button, action == GLFW_PRESS});
    });
    glfwSetCursorPosCallback(window_, [](GLFWwindow* w, double x, double y) {
        self(w).on_input(MouseMove{vec2(x, y) * self(w).pixels_per_coordinate()});
    });
    glfwSetCursorEnterCallback(window_, [](GLFWwindow* w, int entered) {
        if (!entered && drags(w)) return;
        if (!entered) return self(w).on_input(MouseMove{mouse_outside});
        double x = 0, y = 0;
        glfwGetCursorPos(w, &x, &y); // the window may have come to the mouse
        self(w).on_input(MouseMove{vec2(x, y) * self(w).pixels_per_coordinate()});
    });
    glfwSetScrollCallback(window_, [](GLFWwindow* w, double x, double y) { self(w).on_input(MouseWheel{vec2(x, y)}); });
    glfwSetDropCallback(window_, [](GLFWwindow* w, int count, const char** files) {
        on_event(self(w));
        if (count > 0) self(w).dropped_ = files[0];
    });
    glfwSetFramebufferSizeCallback(window_, [](GLFWwindow* w, int, int) { on_event(self(w)); });
    glfwSetWindowRefreshCallback(window_, [](GLFWwindow* w) { on_event(self(w)); });
    glfwSetWindowFocusCallback(window_, [](GLFWwindow* w, int) { on_event(self(w)); });
    glfwSetWindowIconifyCallback(window_, [](GLFWwindow* w, int) { on_event(self(w)); });
    glfwSetWindowContentScaleCallback(window_, [](GLFWwindow* w, float, float) { on_event(self(w)); });
}

gpu::WindowSystem Window::window_system() const
{
    std::uint32_t count = 0;
    const char** names = glfwGetRequiredInstanceExtensions(&count);
    gpu::WindowSystem out;
    out.instance_extensions.assign(names, names + count);
    out.create_surface = [window = window_](VkInstance instance) {
        VkSurfaceKHR surface = VK_NULL_HANDLE;
        const VkResult result = glfwCreateWindowSurface(instance, window, nullptr, &surface);
        if (result != VK_SUCCESS) {
            throw Error(ExitCode::environment, "Vulkan cannot draw into the window", "atrium view", last_error(),
                        "use `atrium render`");
        }
        return surface;
    };
    return out;
}

void Window::on_input(const InputEvent& event)
{
    on_event(*this);
    input_.push(event);
}

vec2 Window::pixels_per_coordinate() const
{
    ivec2 size, framebuffer;
    glfwGetWindowSize(window_, &size.x, &size.y);
    glfwGetFramebufferSize(window_, &framebuffer.x, &framebuffer.y);
    return vec2(framebuffer) / vec2(glm::max(size, ivec2(1)));
}

bool Window::poll(double seconds)
{
    events_ = false;
    if (seconds > 0)
        glfwWaitEventsTimeout(seconds);
    else
        glfwPollEvents();
    return events_;
}

bool Window::closed() const
{
    return glfwWindowShouldClose(window_) != 0;
}

uvec2 Window::pixels() const
{
    int width = 0, height = 0;
    glfwGetFramebufferSize(window_, &width, &height);
    if (glfwGetWindowAttrib(window_, GLFW_ICONIFIED)) return uvec2(0);
    return {static_cast<std::uint32_t>(std::max(width, 0)), static_cast<std::uint32_t>(std::max(height, 0))};
}

float Window::scale() const
{
    float x = 1, y = 1;
    glfwGetWindowContentScale(window_, &x, &y);
    return std::max(x, y);
}

WindowPlace Window::place() const
{
    if (glfwGetWindowMonitor(window_)) return windowed_;
    WindowPlace out;
    glfwGetWindowPos(window_, &out.position.x, &out.position.y);
    glfwGetWindowSize(window_, &out.size.x, &out.size.y);
    out.maximised = glfwGetWindowAttrib(window_, GLFW_MAXIMIZED) != 0;
    return out;
}

void Window::show()
{
    glfwShowWindow(window_);
}

void Window::set_title(const std::string& title)
{
    glfwSetWindowTitle(window_, title.c_str());
}

void Window::toggle_full_screen()
{
    if (glfwGetWindowMonitor(window_)) {
        glfwSetWindowMonitor(window_, nullptr, windowed_.position.x, windowed_.position.y, windowed_.size.x,
                             windowed_.size.y, GLFW_DONT_CARE);
        return;
    }
    windowed_ = place();
    GLFWmonitor* monitor = monitor_of(windowed_);
    if (!monitor) return;
    const GLFWvidmode* mode = glfwGetVideoMode(monitor);
    glfwSetWindowMonitor(window_, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
}

std::optional<std::filesystem::path> Window::take_dropped()
{
    return std::exchange(dropped_, std::nullopt);
}

bool Window::held(int key) const
{
    return glfwGetKey(window_, key) == GLFW_PRESS;
}

} // namespace atrium::app
