#include "renderer/graph/graph.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

namespace atrium::graph {

Tex Graph::texture(std::string name, const TexDesc& desc)
{
    Resource r;
    r.name = std::move(name);
    r.desc = desc;
    resources_.push_back(std::move(r));
    return {static_cast<ResourceIndex>(resources_.size() - 1)};
}

Buf Graph::buffer(std::string name, std::uint64_t bytes)
{
    Resource r;
    r.name = std::move(name);
    r.is_image = false;
    r.bytes = bytes;
    resources_.push_back(std::move(r));
    return {static_cast<ResourceIndex>(resources_.size() - 1)};
}

Buf Graph::import(std::string name, const gpu::Buffer& buffer, Access initial)
{
    Resource r;
    r.name = std::move(name);
    r.is_image = false;
    r.bytes = buffer.size();
    r.imported = &buffer;
    r.initial = initial;
    resources_.push_back(std::move(r));
    return {static_cast<ResourceIndex>(resources_.size() - 1)};
}

Tex Graph::import(std::string name, const gpu::Image& image, Access initial)
{
    Resource r;
    r.name = std::move(name);
    r.desc = {image.desc().format, image.desc().width, image.desc().height, image.desc().layers};
    r.imported_image = &image;
    r.initial = initial;
    resources_.push_back(std::move(r));
    return {static_cast<ResourceIndex>(resources_.size() - 1)};
}

void Graph::keep(ResourceIndex resource, Access access)
{
    resources_[resource].keep = true;
    finals_.push_back({resource, access});
}

std::optional<Tex> Graph::find(const std::string& name) const
{
    for (std::size_t i = 0; i < resources_.size(); ++i) {
        if (resources_[i].is_image && resources_[i].name == name) return Tex{static_cast<ResourceIndex>(i)};
    }
    return std::nullopt;
}

std::vector<std::pair<std::string, Tex>> Graph::readable_images() const
{
    std::vector<bool> readable(resources_.size());
    for (std::size_t i = 0; i < resources_.size(); ++i) readable[i] = resources_[i].imported_image;
    for (const Pass& pass : passes_) {
        for (const Use& use : pass.uses) {
            if (resources_[use.resource].is_image && gpu::info(use.access).writes) readable[use.resource] = true;
        }
    }
    std::vector<std::pair<std::string, Tex>> out;
    for (std::size_t i = 0; i < resources_.size(); ++i) {
        if (readable[i]) out.emplace_back(resources_[i].name, Tex{static_cast<ResourceIndex>(i)});
    }
    return out;
}

PassBuilder Graph::add(std::string name, PassKind kind)
{
    Pass pass;
    pass.name = std::move(name);
    pass.kind = kind;
    passes_.push_back(std::move(pass));
    return {*this, passes_.size() - 1};
}

Pass& PassBuilder::pass()
{
    return graph_.passes_[pass_];
}

PassBuilder& PassBuilder::reads(Tex texture)
{
    reads_layer(texture, 0);
    pass().uses.back().range.layers = graph_.desc(texture).layers;
    return *this;
}

PassBuilder& PassBuilder::reads_layer(Tex texture, std::uint32_t layer)
{
    if (!texture) throw std::logic_error(fmt::format("pass {} reads an image that does not exist", pass().name));
    constexpr std::array by_kind{Access::sampled_fragment, Access::sampled_compute, Access::transfer_read};
    pass().uses.push_back({texture.index, by_kind[static_cast<std::size_t>(pass().kind)], {0, 1, layer, 1}});
    return *this;
}

PassBuilder& PassBuilder::reads(Buf buffer)
{
    constexpr std::array by_kind{Access::sampled_fragment, Access::sampled_compute, Access::transfer_read};
    return reads(buffer, by_kind[static_cast<std::size_t>(pass().kind)]);
}

PassBuilder& PassBuilder::reads(Buf buffer, Access access)
{
    if (!buffer) throw std::logic_error(fmt::format("pass {} reads a buffer that does not exist", pass().name));
    pass().uses.push_back({buffer.index, access});
    return *this;
}

PassBuilder& PassBuilder::writes(Tex texture, Load load, vec4 clear)
{
    if (pass().kind != PassKind::transfer) return writes_layer(texture, 0, load, clear);
    pass().uses.push_back({texture.index, Access::transfer_write, {}, true});
    return *this;
}

PassBuilder& PassBuilder::writes_layer(Tex texture, std::uint32_t layer, Load load, vec4 clear)
{
    if (pass().kind != PassKind::raster) {
        throw std::logic_error(fmt::format("pass {}: only raster passes write layers of images", pass().name));
    }
    pass().colors.push_back({texture, load, clear, layer});
    pass().uses.push_back({texture.index, Access::color_write, {0, 1, layer, 1}, load != Load::keep});
    return *this;
}

PassBuilder& PassBuilder::writes(Buf buffer)
{
    const Access access = pass().kind == PassKind::transfer ? Access::transfer_write : Access::storage_write;
    pass().uses.push_back({buffer.index, access, {}, true});
    return *this;
}

PassBuilder& PassBuilder::updates(Buf buffer)
{
    writes(buffer);
    pass().uses.back().discard = false;
    return *this;
}

PassBuilder& PassBuilder::depth(Tex texture, Load load, float clear)
{
    pass().depth = Attachment{texture, load, vec4(clear)};
    pass().depth_writes = true;
    pass().uses.push_back({texture.index, Access::depth_write, {}, load != Load::keep});
    return *this;
}

PassBuilder& PassBuilder::depth_test(Tex texture)
{
    pass().depth = Attachment{texture, Load::keep, vec4(0)};
    pass().uses.push_back({texture.index, Access::depth_read});
    return *this;
}

PassBuilder& PassBuilder::pipeline(gpu::GraphicsPipelineDesc desc)
{
    pass().graphics.push_back(std::move(desc));
    return *this;
}

PassBuilder& PassBuilder::pipeline(gpu::ComputePipelineDesc desc)
{
    pass().compute.push_back(std::move(desc));
    return *this;
}

PassBuilder& PassBuilder::fullscreen_pipeline(const std::string& fragment, std::vector<std::uint32_t> constants)
{
    gpu::GraphicsPipelineDesc desc;
    desc.vertex = "lib/fullscreen.vert";
    desc.fragment = fragment;
    desc.constants = std::move(constants);
    return pipeline(std::move(desc));
}

PassBuilder& PassBuilder::always()
{
    pass().side_effect = true;
    return *this;
}

PassBuilder& PassBuilder::record(std::function<void(Cmd&)> function)
{
    pass().record = std::move(function);
    return *this;
}

} // namespace atrium::graph
