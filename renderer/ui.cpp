#include "renderer/ui.hpp"

#include "renderer/scene_upload.hpp"

#include <algorithm>
#include <cstring>
#include <stdexcept>

namespace atrium {
namespace {

/// Copies into a buffer that grows by doubling.
template <class T>
void write(const gpu::Device& device, gpu::Buffer& buffer, const char* name, const std::vector<T>& values,
           VkBufferUsageFlags usage)
{
    const std::uint64_t bytes = values.size() * sizeof(T);
    if (buffer.size() < bytes || buffer.size() == 0) {
        std::uint64_t size = 65536;
        while (size < bytes) size *= 2;
        buffer = gpu::Buffer(device, name, size, usage, gpu::MemoryUse::upload);
    }
    std::memcpy(buffer.mapped().data(), values.data(), bytes);
    buffer.flush();
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

void Ui::keep(graph::Graph& g, graph::Tex from, gpu::Image& image, const std::string& name) const
{
    const graph::TexDesc& desc = g.desc(from);
    if (image.desc().width != desc.width || image.desc().height != desc.height) {
        image = gpu::Image(device_, name,
                           {gpu::Format::rgba8_unorm, desc.width, desc.height, 1, 1,
                            VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT});
    }
    const graph::Tex kept = g.import(name, image);
    // Copied as they stand, colours stay encoded, as the interface over them is.
    g.transfer(name + ".keep").reads(from).writes(kept).record([=](graph::Cmd& cmd) { cmd.copy(from, kept); });
    g.keep(kept, gpu::Access::sampled_fragment);
}

void Ui::keep_picture(graph::Graph& g, graph::Tex picture, PictureSlot slot)
{
    const bool main = slot == PictureSlot::main;
    keep(g, picture, pictures_[main ? 0 : 1], main ? "ui.picture" : "ui.other_picture");
}

void Ui::keep_insets(graph::Graph& g, graph::Tex insets)
{
    keep(g, insets, insets_, "ui.insets");
}

void Ui::add_pictures(graph::Graph& g, graph::Tex window, float divider)
{
    const gpu::Image& first = pictures_[0];
    const gpu::Image& second = divider > 0 && pictures_[1].view() ? pictures_[1] : first;
    if (!first.view()) throw std::logic_error("a window's contents before any picture");
    const graph::TexDesc& size = g.desc(window);
    const auto fits = [&](const gpu::Image& i) {
        return i.desc().width == size.width && i.desc().height == size.height;
    };
    const bool texel_by_texel = fits(first) && fits(second);
    const vec2 inv_size(1.0f / static_cast<float>(size.width), 1.0f / static_cast<float>(size.height));
    const graph::Tex main = g.import("ui.picture", first, gpu::Access::sampled_fragment);
    const graph::Tex other =
        &second == &first ? main : g.import("ui.other_picture", second, gpu::Access::sampled_fragment);
    g.raster("pictures")
        .reads(main)
        .reads(other)
        .writes(window)
        .fullscreen("ui/pictures.frag", {texel_by_texel ? 1u : 0u}, shared::PicturesPush{inv_size, divider});
}

void Ui::add(graph::Graph& g, graph::Tex window, const UiDraws& draws)
{
    write(device_, vertices_, "ui.vertices", draws.vertices, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
    write(device_, indices_, "ui.indices", draws.indices, VK_BUFFER_USAGE_INDEX_BUFFER_BIT);
    const graph::Buf vertices = g.import("ui.vertices", vertices_);
    const graph::Buf indices = g.import("ui.indices", indices_);
    const graph::Tex font = g.import("ui.font", font_, gpu::Access::sampled_fragment);
    const graph::Tex insets = insets_.view() ? g.import("ui.insets", insets_, gpu::Access::sampled_fragment) : font;
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
