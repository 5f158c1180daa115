#pragma once
// What the window shows and edits, and the way back from each edit. Knows nothing of how it is drawn.

#include "app/gui/bookmarks.hpp"
#include "renderer/scene/camera.hpp"
#include "renderer/scene/light.hpp"
#include "renderer/scene/scene_file.hpp"
#include "renderer/settings.hpp"

#include <cstddef>
#include <deque>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace atrium::gui {

/// A buffer shown small at the bottom of the view.
struct PinnedBuffer {
    std::string name; ///< of its AOV
    BufferViewSettings view;
};

/// Settings that are drawn beside the model's own, left of a divider.
struct Split {
    Settings other;
    float divider = 0.5f; ///< share of the window's width
};

/// Everything is public that widgets write to; whoever edits calls checkpoint() when an edit is complete.
class ViewModel {
public:
    ViewModel();
    ViewModel(const ViewModel&) = delete; // `list` points into `settings`
    ViewModel& operator=(const ViewModel&) = delete;

    Settings settings;
    SettingList list; ///< bound to `settings`; its defaults are those of Settings
    Camera camera;
    std::vector<Light> lights;                    ///< with unique names; ids are unique and never reused
    std::optional<std::size_t> selected;          ///< of `lights`
    std::optional<Split> split;                   ///< no part of undo and redo
    std::vector<PinnedBuffer> pinned;             ///< at most max_insets, no name twice
    std::vector<Material> scene_materials;        ///< as the scene has them
    std::vector<MaterialOverride> materials;      ///< what is changed of them, one for each name
    std::optional<std::size_t> selected_material; ///< of `scene_materials`
    std::string scene_name;
    Bookmarks bookmarks;
    CameraPaths paths;
    SceneFile scene_file; ///< as it was opened: its bake, instances and cameras are not edited

    /// Begins anew, without anything to undo. Lights without a name are given theirs; throws Error(usage) for names
    /// that name_lights() refuses, and changes nothing then.
    void reset(const Settings& new_settings, const Camera& new_camera, std::vector<Light> new_lights);
    /// The camera of the last reset().
    [[nodiscard]] const Camera& start_camera() const { return start_camera_; }

    // Undo and redo: of settings, lights and materials. The camera is not part of it: one flies back.

    /// Makes what has changed since the last one a step to undo; nothing, when nothing has. Called after each edit, or
    /// each frame in which nobody is in the middle of one: a drag is then one step.
    void checkpoint();
    /// Whether there is a step, an edit without its checkpoint included.
    [[nodiscard]] bool can_undo() const;
    [[nodiscard]] bool can_redo() const;
    void undo(); ///< nothing where !can_undo()
    void redo(); ///< nothing where !can_redo()

    /// Sets what a preset or a file says and leaves the rest. All of it or, with what is wrong as the answer, nothing.
    [[nodiscard]] std::optional<std::string> apply_texts(std::span<const SettingText> texts);
    /// All settings as the description has them, those of a CPU device where it is one.
    void apply_defaults(bool is_cpu);
    /// What differs from the defaults, and of the scene's materials, as a file for --config.
    [[nodiscard]] std::string settings_toml() const;
    /// Writes that file. Throws Error(environment).
    void save_settings(const std::filesystem::path& file) const;
    /// Makes settings and materials what a file for --config says, and the defaults and the scene's where it says
    /// nothing. All of it or, with what is wrong as the answer, nothing.
    [[nodiscard]] std::optional<std::string> load_settings(const std::filesystem::path& file);

    /// Writes the scene as a file that `render` and `view` take. Its first camera, called "window", is the present one;
    /// it replaces one of that name. Throws Error(environment).
    void save_scene(const std::filesystem::path& file) const;

    // Lights. At most max_lights.

    /// A light of the type at `position`, named and selected; false when there is room for no more.
    bool add_light(LightType type, const vec3& position);
    /// The selected light once more, the copy selected; false without a selection or room.
    bool duplicate_selected();
    /// Selects the one that takes its place.
    void remove_selected();
    /// Replaces a light, unless it breaks a rule of lights: the answer says which. An empty name gets a free one.
    [[nodiscard]] std::optional<std::string> set_light(std::size_t index, Light light);

    // Buffers: the AOVs that can be shown.

    std::vector<std::string> graph_images; ///< "graph.NAME" of each that the last frame had
    /// Those that the settings and lights offer, without those of techniques that are off, and graph_images.
    [[nodiscard]] std::vector<std::string> offered_buffers() const;
    /// The one in place of the picture, by its light's name; empty: it is the picture, or no buffer has that name.
    [[nodiscard]] std::string shown_buffer() const;
    /// Shows the next one in place of the picture, or the one before; the picture itself is one of them.
    void step_buffer(int step);
    /// Shows one small, or no longer; nothing where there is room for no more.
    void toggle_pin(const std::string& name);
    /// Forgets what a light that is no longer there was shown of.
    void drop_lost_buffers();

    // Materials.

    /// As it is shown.
    [[nodiscard]] Material material(std::size_t index) const;
    /// Shows all materials of its name with what differs from the scene's.
    void set_material(std::size_t index, const Material& wanted);

private:
    struct Snapshot {
        Settings settings;
        std::vector<Light> lights;
        std::vector<MaterialOverride> materials;
    };
    [[nodiscard]] Snapshot now() const;
    /// Whether something differs from the last checkpoint, undo or redo.
    [[nodiscard]] bool edited() const;
    void restore(const Snapshot& snapshot);
    void select(std::size_t index);
    [[nodiscard]] std::string free_light_name() const;
    /// What is shown of a light is shown under its new name.
    void rename_buffers(std::size_t light, const std::string& name);

    Camera start_camera_;
    std::uint32_t next_light_id_ = 1;
    Snapshot last_; ///< as of the last checkpoint, undo or redo
    std::deque<Snapshot> past_;
    std::vector<Snapshot> future_; ///< the next one to redo at the end
};

} // namespace atrium::gui
