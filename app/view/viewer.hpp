#pragma once
// The window's loop: events, flying, the interface, and the frames that are drawn when something changed.

#include "app/gui/fly_camera.hpp"
#include "app/gui/light_handles.hpp"
#include "app/gui/light_view.hpp"
#include "app/gui/open_dialog.hpp"
#include "app/gui/panels.hpp"
#include "app/gui/view_model.hpp"
#include "app/view/gui.hpp"
#include "app/view/key_bindings.hpp"
#include "app/view/scene_opener.hpp"
#include "app/view/scene_pictures.hpp"
#include "app/view/shader_reload.hpp"
#include "renderer/core/error.hpp"

#include <array>
#include <chrono>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace atrium::app {

using BookmarksOfScenes = std::map<std::string, gui::Bookmarks>; ///< by scene_path()

/// What a window begins with.
struct ViewerStart {
    SceneStart scene;
    BookmarksOfScenes bookmarks;
    std::vector<std::filesystem::path> recent; ///< scenes, newest first
    std::string settings_file;
    KeyBindings keys;
    std::string message;           ///< shown until it is put away
    bool continuous = false;       ///< draw also when nothing changes
    std::filesystem::path shaders; ///< sources that are compiled again when they change; empty: none
};

class Viewer {
public:
    Viewer(Window& window, Engine& engine, SceneOpener& opener, const ViewerStart& start);
    /// Until the window is closed.
    void run();
    [[nodiscard]] const Camera& camera() const { return model_.camera; }
    /// The scene that it shows.
    [[nodiscard]] const std::filesystem::path& scene() const { return recent_.front(); }
    /// That one and those before, newest first.
    [[nodiscard]] const std::vector<std::filesystem::path>& recent() const { return recent_; }
    [[nodiscard]] BookmarksOfScenes bookmarks() const;
    [[nodiscard]] const std::string& settings_file() const { return panels_.settings_file; }

private:
    /// With the scene that the engine has now.
    void begin(const SceneStart& start);
    void open(const std::filesystem::path& file);
    void refuse(const Error& error); ///< shows it, and says it in the log
    /// Begins with another scene when it has come. True where there is something new to be shown.
    [[nodiscard]] bool follow_opener();
    /// `on_handle`: the mouse is busy with a light.
    [[nodiscard]] bool fly(double seconds, bool on_handle);
    /// The selected light follows the mouse: in the view's plane, or (`along`) nearer and farther.
    void drag_light(vec2 pixels, bool along);
    void handle_keys(const std::vector<KeyPress>& presses, uvec2 pixels);
    void act(Action action, uvec2 pixels);
    /// The window's pixels, made ready to be drawn to; tells where it lacks a mode that is wanted.
    [[nodiscard]] uvec2 prepare_window();
    /// The selected light, or the whole scene, into the middle of the picture.
    void frame_selection(uvec2 pixels);
    /// Through the selected light, or back.
    void look_through_light();
    /// A click in the scene selects the material there, where the tab of materials is open.
    void pick_material(uvec2 pixels);
    /// The material with a line around it.
    [[nodiscard]] std::optional<std::uint32_t> outlined() const;
    void draw_interface(uvec2 pixels);
    void draw_notices();
    /// Lets `write` draw what the model says, as `render` draws it, into files that it names in its answer.
    void write_pictures(std::string (*write)(Engine&, FrameRequest), uvec2 pixels);
    void write_costs(gui::CostFile kind);
    void draw_scene(uvec2 pixels, bool moving);

    Window& window_;
    Engine& engine_;
    SceneOpener& opener_;
    Gui gui_;
    gui::ViewModel model_;
    gui::PanelState panels_;
    gui::FrameFacts facts_;
    ScenePictures pictures_;
    gui::FlyCamera flight_;
    gui::LightHandles handles_;
    gui::LightView light_view_;
    gui::OpenDialog open_dialog_;
    KeyBindings keys_;
    ShaderReload reload_;
    gpu::PresentMode vsync_ = gpu::PresentMode::on; ///< that was last asked for
    bool continuous_, show_gui_ = true;
    std::vector<std::filesystem::path> recent_; ///< scenes, newest first
    BookmarksOfScenes bookmarks_;               ///< as they were when their scenes were left
    bool new_scene_ = false;                    ///< the window's title waits for its first picture
    std::string progress_;                      ///< of the opener, as it is shown
    std::optional<vec2> drag_from_;
};

} // namespace atrium::app
