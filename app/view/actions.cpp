#include "app/view/actions.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <array>

namespace atrium::app {
namespace {

constexpr std::array actions{
    ActionInfo{Action::forward, "forward", {GLFW_KEY_W, 0}, "forward"},
    ActionInfo{Action::left, "left", {GLFW_KEY_A, 0}, "to the left"},
    ActionInfo{Action::back, "back", {GLFW_KEY_S, 0}, "back"},
    ActionInfo{Action::right, "right", {GLFW_KEY_D, 0}, "to the right"},
    ActionInfo{Action::down, "down", {GLFW_KEY_Q, 0}, "down"},
    ActionInfo{Action::up, "up", {GLFW_KEY_E, 0}, "up"},
    ActionInfo{Action::turn_left, "turn_left", {GLFW_KEY_LEFT, 0}, "turn left"},
    ActionInfo{Action::turn_right, "turn_right", {GLFW_KEY_RIGHT, 0}, "turn right"},
    ActionInfo{Action::turn_up, "turn_up", {GLFW_KEY_UP, 0}, "turn up"},
    ActionInfo{Action::turn_down, "turn_down", {GLFW_KEY_DOWN, 0}, "turn down"},
    ActionInfo{
        Action::previous_buffer, "previous_buffer", {GLFW_KEY_COMMA, 0}, "previous buffer in place of the picture"},
    ActionInfo{Action::next_buffer, "next_buffer", {GLFW_KEY_PERIOD, 0}, "next buffer; after the last, the picture"},
    ActionInfo{Action::frame, "frame", {GLFW_KEY_HOME, 0}, "frame the selected light, or the scene"},
    ActionInfo{Action::light_view, "light_view", {GLFW_KEY_L, 0}, "look through the selected light, and back"},
    ActionInfo{Action::compare,
               "compare",
               {GLFW_KEY_V, 0},
               "write three pictures: as it is, shadows by reference, their difference x 4"},
    ActionInfo{Action::open, "open", {GLFW_KEY_O, GLFW_MOD_CONTROL}, "open another scene; or drop its file here"},
    ActionInfo{Action::gui, "gui", {GLFW_KEY_F1, 0}, "show and hide the panels"},
    ActionInfo{Action::help, "help", {GLFW_KEY_H, 0}, "this list"},
    ActionInfo{Action::graph, "graph", {GLFW_KEY_F2, 0}, "show and hide the frame's graph"},
    ActionInfo{Action::shaders, "shaders", {GLFW_KEY_F5, 0}, "compile the shaders again"},
    ActionInfo{Action::full_screen, "full_screen", {GLFW_KEY_F11, 0}, "full screen"},
    ActionInfo{
        Action::screenshot, "screenshot", {GLFW_KEY_F12, 0}, "write a screenshot as PNG and EXR, without panels"},
    ActionInfo{Action::undo, "undo", {GLFW_KEY_Z, GLFW_MOD_CONTROL}, "undo"},
    ActionInfo{Action::redo, "redo", {GLFW_KEY_Y, GLFW_MOD_CONTROL}, "redo"},
};

} // namespace

std::span<const ActionInfo> all_actions()
{
    return actions;
}

} // namespace atrium::app
