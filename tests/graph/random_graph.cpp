#include "tests/graph/random_graph.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <random>

namespace atrium::graph {
namespace {

class Maker {
public:
    explicit Maker(std::uint64_t seed) : random_(seed) {}

    oracle::Frame make()
    {
        const std::uint32_t resources = 2 + below(7), passes = 2 + below(9);
        for (std::uint32_t r = 0; r < resources; ++r) add_resource(r);
        for (std::uint32_t p = 0; p < passes; ++p) add_pass(p);
        for (ResourceIndex r = 0; r < frame_.graph.resources.size(); ++r) add_final(r);
        if (!frame_.histories.empty()) leave_out_histories();
        return std::move(frame_);
    }

private:
    std::uint32_t below(std::uint32_t n) { return static_cast<std::uint32_t>(random_() % n); }
    bool chance(std::uint32_t percent) { return below(100) < percent; }
    template <std::size_t n>
    Access one_of(const Access (&list)[n])
    {
        return list[below(n)];
    }

    Access image_read()
    {
        return one_of({Access::sampled_fragment, Access::sampled_fragment, Access::sampled_compute,
                       Access::sampled_vertex, Access::depth_read, Access::storage_read, Access::transfer_read,
                       Access::host_read});
    }
    Access image_write()
    {
        return one_of({Access::color_write, Access::color_write, Access::resolve_write, Access::depth_write,
                       Access::storage_write, Access::storage_write, Access::storage_fragment, Access::transfer_write});
    }
    Access multisampled(bool write)
    {
        if (write) return one_of({Access::color_write, Access::depth_write});
        return one_of({Access::sampled_fragment, Access::sampled_compute, Access::sampled_vertex, Access::depth_read});
    }
    Access buffer_read()
    {
        return one_of({Access::sampled_fragment, Access::sampled_compute, Access::sampled_vertex, Access::indirect_read,
                       Access::index_read, Access::vertex_read, Access::transfer_read, Access::host_read,
                       Access::storage_read, Access::address_fragment, Access::address_compute, Access::address_vertex,
                       Access::acceleration_input, Access::acceleration_fragment, Access::acceleration_compute});
    }
    Access buffer_write()
    {
        return one_of({Access::storage_write, Access::storage_write, Access::storage_fragment, Access::transfer_write,
                       Access::address_write, Access::acceleration_build});
    }
    Access any(const ResourceDesc& r, bool write)
    {
        if (r.is_image && r.samples > 1) return multisampled(write);
        if (r.is_image) return write ? image_write() : image_read();
        return write ? buffer_write() : buffer_read();
    }

    void add_resource(std::uint32_t index)
    {
        ResourceDesc r;
        r.name = fmt::format("r{}", index);
        r.is_image = chance(70);
        if (r.is_image && chance(40)) {
            r.mips = 1 + below(3);
            r.layers = 1 + below(2);
        }
        if (r.is_image && r.mips == 1 && chance(20)) r.samples = 4;
        if (chance(20)) return add_persistent(r);
        r.transient = chance(75);
        r.keep = chance(25);
        if (r.transient) {
            r.size = chance(10) ? 0 : 1 + below(64);
            r.alignment = std::uint64_t{1} << below(5);
            r.memory_class = below(2);
        } else if (chance(75)) {
            r.initial = r.is_image && r.samples == 1 && chance(15) ? Access::present : any(r, chance(50));
            const auto other = gpu::info(any(r, false)).stages;
            if (r.initial != Access::present && !gpu::is_write(r.initial) && chance(30)) r.initial_wait.stages = other;
        }
        written_.emplace_back(std::size_t{r.mips} * r.layers, !r.transient);
        frame_.graph.resources.push_back(r);
    }

    /// A persistent resource, alone or as a pair with its history.
    void add_persistent(ResourceDesc r)
    {
        r.transient = false;
        r.keep = true;
        r.initial_parts.resize(std::size_t{r.mips} * r.layers);
        std::vector<bool> written(r.initial_parts.size(), false);
        const bool used_before = chance(50), has_history = chance(40);
        for (std::size_t s = 0; used_before && s < r.initial_parts.size(); ++s) {
            PartState& part = r.initial_parts[s];
            part.last = any(r, chance(50));
            if (!gpu::is_write(part.last) && chance(30)) part.wait.stages = gpu::info(any(r, false)).stages;
            part.defined = !has_history && chance(80);
            written[s] = part.defined;
        }
        written_.push_back(written);
        frame_.graph.resources.push_back(r);
        if (!has_history) return;
        const auto index = static_cast<ResourceIndex>(frame_.graph.resources.size());
        frame_.histories.emplace_back(index - 1, index);
        r.name += ".before";
        written_.emplace_back(r.initial_parts.size(), true); // in frames with a history
        frame_.graph.resources.push_back(std::move(r));
    }

    bool is_history(ResourceIndex index)
    {
        return std::any_of(frame_.histories.begin(), frame_.histories.end(),
                           [&](const auto& pair) { return pair.second == index; });
    }

    /// The first frame has no history to read.
    void leave_out_histories()
    {
        frame_.passes_with_history = frame_.graph.passes;
        for (PassDesc& pass : frame_.graph.passes)
            std::erase_if(pass.uses, [&](const Use& use) { return is_history(use.resource); });
    }

    SubresourceRange random_range(const ResourceDesc& r)
    {
        if (chance(40)) return {0, r.mips, 0, r.layers};
        SubresourceRange out;
        out.first_mip = below(r.mips);
        out.mips = 1 + below(r.mips - out.first_mip);
        out.first_layer = below(r.layers);
        out.layers = 1 + below(r.layers - out.first_layer);
        return out;
    }

    template <class F>
    void each_cell(const Use& use, F&& function)
    {
        const ResourceDesc& r = frame_.graph.resources[use.resource];
        for (std::uint32_t l = use.range.first_layer; l < use.range.first_layer + use.range.layers; ++l) {
            for (std::uint32_t m = use.range.first_mip; m < use.range.first_mip + use.range.mips; ++m) {
                function(std::size_t{l} * r.mips + m);
            }
        }
    }

    /// Whether the pass may have one more use: nothing overlaps, or one layout does for both.
    bool fits(const PassDesc& pass, const Use& use)
    {
        const auto layout = [](Access a) { return gpu::info(a).layout; };
        const auto meet = [](std::uint32_t a, std::uint32_t n, std::uint32_t b, std::uint32_t m) {
            return a < b + m && b < a + n;
        };
        for (const Use& other : pass.uses) {
            if (other.resource != use.resource) continue;
            const SubresourceRange &a = other.range, &b = use.range;
            if (!meet(a.first_mip, a.mips, b.first_mip, b.mips) ||
                !meet(a.first_layer, a.layers, b.first_layer, b.layers))
                continue;
            // Sampling beside a depth test is fine. More uses than these two might contradict: keep to two.
            const auto pair = [&](Access x, Access y) { return other.access == x && use.access == y; };
            const bool depth = pair(Access::depth_read, Access::sampled_fragment) ||
                               pair(Access::sampled_fragment, Access::depth_read);
            if (depth && pass.uses.size() == 1) continue;
            if (frame_.graph.resources[use.resource].is_image && layout(other.access) != layout(use.access))
                return false;
        }
        return true;
    }

    void add_pass(std::uint32_t index)
    {
        PassDesc pass;
        pass.name = fmt::format("p{}", index);
        pass.side_effect = chance(30);
        const std::uint32_t uses = 1 + below(4);
        for (std::uint32_t u = 0; u < uses; ++u) {
            Use use;
            use.resource = below(static_cast<std::uint32_t>(frame_.graph.resources.size()));
            if (!pass.uses.empty() && chance(15)) use.resource = pass.uses[0].resource;
            const ResourceDesc& r = frame_.graph.resources[use.resource];
            use.range = r.is_image ? random_range(r) : SubresourceRange{};
            bool readable = true;
            each_cell(use, [&](std::size_t cell) { readable = readable && written_[use.resource][cell]; });
            use.access = any(r, !is_history(use.resource) && (!readable || chance(45)));
            use.discard = gpu::is_write(use.access) && chance(35);
            if (fits(pass, use)) pass.uses.push_back(use);
        }
        for (const Use& use : pass.uses) {
            if (!gpu::is_write(use.access)) continue;
            each_cell(use, [&](std::size_t cell) { written_[use.resource][cell] = true; });
        }
        frame_.graph.passes.push_back(std::move(pass));
    }

    void add_final(ResourceIndex index)
    {
        const ResourceDesc& r = frame_.graph.resources[index];
        if (is_history(index)) return;
        const std::vector<bool>& written = written_[index];
        const bool possible = std::find(written.begin(), written.end(), false) == written.end();
        // What came from the window system goes back there; images of many parts end in one layout.
        const bool needed =
            !r.transient && r.initial_parts.empty() && (r.initial == Access::present || written.size() > 1);
        if (!possible || (!needed && !chance(r.transient ? 8 : 40))) return;
        const bool presents = r.initial == Access::present;
        frame_.finals.push_back({index, presents ? Access::present : any(r, chance(10))});
    }

    std::mt19937_64 random_;
    oracle::Frame frame_;
    std::vector<std::vector<bool>> written_; ///< by resource and subresource: readable in the next pass
};

} // namespace

oracle::Frame random_frame(std::uint64_t seed)
{
    return Maker(seed).make();
}

oracle::Frame next_frame(const oracle::Frame& previous)
{
    oracle::Frame out = previous;
    for (std::size_t r = 0; r < out.graph.resources.size(); ++r) {
        ResourceDesc& resource = out.graph.resources[r];
        if (resource.transient) continue;
        resource.initial = previous.plan.final_access[r];
        resource.initial_wait = previous.plan.final_waits[r];
        resource.initial_parts = previous.plan.final_parts[r];
    }
    if (out.histories.empty()) return out;
    for (ResourceIndex r = 0; r < out.graph.resources.size(); ++r) out.memory_of.push_back(r);
    bool valid = true;
    for (const auto& [now, before] : out.histories) {
        for (const PartState& part : previous.plan.final_parts[now]) valid = valid && part.defined;
    }
    if (!valid) return out;
    out.graph.passes = out.passes_with_history;
    for (const auto& [now, before] : out.histories) {
        std::swap(out.graph.resources[now].initial_parts, out.graph.resources[before].initial_parts);
        std::swap(out.memory_of[now], out.memory_of[before]);
    }
    return out;
}

} // namespace atrium::graph
