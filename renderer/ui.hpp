#pragma once
// A window's user interface, drawn over the last picture. Who makes its triangles is the program's affair.

#include "renderer/graph/graph.hpp"
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

/// What the device keeps of a user interface: the font, the last picture, and this frame's triangles.
class Ui {
public:
    explicit Ui(const gpu::Device& device) : device_(device) {}

    /// RGBA8, rows from the top.
    void set_font(uvec2 size, std::span<const std::byte> rgba);

    /// Reads  the frame's picture (RGBA8).  Keeps it.
    void keep_picture(graph::Graph& g, graph::Tex picture);

    /// The same of the buffers shown beside it, side by side in one image.
    void keep_insets(graph::Graph& g, graph::Tex insets);

    /// Reads  font, kept picture and insets.  Writes  the window's image, all of it.
    void add(graph::Graph& g, graph::Tex window, const UiDraws& draws);

private:
    const gpu::Device& device_;
    void keep(graph::Graph& g, graph::Tex from, gpu::Image& image, const std::string& name) const;
    gpu::Image font_, picture_, insets_;
    gpu::Buffer vertices_, indices_;
    bool picture_kept_ = false, insets_kept_ = false;
};

} // namespace atrium
