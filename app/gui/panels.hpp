#pragma once
// The panel on the left of the window: settings, lights, camera, costs, help.

#include "app/gui/cost_history.hpp"
#include "app/gui/path_panel.hpp"
#include "app/gui/setting_widgets.hpp"
#include "app/gui/view_model.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace atrium::gui {

/// A heap of device memory, in bytes.
struct HeapFacts {
    bool on_device = false;
    std::uint64_t used = 0, budget = 0;
};

/// What the last frame was, and what those before took.
struct FrameFacts {
    std::string device;
    bool is_cpu = false; ///< settings then have a CPU device's defaults
    uvec2 size{0};
    std::uint64_t triangles = 0;
    double interface_ms = 0; ///< what this panel and the rest around the picture take
    std::vector<HeapFacts> heaps;
    CostHistory costs;
};

/// One line of the help.
struct KeyHelp {
    std::string keys, act;
    std::string name; ///< in a file of keys; empty: it cannot be changed
};

/// A file of costs that is wished for: cost_history.hpp.
enum class CostFile { json, trace };

enum class Tab { settings, lights, camera, costs, help };

/// What the panel remembers between frames.
struct PanelState {
    float scale = 1;                             ///< of everything, as apply_style() was given
    std::vector<KeyHelp> keys;                   ///< the help
    std::string message;                         ///< shown on top until it is put away: what was refused, and why
    std::optional<Tab> show;                     ///< turn to this tab in the next frame
    std::string filter;                          ///< of the settings
    std::string settings_file = "settings.toml"; ///< to save into and load from
    std::string new_bookmark;                    ///< name that is being typed
    std::optional<std::size_t> camera;           ///< selected of the scene's cameras and, after them, the bookmarks
    PathPanel path;                              ///< of cameras
    bool frame = false;                          ///< wished for in this frame: to see the selected light, or the scene
    std::optional<CostFile> save_costs;          ///< wished for in this frame
    bool dragging = false;                       ///< something beside the panels is in the middle of an edit
    Headings headings = Headings::as_they_are;   ///< of the settings, in the next frame that shows them
};

/// Draws them all. At most 360 x scale pixels wide and within the display. Completes edits: checkpoint() where nothing
/// is being dragged or typed.
void draw_panels(ViewModel& model, const FrameFacts& facts, PanelState& state);

/// One tab, for draw_panels().
void draw_camera_tab(ViewModel& model, PanelState& state, bool is_cpu);
void draw_light_tab(ViewModel& model, PanelState& state, bool is_cpu);
void draw_cost_tab(const FrameFacts& facts, PanelState& state);

/// "--eye X,Y,Z --target X,Y,Z --fov F", from which the command line makes the same camera.
[[nodiscard]] std::string camera_options(const Camera& camera);

} // namespace atrium::gui
