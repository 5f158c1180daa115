#include "app/view/input_queue.hpp"

#include <algorithm>

namespace atrium::app {
namespace {

template <class E>
bool holds(const std::vector<InputEvent>& frame)
{
    return std::any_of(frame.begin(), frame.end(), [](const InputEvent& e) { return std::holds_alternative<E>(e); });
}

template <class E, class F>
bool holds(const std::vector<InputEvent>& frame, F&& like)
{
    return std::any_of(frame.begin(), frame.end(), [&](const InputEvent& e) {
        const E* one = std::get_if<E>(&e);
        return one != nullptr && like(*one);
    });
}

bool must_wait(const MouseMove& /*unused*/, const std::vector<InputEvent>& frame)
{
    return holds<MouseButton>(frame) || holds<KeyChange>(frame) || holds<MouseWheel>(frame);
}

bool must_wait(const MouseButton& next, const std::vector<InputEvent>& frame)
{
    // What lies over others sees the mouse a frame before it takes a click, and a drag ends where the mouse was last.
    return holds<MouseMove>(frame) || holds<KeyChange>(frame) || holds<TextInput>(frame) ||
           holds<MouseButton>(frame, [&](const MouseButton& b) { return b.button == next.button; });
}

bool must_wait(const MouseWheel& /*unused*/, const std::vector<InputEvent>& frame)
{
    return holds<MouseButton>(frame) || holds<KeyChange>(frame);
}

bool must_wait(const KeyChange& next, const std::vector<InputEvent>& frame)
{
    return holds<MouseButton>(frame) || holds<TextInput>(frame) ||
           holds<KeyChange>(frame, [&](const KeyChange& k) { return k.key == next.key; });
}

bool must_wait(const TextInput& /*unused*/, const std::vector<InputEvent>& frame)
{
    return holds<MouseButton>(frame);
}

} // namespace

std::vector<InputEvent> InputQueue::take_frame()
{
    std::vector<InputEvent> frame;
    while (!events_.empty()) {
        const InputEvent& next = events_.front();
        if (std::visit([&](const auto& e) { return must_wait(e, frame); }, next)) break;
        frame.push_back(next);
        events_.pop_front();
    }
    return frame;
}

} // namespace atrium::app
