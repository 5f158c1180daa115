#include "renderer/graph/graph.hpp"

#include "renderer/graph/frame_slot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <stdexcept>
#include <utility>

namespace atrium::graph {

Tex Graph::texture(std::string name, const TexDesc& desc)
{
    Resource r;
    r.desc = resolved(name, desc);
    r.name = std::move(name);
    resources_.push_back(std::move(r));
    return {static_cast<ResourceIndex>(resources_.size() - 1)};
}

TexDesc Graph::resolved(const std::string& name, TexDesc desc) const
{
    if (desc.size_of != SizeOf::absolute) {
        const uvec2 whole = desc.size_of == SizeOf::render ? frame_.render_size : frame_.output_size;
        if (whole.x == 0 || whole.y == 0)
            throw std::logic_error(fmt::format("graph: \"{}\" has a size relative to one that is not known", name));
        const uvec2 size = (whole + desc.divisor - 1u) / desc.divisor;
        desc.width = size.x;
        desc.height = size.y;
        desc.size_of = SizeOf::absolute;
        desc.divisor = 1;
    }
    if (desc.mips == all_mips)
        desc.mips = static_cast<std::uint32_t>(std::bit_width(std::max(desc.width, desc.height)));
    return desc;
}

uvec2 Graph::size(Tex texture, std::uint32_t mip) const
{
    const TexDesc& d = desc(texture);
    return glm::max(uvec2(d.width >> mip, d.height >> mip), uvec2(1));
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

Buf Graph::upload_bytes(std::string name, std::span<const std::byte> bytes)
{
    if (!uploads_) throw std::logic_error(fmt::format("graph: \"{}\" is uploaded, and there is no runner", name));
    const gpu::Buffer& buffer = uploads_->next(bytes.size());
    buffer.write(bytes);
    return import(std::move(name), buffer);
}

Tex Graph::import(std::string name, const gpu::Image& image, Access initial)
{
    Resource r;
    r.name = std::move(name);
    const gpu::ImageDesc& own = image.desc();
    r.desc = {own.format, own.width, own.height, own.layers, own.mips, own.samples};
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
    for (std::size_t i = 0; i < resources_.size(); ++i)
        readable[i] = resources_[i].imported_image || resources_[i].holds;
    for (const Pass& pass : passes_) {
        for (const Use& use : pass.uses) {
            if (resources_[use.resource].is_image && gpu::info(use.access).writes) readable[use.resource] = true;
        }
    }
    std::vector<std::pair<std::string, Tex>> out;
    for (std::size_t i = 0; i < resources_.size(); ++i) {
        if (readable[i] && !resources_[i].constant && resources_[i].desc.samples == 1)
            out.emplace_back(resources_[i].name, Tex{static_cast<ResourceIndex>(i)});
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

namespace {

constexpr std::array sampled_by_kind{Access::sampled_fragment, Access::sampled_compute, Access::transfer_read};

} // namespace

PassBuilder& PassBuilder::use(Tex texture, Access access, SubresourceRange range, bool discard)
{
    if (!texture) {
        throw std::logic_error(fmt::format("pass {} {} an image that does not exist", pass().name,
                                           gpu::is_write(access) ? "writes" : "reads"));
    }
    pass().uses.push_back({texture.index, access, range, discard});
    return *this;
}

PassBuilder& PassBuilder::reads(Tex texture)
{
    reads_layer(texture, 0);
    const TexDesc& desc = graph_.desc(texture);
    pass().uses.back().range.layers = desc.layers;
    pass().uses.back().as_array = desc.array && desc.layers == 1; // several layers are an array in any case
    return *this;
}

PassBuilder& PassBuilder::reads_layer(Tex texture, std::uint32_t layer)
{
    const std::uint32_t mips = texture ? graph_.desc(texture).mips : 1;
    return use(texture, sampled_by_kind[static_cast<std::size_t>(pass().kind)], {0, mips, layer, 1});
}

PassBuilder& PassBuilder::reads_mip(Tex texture, std::uint32_t mip)
{
    reads(texture);
    pass().uses.back().range.first_mip = mip;
    pass().uses.back().range.mips = 1;
    return *this;
}

PassBuilder& PassBuilder::reads(Buf buffer)
{
    return reads(buffer, sampled_by_kind[static_cast<std::size_t>(pass().kind)]);
}

PassBuilder& PassBuilder::reads(Buf buffer, Access access)
{
    if (!buffer) throw std::logic_error(fmt::format("pass {} reads a buffer that does not exist", pass().name));
    pass().uses.push_back({buffer.index, access});
    return *this;
}

PassBuilder& PassBuilder::write(Tex texture, std::uint32_t mip, std::uint32_t layer, Load load, vec4 clear)
{
    constexpr std::array by_kind{Access::color_write, Access::storage_write, Access::transfer_write};
    if (pass().kind != PassKind::raster && load == Load::clear)
        throw std::logic_error(fmt::format("pass {}: only raster passes clear what they write", pass().name));
    use(texture, by_kind[static_cast<std::size_t>(pass().kind)], {mip, 1, layer, 1}, load != Load::keep);
    if (pass().kind == PassKind::raster)
        pass().colors.push_back({texture, load, clear, layer, mip, pass().uses.size() - 1});
    return *this;
}

PassBuilder& PassBuilder::writes(Tex texture, Load load, vec4 clear)
{
    write(texture, 0, 0, load, clear);
    if (pass().kind == PassKind::compute) pass().uses.back().range.layers = graph_.desc(texture).layers;
    return *this;
}

PassBuilder& PassBuilder::writes_layer(Tex texture, std::uint32_t layer, Load load, vec4 clear)
{
    return write(texture, 0, layer, load, clear);
}

PassBuilder& PassBuilder::writes_mip(Tex texture, std::uint32_t mip, Load load, vec4 clear)
{
    writes(texture, load, clear);
    pass().uses.back().range.first_mip = mip;
    if (pass().kind == PassKind::raster) pass().colors.back().mip = mip;
    return *this;
}

PassBuilder& PassBuilder::resolves(Tex texture)
{
    if (pass().colors.empty())
        throw std::logic_error(fmt::format("pass {} resolves a colour target that it does not have", pass().name));
    pass().colors.back().resolve = texture;
    return use(texture, Access::resolve_write, {}, true);
}

PassBuilder& PassBuilder::updates(Tex texture, std::uint32_t mip)
{
    if (pass().kind == PassKind::transfer)
        throw std::logic_error(fmt::format("pass {}: transfers write images whole", pass().name));
    const Access access = pass().kind == PassKind::compute ? Access::storage_write : Access::storage_fragment;
    return use(texture, access, {mip, 1, 0, texture ? graph_.desc(texture).layers : 1});
}

PassBuilder& PassBuilder::writes(Buf buffer)
{
    return writes(buffer, pass().kind == PassKind::transfer ? Access::transfer_write : Access::storage_write);
}

PassBuilder& PassBuilder::writes(Buf buffer, Access access)
{
    if (!buffer) throw std::logic_error(fmt::format("pass {} writes a buffer that does not exist", pass().name));
    pass().uses.push_back({buffer.index, access, {}, true});
    return *this;
}

PassBuilder& PassBuilder::updates(Buf buffer)
{
    writes(buffer);
    pass().uses.back().discard = false;
    return *this;
}

PassBuilder& PassBuilder::updates(Buf buffer, Access access)
{
    writes(buffer, access);
    pass().uses.back().discard = false;
    return *this;
}

PassBuilder& PassBuilder::depth(Tex texture, Load load, float clear)
{
    pass().depth = Attachment{texture, load, vec4(clear)};
    pass().depth_writes = true;
    use(texture, Access::depth_write, {}, load != Load::keep);
    pass().depth->use = pass().uses.size() - 1;
    return *this;
}

PassBuilder& PassBuilder::depth_test(Tex texture)
{
    pass().depth = Attachment{texture, Load::keep, vec4(0)};
    use(texture, Access::depth_read, {});
    pass().depth->use = pass().uses.size() - 1;
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
