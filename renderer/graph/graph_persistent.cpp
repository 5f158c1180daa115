// Graph: persistent resources, their histories and notes, and constant images.

#include "renderer/graph/graph.hpp"
#include "renderer/graph/persistents.hpp"
#include "renderer/graph/runner.hpp"

#include <fmt/format.h>

#include <functional>
#include <stdexcept>
#include <utility>

namespace atrium::graph {

Graph::Graph(Runner& runner, const FrameInfo& frame)
    : frame_(frame), uploads_(&runner.slot_.uploads), store_(runner.persistents_.get()),
      view_(runner.persistents_->view(frame.view))
{}

Tex Graph::persistent(std::string name, const TexDesc& desc, const PersistentOptions& options)
{
    PersistentUse use;
    use.key = options.key.empty() ? name : options.key;
    use.owner = options.owner;
    use.desc = resolved(name, desc);
    return {add_persistent(std::move(use), std::move(name))};
}

Buf Graph::persistent(std::string name, std::uint64_t bytes, const PersistentOptions& options)
{
    PersistentUse use;
    use.key = options.key.empty() ? name : options.key;
    use.owner = options.owner;
    use.is_image = false;
    use.bytes = bytes;
    return {add_persistent(std::move(use), std::move(name))};
}

ResourceIndex Graph::add_persistent(PersistentUse use, std::string name)
{
    if (!store_) throw std::logic_error(fmt::format("graph: \"{}\" is persistent, and there is no runner", name));
    if (persistents_.empty()) epoch_ = store_->epoch();
    if (use.owner == Owner::view) use.key = frame_.view + "/" + use.key;
    use.hash = std::hash<std::string_view>{}(use.key);
    for (const PersistentUse& other : persistents_) {
        if (other.hash != use.hash || other.key != use.key) continue;
        if (other.owner == use.owner && other.is_image == use.is_image && other.desc == use.desc &&
            other.bytes == use.bytes)
            return other.now;
        throw std::logic_error(fmt::format("graph: \"{}\" is declared twice, with two descriptions", name));
    }
    const Persistents::Entry* entry = store_->find(use.hash, use.key);
    Resource r;
    r.name = std::move(name);
    r.is_image = use.is_image;
    r.desc = use.desc;
    r.bytes = use.bytes;
    r.keep = true;
    r.persistent = static_cast<std::uint32_t>(persistents_.size());
    r.holds = entry && entry->matches(use) && entry->slots[entry->current].holds();
    use.now = static_cast<ResourceIndex>(resources_.size());
    resources_.push_back(std::move(r));
    persistents_.push_back(std::move(use));
    return persistents_.back().now;
}

History<Tex> Graph::history(Tex texture)
{
    History<Tex> out;
    out.before.index = add_history(texture.index, out.valid);
    return out;
}

History<Buf> Graph::history(Buf buffer)
{
    History<Buf> out;
    out.before.index = add_history(buffer.index, out.valid);
    return out;
}

ResourceIndex Graph::add_history(ResourceIndex now, bool& valid)
{
    if (!resources_[now].is_persistent() || resources_[now].is_history) {
        throw std::logic_error(
            fmt::format("graph: \"{}\" has no history, because it is not persistent", resources_[now].name));
    }
    PersistentUse& use = persistents_[resources_[now].persistent];
    const Persistents::Entry* entry = store_->find(use.hash, use.key);
    if (!use.history && resources_[now].holds) {
        Resource before = resources_[now];
        before.name += ".before";
        before.is_history = true;
        before.keep = false;
        use.before = static_cast<ResourceIndex>(resources_.size());
        resources_.push_back(std::move(before));
    }
    use.history = true;
    resources_[now].holds = false;
    valid =
        use.before != no_resource && !frame_.cut && entry->view == view_ && entry->written == store_->last_frame(view_);
    return use.before;
}

std::optional<Tex> Graph::kept(const std::string& key)
{
    if (!store_) return std::nullopt;
    const Persistents::Entry* entry = store_->find(std::hash<std::string_view>{}(key), key);
    if (!entry || !entry->is_image || entry->owner == Owner::view || !entry->slots[entry->current].holds())
        return std::nullopt;
    return persistent(key, entry->desc, {entry->owner, {}});
}

Tex Graph::constant(float value)
{
    return add_constant(value, false);
}

Tex Graph::constant_array(float value)
{
    return add_constant(value, true);
}

Tex Graph::add_constant(float value, bool array)
{
    for (std::size_t i = 0; i < resources_.size(); ++i) {
        if (resources_[i].constant == value && resources_[i].desc.array == array)
            return {static_cast<ResourceIndex>(i)};
    }
    TexDesc desc{gpu::Format::r32_float};
    desc.array = array;
    const std::string name = fmt::format("{}.{}", array ? "constant_array" : "constant", value);
    const Tex texture = persistent(name, desc, {Owner::program, {}});
    resources_[texture.index].constant = value;
    if (!holds(texture)) raster(name).writes(texture, Load::clear, vec4(value));
    return texture;
}

void Graph::write_note(ResourceIndex resource, std::span<const std::byte> bytes)
{
    persistents_.at(resources_[resource].persistent).note.assign(bytes.begin(), bytes.end());
}

std::span<const std::byte> Graph::read_note(ResourceIndex resource) const
{
    const Resource& r = resources_[resource];
    if (!r.is_persistent() || !r.holds) return {};
    const PersistentUse& use = persistents_[r.persistent];
    const Persistents::Entry& entry = *store_->find(use.hash, use.key);
    return entry.slots[entry.current].note;
}

} // namespace atrium::graph
