#include "app/view/viewer.hpp"

#include "app/config.hpp"
#include "app/gui/inset_layout.hpp"
#include "app/view/actions.hpp"
#include "renderer/core/error.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <imgui/imgui.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>

namespace atrium::app {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double moving_goal_ms = 60; ///< a frame while something moves
constexpr int settle_frames = 3;      ///< of the interface after an event: hovers and layouts take two
constexpr double idle_wait = 0.5;     ///< s, between looks at what has no events

double seconds_since(Clock::time_point start)
{
    return std::chrono::duration<double>(Clock::now() - start).count();
}

} // namespace

void MovingScale::measured(float share, double ms)
{
    const double full = ms / std::max(static_cast<double>(share * share), 0.01);
    full_ms_ = full_ms_ == 0 ? full : 0.5 * (full_ms_ + full);
}

float MovingScale::choose(double goal_ms) const
{
    if (full_ms_ <= goal_ms) return 1;
    const double share = std::sqrt(goal_ms / full_ms_);
    return static_cast<float>(std::clamp(std::floor(share * 20) / 20, 0.2, 1.0));
}

Viewer::Viewer(Window& window, Engine& engine, const FrameRequest& start, const std::string& scene, bool continuous)
    : window_(window), engine_(engine), gui_(window, engine), flight_(engine.scene().bounds().diagonal()),
      request_(start), continuous_(continuous)
{
    model_.reset(start.settings, start.camera, start.lights);
    model_.scene_name = scene;
    facts_.device = engine.device().report().name;
    facts_.is_cpu = engine.device().report().is_cpu;
    facts_.insets = Gui::insets();
    facts_.buffer_value = [this](std::size_t buffer, vec2 at) { return engine_.buffer_value(buffer, at); };
    panels_.keys = key_table();
    window.set_title("Atrium: " + scene);
}

void Viewer::run()
{
    Clock::time_point last = Clock::now();
    int unsettled = settle_frames;
    bool moving = false, seen = false;
    while (!window_.closed()) {
        const bool busy = continuous_ || moving || unsettled > 0 || drawn_share_ < 1;
        if (window_.poll(busy ? 0 : idle_wait)) unsettled = settle_frames;
        const double passed = std::min(seconds_since(last), 0.1); // after a wait nothing has moved for so long
        last = Clock::now();
        const uvec2 pixels = engine_.window_size(window_.pixels(), gpu::PresentMode::vsync);
        if (pixels.x == 0) continue; // minimised
        if (!busy && unsettled == 0) continue;

        gui_.begin(pixels);
        handle_keys(pixels);
        moving = fly(passed);
        draw_interface(pixels);
        const UiDraws interface = gui_.end();
        draw_scene(pixels, moving || ImGui::IsAnyItemActive());
        if (!engine_.show(interface)) unsettled = settle_frames;
        if (!seen) window_.show(); // with the first picture in it
        seen = true;
        unsettled = std::max(unsettled - 1, 0);
    }
}

bool Viewer::fly(double seconds)
{
    const ImGuiIO& io = ImGui::GetIO();
    gui::FlyInput input;
    const auto axis = [&](int positive, int negative) {
        return (window_.held(positive) ? 1.0f : 0.0f) - (window_.held(negative) ? 1.0f : 0.0f);
    };
    if (!io.WantCaptureKeyboard && !io.KeyCtrl) {
        input.move = {axis(GLFW_KEY_D, GLFW_KEY_A), axis(GLFW_KEY_E, GLFW_KEY_Q), axis(GLFW_KEY_W, GLFW_KEY_S)};
        const float rate = 1.2f * static_cast<float>(seconds); // radians a second
        input.turn = rate * vec2(axis(GLFW_KEY_RIGHT, GLFW_KEY_LEFT), axis(GLFW_KEY_UP, GLFW_KEY_DOWN));
        input.fast = io.KeyShift;
    }
    const bool drag = !io.WantCaptureMouse &&
                      (ImGui::IsMouseDown(ImGuiMouseButton_Right) || ImGui::IsMouseDown(ImGuiMouseButton_Left));
    const vec2 mouse(io.MousePos.x, io.MousePos.y);
    if (drag && drag_from_ && io.KeyCtrl) {
        drag_light(mouse - *drag_from_, io.KeyShift);
    } else if (drag && drag_from_) {
        // Across the picture's height the view turns by what it spans.
        const float per_pixel = glm::radians(model_.camera.fov) / io.DisplaySize.y;
        input.turn += per_pixel * vec2(mouse.x - drag_from_->x, drag_from_->y - mouse.y);
    }
    drag_from_ = drag ? std::optional(mouse) : std::nullopt;
    panels_.dragging = drag && io.KeyCtrl;
    if (!io.WantCaptureMouse) input.wheel = io.MouseWheel;
    return flight_.advance(model_.camera, input, seconds);
}

void Viewer::drag_light(vec2 pixels, bool along)
{
    if (!model_.selected) return;
    Light light = model_.lights[*model_.selected];
    if (light.type == LightType::sun) return; // which stands nowhere
    const mat4 view = view_from_world(model_.camera);
    const auto axis = [&](int row) { return vec3(view[0][row], view[1][row], view[2][row]); };
    const float distance = std::max(-glm::dot(axis(2), light.position - model_.camera.eye), 0.1f);
    const float per_pixel =
        2 * distance * std::tan(glm::radians(0.5f * model_.camera.fov)) / ImGui::GetIO().DisplaySize.y;
    light.position += per_pixel * (along ? axis(2) * pixels.y : axis(0) * pixels.x - axis(1) * pixels.y);
    if (const auto refused = model_.set_light(*model_.selected, light)) panels_.message = *refused;
}

void Viewer::handle_keys(uvec2 pixels)
{
    for (const KeyPress& press : window_.take_presses()) {
        if (ImGui::GetIO().WantTextInput) continue;
        switch (action_of(press)) {
        case Action::gui:
            show_gui_ = !show_gui_;
            break;
        case Action::full_screen:
            window_.toggle_full_screen();
            break;
        case Action::screenshot:
            write_screenshot(pixels);
            break;
        case Action::undo:
            model_.undo();
            break;
        case Action::redo:
            model_.redo();
            break;
        case Action::previous_buffer:
            model_.step_buffer(-1);
            model_.checkpoint();
            break;
        case Action::next_buffer:
            model_.step_buffer(1);
            model_.checkpoint();
            break;
        case Action::soft_shadows:
        case Action::ao_method:
        case Action::normal_mapping:
        case Action::softer:
        case Action::harder:
            step_setting(model_.list, action_of(press));
            model_.checkpoint();
            break;
        case Action::none:
            break;
        }
    }
}

void Viewer::draw_interface(uvec2 pixels)
{
    facts_.size = pixels;
    facts_.memory_bytes = engine_.device().memory_in_use();
    panels_.scale = gui_.scale();
    if (!show_gui_) return;
    gui::draw_panels(model_, facts_, panels_);
    gui::draw_buffers(model_, facts_, panels_.scale);
}

FrameRequest Viewer::wanted_frame(uvec2 size) const
{
    FrameRequest wanted = request_;
    wanted.settings = model_.settings;
    wanted.camera = wanted.previous_camera = model_.camera;
    wanted.lights = model_.lights;
    wanted.size = size;
    return wanted;
}

Insets Viewer::wanted_insets(uvec2 pixels) const
{
    Insets wanted;
    if (!show_gui_) return wanted;
    wanted.size = gui::lay_out_insets(pixels, gui_.scale(), model_.pinned.size()).image;
    for (const gui::PinnedBuffer& p : model_.pinned)
        wanted.buffers.push_back({parse_aov(p.name, model_.lights), p.view});
    return wanted;
}

std::string Viewer::state_text(uvec2 pixels) const
{
    std::string text;
    for (const Inset& inset : wanted_insets(pixels).buffers) {
        BufferViewSettings view = inset.view;
        SettingList keys;
        describe(keys, view);
        text += fmt::format("{} {}", inset.aov.info->name, inset.aov.light);
        for (const Setting& key : keys.all()) text += key.get();
    }
    for (const auto& [key, value] : describe_frame(wanted_frame({16, 9}), 0)) text += key + value;
    return text;
}

void Viewer::write_screenshot(uvec2 pixels)
{
    FrameRequest wanted = wanted_frame(pixels);
    wanted.want_picture = true;
    wanted.keep_picture = wanted.remember = wanted.keep_buffers = false;
    wanted.insets = {};
    std::filesystem::path file;
    for (int i = 0; file.empty() || std::filesystem::exists(file); ++i) file = fmt::format("atrium.{:04}.png", i);
    try {
        write_png(file, engine_.render(wanted).picture, describe_frame(wanted, 0));
        panels_.message = fmt::format("{} written; --config {} draws it again", file.string(), file.string());
    } catch (const Error& error) {
        panels_.message = error.text();
    }
}

void Viewer::draw_scene(uvec2 pixels, bool moving)
{
    const std::string wanted = state_text(pixels);
    const bool same = wanted == drawn_ && pixels == drawn_pixels_;
    const float chosen = model_.settings.view.moving_scale;
    const float share = moving && !same ? (chosen > 0 ? chosen : moving_scale_.choose(moving_goal_ms)) : 1;
    if (same && drawn_share_ >= share && !continuous_) return;

    const Camera before = request_.camera;
    request_ = wanted_frame(glm::max(uvec2(share * vec2(pixels)), uvec2(16)));
    request_.previous_camera = before;
    request_.want_picture = request_.want_hdr = false;
    request_.keep_picture = true;
    request_.insets = wanted_insets(pixels);
    request_.keep_buffers = share == 1;
    request_.want_statistics = share == 1;
    request_.remember = share < 1; // what stands is drawn as `render` draws it, whatever was before
    const bool first = drawn_.empty();
    drawn_ = wanted;
    drawn_pixels_ = pixels;
    drawn_share_ = share;
    FrameResult frame;
    try {
        frame = engine_.render(request_);
    } catch (const Error& error) { // such as a view that does not exist: what was shown before stays
        if (first) throw;
        panels_.message = error.text();
        drawn_share_ = 1;
        return;
    }
    moving_scale_.measured(share, frame.record_ms + frame.stats.wall_ms);
    tell(frame);
}

void Viewer::tell(const FrameResult& frame)
{
    constexpr std::size_t remembered = 120;
    facts_.frame_ms = frame.record_ms + frame.stats.wall_ms;
    if (request_.want_statistics) facts_.triangles = frame.triangles;
    facts_.buffers.clear();
    const auto shown = [&](const std::string& name) {
        if (facts_.buffers.size() < frame.buffers.size()) {
            facts_.buffers.push_back({name, frame.buffers[facts_.buffers.size()]});
        }
    };
    if (!request_.settings.debug.view.empty()) shown(request_.settings.debug.view);
    for (const gui::PinnedBuffer& p : model_.pinned) shown(p.name);
    facts_.passes.clear();
    for (const graph::PassStats& p : frame.stats.passes) facts_.passes.push_back({p.name, p.gpu_ms, p.draws});
    facts_.history.resize(remembered);
    facts_.history[static_cast<std::size_t>(facts_.history_next)] = static_cast<float>(facts_.frame_ms);
    facts_.history_next = (facts_.history_next + 1) % static_cast<int>(remembered);
}

} // namespace atrium::app
