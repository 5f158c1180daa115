#pragma once
// The panel on the left of the window: settings, lights, buffers, camera, materials, costs, help.

#include "app/gui/cost_history.hpp"
#include "app/gui/graph_window.hpp"
#include "app/gui/material_panel.hpp"
#include "app/gui/path_panel.hpp"
#include "app/gui/setting_widgets.hpp"
#include "app/gui/view_model.hpp"
#include "renderer/graph_facts.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
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

/// A buffer that the last frame showed, and what is known of it.
struct ShownBuffer {
    std::string name;
    BufferFacts facts;
};

/// What the last frame was, and what those before took.
struct FrameFacts {
    std::string device;
    bool is_cpu = false; ///< settings then have a CPU device's defaults
    uvec2 size{0};
    std::uint64_t triangles = 0;
    double interface_ms = 0;         ///< what this panel and the rest around the picture take
    double picture_ms = 0;           ///< what bringing the picture into the window takes
    std::array<double, 2> side_ms{}; ///< of a split view's last full frames, left and right
    std::vector<HeapFacts> heaps;
    CostHistory costs;
    GraphFacts graph;
    std::vector<ShownBuffer> buffers; ///< the one in place of the picture, if any, then the pinned ones
    void* insets = nullptr;           ///< ImGui's name of the image in which the pinned ones stand side by side
    /// The channels of one of `buffers` at a point of it, 0 to 1; none while the camera moves.
    std::function<std::vector<float>(std::size_t buffer, vec2 at)> buffer_value;
    SceneFacts scene;
};

/// One line of the help.
struct KeyHelp {
    std::string keys, act;
    std::string name; ///< in a file of keys; empty: it cannot be changed
};

/// A file of costs that is wished for: cost_history.hpp.
enum class CostFile { json, trace };

enum class Tab { settings, lights, buffers, camera, materials, costs, help };

/// What the panel remembers between frames.
struct PanelState {
    float scale = 1;                             ///< of everything, as apply_style() was given
    std::vector<KeyHelp> keys;                   ///< the help
    std::string message;                         ///< shown at the foot until it is put away: what was refused, and why
    std::optional<Tab> show;                     ///< turn to this tab in the next frame
    std::string filter;                          ///< of the settings
    std::string buffer_filter;                   ///< of the list of buffers
    std::string settings_file = "settings.toml"; ///< to save into and load from
    std::string new_bookmark;                    ///< name that is being typed
    std::optional<std::size_t> camera;           ///< selected of the scene's cameras and, after them, the bookmarks
    PathPanel path;                              ///< of cameras
    GraphWindow graph;                           ///< of the frame
    bool frame = false;                          ///< wished for in this frame: to see the selected light, or the scene
    std::optional<CostFile> save_costs;          ///< wished for in this frame
    MaterialTab materials;
    bool dragging = false;                     ///< something beside the panels is in the middle of an edit
    Headings headings = Headings::as_they_are; ///< of the settings, in the next frame that shows them
};

// Pixels at scale 1, where the display has as many.
inline constexpr float panel_width = 372, panel_margin = 8;                   ///< the margin lies all around it
inline constexpr float panel_end = panel_margin + panel_width + panel_margin; ///< where the free view begins

/// Draws them all. At most panel_width x scale pixels wide and within the display. Completes edits: checkpoint() where
/// nothing is being dragged or typed.
void draw_panels(ViewModel& model, const FrameFacts& facts, PanelState& state);

/// Over the view, right of the panel: the pinned buffers along the bottom, what the one in place of the picture holds,
/// and the values under the mouse.
void draw_buffers(ViewModel& model, const FrameFacts& facts, float scale);

/// One tab, for draw_panels().
void draw_camera_tab(ViewModel& model, PanelState& state, bool is_cpu);
void draw_light_tab(ViewModel& model, PanelState& state, bool is_cpu);
void draw_buffer_tab(ViewModel& model, PanelState& state, bool is_cpu);
void draw_cost_tab(const FrameFacts& facts, PanelState& state, std::size_t lights);

/// "--eye X,Y,Z --target X,Y,Z --fov F", from which the command line makes the same camera.
[[nodiscard]] std::string camera_options(const Camera& camera);

} // namespace atrium::gui
