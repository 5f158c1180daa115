#include "renderer/ui.hpp"

#include "renderer/scene_upload.hpp"

#include <algorithm>
#include <stdexcept>

namespace atrium {
namespace {

constexpr const char *main_picture = "ui.picture", *other_picture = "ui.other_picture", *kept_insets = "ui.insets";

void keep(graph::Graph& g, graph::Tex from, const std::string& name)
{
    const uvec2 size = g.size(from);
    const graph::Tex kept =
        g.persistent(name, {gpu::Format::rgba8_unorm, size.x, size.y}, {.owner = graph::Owner::program});
    // Copied without conversion: colours stay sRGB-encoded, like those of the interface.
    g.transfer(name + ".keep").reads(from).writes(kept).record([=](graph::Cmd& cmd) { cmd.copy(from, kept); });
}

} // namespace

void Ui::set_font(uvec2 size, std::span<const std::byte> rgba)
{
    font_ = gpu::Image(
        device_, "ui.font",
        {gpu::Format::rgba8_unorm, size.x, size.y, 1, 1, VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT});
    const UploadJob job{rgba, {{&font_, 0, 0, rgba.size()}}, {}};
    upload(device_, {&job, 1}, UploadPath::staging);
}

void Ui::keep_picture(graph::Graph& g, graph::Tex picture, PictureSlot slot)
{
    keep(g, picture, slot == PictureSlot::main ? main_picture : other_picture);
}

void Ui::keep_insets(graph::Graph& g, graph::Tex insets)
{
    keep(g, insets, kept_insets);
}

void Ui::add_pictures(graph::Graph& g, graph::Tex window, float divider)
{
    const std::optional<graph::Tex> main = g.kept(main_picture);
    if (!main) throw std::logic_error("the window is drawn before there is a picture");
    const graph::Tex other = divider > 0 ? g.kept(other_picture).value_or(*main) : *main;
    const uvec2 size = g.size(window);
    const bool texel_by_texel = g.size(*main) == size && g.size(other) == size;
    const vec2 inv_size = 1.0f / vec2(size);
    g.raster("pictures")
        .reads(*main)
        .reads(other)
        .writes(window)
        .fullscreen("ui/pictures.frag", {texel_by_texel ? 1u : 0u}, shared::PicturesPush{inv_size, divider});
}

void Ui::add(graph::Graph& g, graph::Tex window, const UiDraws& draws)
{
    const graph::Buf vertices = g.upload("ui.vertices", draws.vertices);
    const graph::Buf indices = g.upload("ui.indices", draws.indices);
    const graph::Tex font = g.import("ui.font", font_, gpu::Access::sampled_fragment);
    const graph::Tex insets = g.kept(kept_insets).value_or(font);
    gpu::GraphicsPipelineDesc state;
    state.vertex = "ui/ui.vert";
    state.fragment = "ui/ui.frag";
    state.blend = gpu::Blend::alpha;
    const auto of_kind = [](gpu::GraphicsPipelineDesc like, std::uint32_t kind) {
        like.constants = {kind};
        return like;
    };
    const graph::TexDesc& size = g.desc(window);
    const vec2 inv_size(1.0f / static_cast<float>(size.width), 1.0f / static_cast<float>(size.height));
    g.raster("ui")
        .reads(font)
        .reads(insets)
        .reads(vertices)
        .reads(indices, gpu::Access::index_read)
        .writes(window, graph::Load::keep)
        .pipeline(of_kind(state, shared::ui_plain))
        .pipeline(of_kind(state, shared::ui_font))
        .pipeline(of_kind(state, shared::ui_insets))
        .pipeline(of_kind(state, shared::ui_textures))
        .record([commands = draws.commands, indices, inv_size](graph::Cmd& cmd) {
            cmd.bind_indices(indices);
            for (const UiCommand& c : commands) {
                cmd.bind(std::min(c.image, shared::ui_textures));
                cmd.scissor(c.clip_origin, c.clip_size);
                cmd.push(shared::UiPush{inv_size, c.image});
                cmd.draw_indexed(c.first_index, c.index_count, 0);
            }
        });
}

} // namespace atrium
