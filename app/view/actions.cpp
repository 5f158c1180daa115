#include "app/view/actions.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>

namespace atrium::app {
namespace {

struct Binding {
    Action action;
    int key, mods;
    const char* label;
    const char* help;
};

constexpr std::array bindings{
    Binding{Action::soft_shadows, GLFW_KEY_P, 0, "P", "soft shadows on and off"},
    Binding{Action::softer, GLFW_KEY_PAGE_UP, 0, "Page up", "softer shadows"},
    Binding{Action::harder, GLFW_KEY_PAGE_DOWN, 0, "Page down", "harder shadows"},
    Binding{Action::ao_method, GLFW_KEY_O, 0, "O", "next method of ambient occlusion"},
    Binding{Action::normal_mapping, GLFW_KEY_N, 0, "N", "normal mapping on and off"},
    Binding{Action::previous_buffer, GLFW_KEY_COMMA, 0, ",", "previous buffer in place of the picture"},
    Binding{Action::next_buffer, GLFW_KEY_PERIOD, 0, ".", "next buffer; after the last, the picture"},
    Binding{Action::gui, GLFW_KEY_F1, 0, "F1", "show and hide the panels"},
    Binding{Action::full_screen, GLFW_KEY_F11, 0, "F11", "full screen"},
    Binding{Action::screenshot, GLFW_KEY_F12, 0, "F12", "write a screenshot, without panels"},
    Binding{Action::undo, GLFW_KEY_Z, GLFW_MOD_CONTROL, "Ctrl+Z", "undo"},
    Binding{Action::redo, GLFW_KEY_Y, GLFW_MOD_CONTROL, "Ctrl+Y", "redo"},
};

} // namespace

Action action_of(const KeyPress& press)
{
    constexpr int counted = GLFW_MOD_CONTROL | GLFW_MOD_ALT | GLFW_MOD_SUPER;
    const auto found = std::find_if(bindings.begin(), bindings.end(), [&](const Binding& b) {
        return b.key == press.key && b.mods == (press.mods & counted);
    });
    return found == bindings.end() ? Action::none : found->action;
}

std::vector<gui::KeyHelp> key_table()
{
    std::vector<gui::KeyHelp> out{
        {"W A S D", "move"},
        {"Q E", "down and up"},
        {"Shift", "faster"},
        {"Wheel", "speed"},
        {"Arrows, drag", "turn the view"},
        {"Ctrl+drag", "move the selected light (Shift: along the view)"},
    };
    for (const Binding& b : bindings) out.push_back({b.label, b.help});
    return out;
}

void step_setting(const SettingList& list, Action action)
{
    const auto set = [&](const char* key, const std::string& text) {
        if (const Setting* setting = list.find(key)) static_cast<void>(setting->set_text(text));
    };
    const auto scaled = [&](const char* key, float factor) {
        float value = 0;
        const std::string text = list.find(key)->get();
        std::from_chars(text.data(), text.data() + text.size(), value);
        set(key, fmt::format("{}", std::clamp(value * factor, 0.1f, 10.0f)));
    };
    const auto next = [&](const char* key) {
        const Setting& s = *list.find(key);
        const auto at = std::find(s.values.begin(), s.values.end(), s.get());
        set(key, at + 1 == s.values.end() ? s.values.front() : *(at + 1));
    };
    const auto flip = [&](const char* key, const char* on, const char* off) {
        set(key, list.find(key)->get() == on ? off : on);
    };
    switch (action) {
    case Action::soft_shadows:
        return flip("shadow.filter", "pcss", "hard");
    case Action::softer:
        return scaled("shadow.softness", 1.1f);
    case Action::harder:
        return scaled("shadow.softness", 1 / 1.1f);
    case Action::ao_method:
        return next("ao.method");
    case Action::normal_mapping:
        return flip("normal_mapping", "on", "off");
    default:
        return;
    }
}

} // namespace atrium::app
