#pragma once
// An X server of the tests' own (Xvfb, with a small window manager), and hands on its keyboard and mouse.

#include "renderer/core/image.hpp"
#include "renderer/core/math.hpp"

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

struct _XDisplay; // NOLINT(bugprone-reserved-identifier): Xlib calls it so

namespace atrium::window {

/// A program that ends with its object at the latest.
class Process {
public:
    /// In a folder (empty: this one), with variables set beside those that there are.
    Process(const std::vector<std::string>& command, const std::filesystem::path& folder,
            const std::vector<std::string>& environment);
    ~Process();
    Process(const Process&) = delete;
    Process& operator=(const Process&) = delete;

    [[nodiscard]] bool running();
    /// Its exit code once it has ended, minus the signal if one ended it; none within the time.
    [[nodiscard]] std::optional<int> wait(std::chrono::seconds most);
    /// CPU seconds that it has taken so far, and bytes of memory that it has now.
    [[nodiscard]] double cpu_seconds() const;
    [[nodiscard]] std::uint64_t resident_bytes() const;

private:
    int pid_ = 0;
    std::optional<int> code_;
};

class Desktop {
public:
    /// Throws std::runtime_error with what is missing.
    explicit Desktop(ivec2 size);
    ~Desktop();
    Desktop(const Desktop&) = delete;
    Desktop& operator=(const Desktop&) = delete;

    [[nodiscard]] const std::string& name() const { return name_; } ///< for DISPLAY

    using WindowId = unsigned long;
    /// A window whose title contains the text, once there is one; 0 if there is none within the time.
    [[nodiscard]] WindowId find(const std::string& title, std::chrono::seconds most);
    [[nodiscard]] ivec2 size_of(WindowId window);
    void resize(WindowId window, ivec2 size);
    void minimise(WindowId window);
    void restore(WindowId window);
    void close(WindowId window); ///< as its button in the frame would
    void focus(WindowId window);

    /// What the window shows now, RGB.
    [[nodiscard]] Image8 grab(WindowId window);

    // Real events, from the server's devices. Keys are X11's names: "w", "F1", "Control_L".
    void press(const std::string& key);
    void release(const std::string& key);
    void tap(const std::string& key, const std::string& held = "");
    void move(WindowId window, ivec2 at); ///< the mouse, in the window's pixels
    void button(int number, bool down);
    void click(WindowId window, ivec2 at, int number = 1);
    void drag(WindowId window, ivec2 from, ivec2 to, int number = 1);

    /// Drops a file on the window's middle, as a file manager does (XDND). Returns whether the window took it.
    bool drop(WindowId window, const std::filesystem::path& file);

private:
    std::string name_;
    std::optional<Process> server_, manager_;
    _XDisplay* display_ = nullptr;
};

/// Of two pictures of one size, the mean difference of their values, 0 to 255; 255 where sizes differ.
[[nodiscard]] double mean_difference(const Image8& a, const Image8& b);

} // namespace atrium::window
