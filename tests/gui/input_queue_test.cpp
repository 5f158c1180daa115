#include "app/view/input_queue.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <initializer_list>
#include <vector>

namespace atrium::app {
namespace {

constexpr KeyChange key(int code, bool down)
{
    return {code, 0, down ? 1 : 0, 0};
}
constexpr MouseMove move_to(float x)
{
    return {{x, 0}};
}

/// How many events each frame is given.
std::vector<std::size_t> frames_of(std::initializer_list<InputEvent> events)
{
    InputQueue queue;
    for (const InputEvent& e : events) queue.push(e);
    std::vector<std::size_t> out;
    while (!queue.empty()) out.push_back(queue.take_frame().size());
    return out;
}

using Sizes = std::vector<std::size_t>;

TEST(input_queue, a_tap_is_down_for_a_frame)
{
    EXPECT_EQ(frames_of({key(1, true), key(1, false)}), (Sizes{1, 1}));
    EXPECT_EQ(frames_of({MouseButton{0, true}, MouseButton{0, false}}), (Sizes{1, 1}));
    // Two keys of a chord go down together, and come up together.
    EXPECT_EQ(frames_of({key(1, true), key(2, true), key(2, false), key(1, false)}), (Sizes{2, 2}));
}

TEST(input_queue, each_click_is_where_it_was)
{
    EXPECT_EQ(frames_of({move_to(1), move_to(2), MouseButton{0, true}, MouseButton{0, false}, move_to(3),
                         MouseButton{0, true}, MouseButton{0, false}}),
              (Sizes{2, 1, 1, 1, 1, 1}));
}

TEST(input_queue, a_drag_goes_all_of_its_way)
{
    EXPECT_EQ(frames_of({MouseButton{0, true}, move_to(1), move_to(2), MouseButton{0, false}}), (Sizes{1, 2, 1}));
}

TEST(input_queue, movements_alone_never_wait)
{
    EXPECT_EQ(frames_of({move_to(1), move_to(2), move_to(3), move_to(4)}), (Sizes{4}));
    EXPECT_EQ(frames_of({move_to(1), MouseWheel{{0, 1}}, MouseWheel{{0, 1}}}), (Sizes{3}));
}

TEST(input_queue, text_goes_where_the_click_before_it_led)
{
    EXPECT_EQ(frames_of({MouseButton{0, true}, MouseButton{0, false}, key(1, true), TextInput{'a'}, key(1, false),
                         key(2, true), TextInput{'b'}, key(2, false)}),
              (Sizes{1, 1, 2, 3, 1}));
}

TEST(input_queue, keeps_the_order_and_loses_nothing)
{
    InputQueue queue;
    for (int i = 0; i < 50; ++i) queue.push(key(i % 3, i % 2 == 0));
    int seen = 0;
    while (!queue.empty()) {
        for (const InputEvent& e : queue.take_frame()) EXPECT_EQ(std::get<KeyChange>(e).key, seen++ % 3);
    }
    EXPECT_EQ(seen, 50);
    EXPECT_TRUE(queue.take_frame().empty());
}

} // namespace
} // namespace atrium::app
