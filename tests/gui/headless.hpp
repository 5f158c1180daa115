#pragma once
// ImGui without a window: frames are drawn into lists that nobody shows, and the mouse is moved by hand.

#include "renderer/core/math.hpp"

#include <functional>
#include <string>
#include <vector>

namespace atrium::test {

/// An ImGui context with a display of the size, in our style. One at a time.
class HeadlessGui {
public:
    HeadlessGui(float width, float height, float scale = 1);
    ~HeadlessGui();
    HeadlessGui(const HeadlessGui&) = delete;
    HeadlessGui& operator=(const HeadlessGui&) = delete;

    /// Draws one frame, in a window over the whole display where `in_window`.
    void frame(const std::function<void()>& draw, bool in_window = true) const;
    void mouse(float x, float y, bool held) const;
    /// Moves there, presses and lets go, each in a frame of its own.
    void click(float x, float y, const std::function<void()>& draw, bool in_window = true) const;
    void type(const char* text) const; ///< into the next frame

    /// Windows of the last frame that are cut off: outside the display, or narrower than what they hold.
    [[nodiscard]] std::vector<std::string> cut_off() const;
    /// Pixels that the tabs of the last frame lack to show their names whole.
    [[nodiscard]] float lacking_tab_width() const;
    /// How many vertices the last frame had.
    [[nodiscard]] int vertices() const;
};

} // namespace atrium::test
