#pragma once
// A window's contents: the pictures drawn last, and the user interface over them. Who makes its triangles is the
// program's affair.

#include "renderer/graph/graph.hpp"
#include "renderer/picture_slot.hpp"
#include "shaders/shared/ui.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace atrium {

/// Triangles of one clip rectangle and image.
struct UiCommand {
    uvec2 clip_origin{0}, clip_size{0}; ///< pixels, within the window
    std::uint32_t first_index = 0, index_count = 0;
    std::uint32_t image = shared::ui_font;
};

/// In painter's order.
struct UiDraws {
    std::vector<shared::UiVertex> vertices;
    std::vector<std::uint32_t> indices;
    std::vector<UiCommand> commands;
};

/// The contents of a window. The graph keeps its last pictures as long as the program runs.
class Ui {
public:
    explicit Ui(const gpu::Device& device) : device_(device) {}

    /// RGBA8, rows from the top.
    void set_font(uvec2 size, std::span<const std::byte> rgba);

    /// Reads  the frame's picture (RGBA8).  Keeps it.
    static void keep_picture(graph::Graph& g, graph::Tex picture, PictureSlot slot);

    /// The same of the buffers shown beside it, side by side in one image.
    static void keep_insets(graph::Graph& g, graph::Tex insets);

    /// Reads  kept pictures.  Writes  the window's image, all of it. `divider`: its first column of the main picture.
    static void add_pictures(graph::Graph& g, graph::Tex window, float divider);
    /// Reads  font, kept insets.  Writes  over what the window's image shows.
    void add(graph::Graph& g, graph::Tex window, const UiDraws& draws);

private:
    const gpu::Device& device_;
    gpu::Image font_;
};

} // namespace atrium
