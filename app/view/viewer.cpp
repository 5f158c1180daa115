#include "app/view/viewer.hpp"

#include "app/gui/framing.hpp"
#include "app/gui/notice.hpp"
#include "app/gui/split_view.hpp"
#include "app/view/comparison.hpp"
#include "app/view/numbered_file.hpp"
#include "app/view/picking.hpp"
#include "app/view/scene_facts.hpp"
#include "app/view/screenshot.hpp"
#include "renderer/core/atomic_file.hpp"
#include "renderer/core/error.hpp"
#include "renderer/core/log.hpp"
#include "renderer/scene/default_camera.hpp"

#include <fmt/format.h>
#include <imgui/imgui.h>

#include <algorithm>
#include <chrono>
#include <utility>

namespace atrium::app {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int settle_frames = 3;  ///< of the interface after an event: hovers and layouts take two
constexpr double idle_wait = 0.5; ///< s, between looks at what has no events
constexpr double job_wait = 0.1;  ///< s, the same while there is work beside the window

double seconds_since(Clock::time_point start)
{
    return std::chrono::duration<double>(Clock::now() - start).count();
}

} // namespace

Viewer::Viewer(Window& window, Engine& engine, SceneOpener& opener, const ViewerStart& start)
    : window_(window), engine_(engine), opener_(opener), gui_(window, engine), pictures_(engine, model_, facts_),
      keys_(start.keys), reload_(engine, start.shaders), continuous_(start.continuous), recent_(start.recent),
      bookmarks_(start.bookmarks)
{
    facts_.device = engine.device().report().name;
    facts_.is_cpu = engine.device().report().is_cpu;
    facts_.insets = Gui::insets();
    facts_.buffer_value = [this](std::size_t buffer, vec2 at) { return engine_.buffer_value(buffer, at); };
    panels_.keys = keys_.help();
    panels_.message = start.message;
    panels_.settings_file = start.settings_file;
    begin(start.scene);
}

void Viewer::begin(const SceneStart& start)
{
    const std::span<const Material> materials = engine_.scene().materials();
    model_.scene_materials.assign(materials.begin(), materials.end());
    model_.materials = spelled_out(materials, start.frame.materials);
    model_.selected_material.reset();
    model_.reset(start.frame.settings, start.frame.camera, start.frame.lights);
    model_.scene_name = start.file.filename().string();
    model_.scene_file = start.scene_file;
    model_.paths = start.scene_file.paths;
    model_.bookmarks = bookmarks_[start.file.string()];
    remember_scene(recent_, start.file);
    model_.split.reset();
    panels_.camera.reset();
    panels_.path = {};
    panels_.materials = {};
    facts_.scene = start.facts;
    light_view_ = {};
    flight_ = gui::FlyCamera(engine_.scene().bounds().diagonal());
    handles_ = {};
    if (const std::string& note = engine_.scene().note(); !note.empty())
        panels_.message += panels_.message.empty() ? note : "\n" + note;
    pictures_.begin(start.frame);
    new_scene_ = true;
}

BookmarksOfScenes Viewer::bookmarks() const
{
    BookmarksOfScenes all = bookmarks_;
    all[scene().string()] = model_.bookmarks;
    return all;
}

void Viewer::open(const std::filesystem::path& file)
{
    panels_.message.clear();
    try {
        opener_.open(file);
    } catch (const Error& error) {
        refuse(error);
    }
}

bool Viewer::follow_opener()
{
    if (const auto dropped = window_.take_dropped()) open(*dropped);
    try {
        if (const auto start = opener_.update()) {
            bookmarks_ = bookmarks(); // of the scene that goes
            begin(*start);
        }
    } catch (const Error& error) {
        find_images(facts_.scene, engine_.scene());
        refuse(error);
    }
    const std::string progress = opener_.progress();
    return std::exchange(progress_, progress) != progress;
}

void Viewer::refuse(const Error& error)
{
    panels_.message = error.text();
    show_gui_ = true;
    log_warning(error.text());
}

void Viewer::run()
{
    Clock::time_point last = Clock::now();
    int unsettled = settle_frames;
    bool moving = false, seen = false, hidden = false;
    while (!window_.closed()) {
        const bool busy = !hidden && (continuous_ || moving || unsettled > 0 || pictures_.unfinished());
        const double wait = reload_.busy() || opener_.busy() ? job_wait : idle_wait;
        if (window_.poll(busy ? 0 : wait)) unsettled = settle_frames;
        if (follow_opener()) unsettled = settle_frames;
        if (reload_.update()) {
            pictures_.invalidate();
            unsettled = settle_frames;
        }
        const double passed = std::min(seconds_since(last), 0.1); // after a wait nothing has moved for so long
        last = Clock::now();
        const uvec2 pixels = prepare_window();
        hidden = pixels.x == 0; // minimised
        if (hidden) continue;
        if (!busy && unsettled == 0) continue;

        handle_keys(gui_.begin(pixels), pixels);
        const bool on_handle = show_gui_ && handles_.update(model_, gui_.scale());
        moving = fly(passed, on_handle);
        if (!on_handle) pick_material(pixels);
        draw_interface(pixels);
        const UiDraws interface = gui_.end();
        facts_.interface_ms = 1000 * seconds_since(last);
        const float divider = model_.split ? model_.split->divider * static_cast<float>(pixels.x) : 0;
        draw_scene(pixels, moving || ImGui::IsAnyItemActive() || handles_.holds());
        const ShowResult shown = engine_.show(interface, divider);
        facts_.interface_ms += shown.interface_ms;
        facts_.picture_ms = shown.picture_ms;
        facts_.costs.shown(facts_.interface_ms);
        if (!shown.done || !window_.input().empty()) unsettled = settle_frames;
        if (!seen) window_.show(); // with the first picture in it
        seen = true;
        if (std::exchange(new_scene_, false)) window_.set_title("Atrium: " + model_.scene_name);
        unsettled = std::max(unsettled - 1, 0);
    }
}

uvec2 Viewer::prepare_window()
{
    const gpu::PresentMode wanted = model_.settings.view.vsync;
    const uvec2 pixels = engine_.window_size(window_.pixels(), wanted);
    if (std::exchange(vsync_, wanted) != wanted && !engine_.has_wanted_mode())
        panels_.message =
            fmt::format("this window does not offer view.vsync = {}: it is on", model_.list.find("view.vsync")->get());
    return pixels;
}

bool Viewer::fly(double seconds, bool on_handle)
{
    const ImGuiIO& io = ImGui::GetIO();
    gui::FlyInput input;
    const auto held = [&](Action action) { return window_.held(keys_.key_of(action).key) ? 1.0f : 0.0f; };
    const float rate = 1.2f * static_cast<float>(seconds); // radians a second
    // Asked even while a text is typed, or they would count as held after it.
    const vec3 move(held(Action::right) - held(Action::left), held(Action::up) - held(Action::down),
                    held(Action::forward) - held(Action::back));
    const vec2 turn(held(Action::turn_right) - held(Action::turn_left),
                    held(Action::turn_up) - held(Action::turn_down));
    if (!io.WantCaptureKeyboard && !io.KeyCtrl) {
        input.move = move;
        input.turn = rate * turn;
        input.fast = io.KeyShift;
    }
    const bool drag = !io.WantCaptureMouse && !on_handle &&
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
    panels_.dragging = (drag && io.KeyCtrl) || handles_.holds();
    if (!io.WantCaptureMouse) input.wheel = io.MouseWheel;
    const bool flown = flight_.advance(model_.camera, input, seconds);
    if (flown) panels_.path.player.playing = false;
    return gui::play_path(model_, panels_.path, seconds) || flown;
}

void Viewer::drag_light(vec2 pixels, bool along)
{
    if (!model_.selected) return;
    Light light = model_.lights[*model_.selected];
    if (light.type == LightType::sun) return; // which stands nowhere
    const gui::Projection view(model_.camera, vec2(ImGui::GetIO().DisplaySize.x, ImGui::GetIO().DisplaySize.y));
    light.position +=
        along ? -view.pixel_size(light.position) * pixels.y * view.forward : view.in_view_plane(light.position, pixels);
    if (const auto refused = model_.set_light(*model_.selected, light)) panels_.message = *refused;
}

void Viewer::handle_keys(const std::vector<KeyPress>& presses, uvec2 pixels)
{
    for (const KeyPress& press : presses) {
        if (ImGui::GetIO().WantTextInput || open_dialog_.is_open()) continue;
        if (const gui::SettingStep* step = keys_.step_of(press)) {
            gui::take_step(model_.list, *step);
            model_.checkpoint();
        }
        act(keys_.action_of(press), pixels);
    }
}

void Viewer::act(Action action, uvec2 pixels)
{
    switch (action) {
    case Action::gui:
        show_gui_ = !show_gui_;
        break;
    case Action::help:
        show_gui_ = true;
        panels_.show = gui::Tab::help;
        break;
    case Action::graph:
        panels_.graph.open = !show_gui_ || !panels_.graph.open;
        show_gui_ = true;
        break;
    case Action::full_screen:
        window_.toggle_full_screen();
        break;
    case Action::shaders:
        reload_.compile_all();
        break;
    case Action::screenshot:
        write_pictures(write_screenshot, pixels);
        break;
    case Action::compare:
        write_pictures(write_comparison, pixels);
        break;
    case Action::open:
        open_dialog_.show();
        break;
    case Action::frame:
        frame_selection(pixels);
        break;
    case Action::light_view:
        look_through_light();
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
    default:
        break;
    }
}

void Viewer::frame_selection(uvec2 pixels)
{
    panels_.path.player.playing = false;
    const Bounds& bounds = engine_.scene().bounds();
    const float aspect = static_cast<float>(pixels.x) / static_cast<float>(pixels.y);
    Camera& camera = model_.camera;
    camera = model_.selected ? gui::frame_light(camera, model_.lights[*model_.selected], bounds.diagonal())
                             : frame_bounds(bounds, camera.fov, aspect);
}

void Viewer::look_through_light()
{
    panels_.path.player.playing = false;
    const Light* light = model_.selected ? &model_.lights[*model_.selected] : nullptr;
    if (!light_view_.toggle(model_.camera, light, engine_.scene().bounds()))
        panels_.message = "no light is selected to look through: click on the mark of one, or its line in the list";
}

void Viewer::pick_material(uvec2 pixels)
{
    const ImGuiIO& io = ImGui::GetIO();
    constexpr float slip = 4; // pixels that a click may move
    const float moved = std::sqrt(io.MouseDragMaxDistanceSqr[ImGuiMouseButton_Left]);
    if (!show_gui_ || !panels_.materials.open || io.WantCaptureMouse) return;
    if (!ImGui::IsMouseReleased(ImGuiMouseButton_Left) || moved > slip * gui_.scale()) return;
    const vec2 mouse(io.MousePos.x, io.MousePos.y);
    try {
        model_.selected_material =
            material_at(engine_, pictures_.wanted_picture(pixels), uvec2(glm::max(mouse, vec2(0))));
        panels_.materials.filter.clear();
        panels_.materials.scroll = true;
    } catch (const Error& error) {
        panels_.message = error.text();
    }
}

std::optional<std::uint32_t> Viewer::outlined() const
{
    if (!show_gui_ || !panels_.materials.open || !model_.selected_material) return std::nullopt;
    return static_cast<std::uint32_t>(*model_.selected_material);
}

void Viewer::draw_interface(uvec2 pixels)
{
    facts_.size = pixels;
    facts_.heaps.clear();
    for (const gpu::HeapUse& heap : engine_.device().memory_by_heap())
        facts_.heaps.push_back({heap.device_local, heap.bytes, heap.budget});
    panels_.scale = gui_.scale();
    if (show_gui_) {
        gui::draw_panels(model_, facts_, panels_);
        gui::draw_buffers(model_, facts_, panels_.scale);
        gui::draw_divider(model_, facts_, panels_.scale);
        gui::draw_graph_window(model_, facts_.graph, facts_.insets, panels_.graph, panels_.scale);
    }
    draw_notices();
    if (const auto file = open_dialog_.draw(recent_, gui_.scale())) open(*file);
    if (std::exchange(panels_.frame, false)) frame_selection(pixels);
    if (const auto file = std::exchange(panels_.save_costs, std::nullopt)) write_costs(*file);
}

void Viewer::draw_notices()
{
    if (!reload_.problem().empty())
        gui::draw_notice(gui::Corner::bottom_right, reload_.problem(), nullptr, gui_.scale());
    if (progress_.empty()) return;
    const char* button = opener_.baking() ? "Cancel" : nullptr;
    if (gui::draw_notice(gui::Corner::top_right, progress_, button, gui_.scale())) opener_.cancel();
}

void Viewer::draw_scene(uvec2 pixels, bool moving)
{
    if (const auto refused = pictures_.draw({pixels, gui_.scale(), show_gui_, outlined(), moving, continuous_}))
        panels_.message = *refused;
}

void Viewer::write_pictures(std::string (*write)(Engine&, FrameRequest), uvec2 pixels)
{
    try {
        panels_.message = write(engine_, pictures_.wanted_picture(pixels));
    } catch (const Error& error) {
        panels_.message = error.text();
    }
}

void Viewer::write_costs(gui::CostFile kind)
{
    const bool trace = kind == gui::CostFile::trace;
    const char* ending = trace ? ".trace.json" : ".costs.json";
    const std::string file = unused_name({ending}) + ending;
    try {
        write_text_file(file, trace ? facts_.costs.to_trace(facts_.device) : facts_.costs.to_json(facts_.device));
        panels_.message = fmt::format("{} written{}", file, trace ? "; ui.perfetto.dev opens it" : "");
    } catch (const Error& error) {
        panels_.message = error.text();
    }
}

} // namespace atrium::app
