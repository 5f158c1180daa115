#include "tests/graph/plan_oracle.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace atrium::graph::oracle {
namespace {

constexpr VkPipelineStageFlags2 all = ~VkPipelineStageFlags2{0};

bool within(std::uint32_t i, std::uint32_t first, std::uint32_t count)
{
    return i >= first && i < first + count;
}
bool covers(const SubresourceRange& range, std::uint32_t mip, std::uint32_t layer)
{
    return within(mip, range.first_mip, range.mips) && within(layer, range.first_layer, range.layers);
}

bool is_transition(const Event& e)
{
    return e.kind == Event::Kind::barrier && e.barrier.new_layout != VK_IMAGE_LAYOUT_UNDEFINED &&
           e.barrier.old_layout != e.barrier.new_layout;
}
bool is_operation(const Event& e)
{
    return e.kind != Event::Kind::barrier || is_transition(e);
}
bool modifies(const Event& e)
{
    return e.writes != 0 || is_transition(e) || e.kind == Event::Kind::unknown_write || e.kind == Event::Kind::acquire;
}

/// How far what one event did in one of its stages has got through the barriers since.
struct Front {
    VkPipelineStageFlags2 stage = 0;     ///< 0: no stage of its own, only `after`
    VkPipelineStageFlags2 after = 0;     ///< stages whose later work comes after it
    VkPipelineStageFlags2 available = 0; ///< stages whose later work comes after its writes are available
    std::vector<std::pair<VkPipelineStageFlags2, VkAccessFlags2>> visible;

    [[nodiscard]] bool before(const Barrier& b) const { return ((stage | after) & b.src_stages) != 0; }
    [[nodiscard]] bool available_by(const Barrier& b, VkAccessFlags2 writes, bool same_resource) const
    {
        const bool here = (stage & b.src_stages) != 0 && writes != 0 && (writes & ~b.src_access) == 0;
        return (here && (same_resource || b.takes_memory)) || (available & b.src_stages) != 0;
    }
    [[nodiscard]] bool visible_to(VkPipelineStageFlags2 stages, VkAccessFlags2 access) const
    {
        for (; stages != 0; stages &= stages - 1) {
            const VkPipelineStageFlags2 one = stages & ~(stages - 1);
            VkAccessFlags2 seen = 0;
            for (const auto& [s, a] : visible) seen |= (s & one) != 0 ? a : 0;
            if ((access & ~seen) != 0) return false;
        }
        return true;
    }
};

std::vector<Front> start(const Event& e)
{
    if (e.kind == Event::Kind::acquire) return {{0, all, all, {}}};
    if (e.kind == Event::Kind::unknown_write) return {{0, e.stages, e.stages, {{e.stages, e.access}}}};
    if (e.kind == Event::Kind::barrier) {
        const Barrier& b = e.barrier;
        return {{0, b.dst_stages, b.dst_stages, {{b.dst_stages, b.dst_access}}}};
    }
    std::vector<Front> out;
    for (VkPipelineStageFlags2 s = e.stages; s != 0; s &= s - 1) out.push_back({s & ~(s - 1), 0, 0, {}});
    return out;
}

void advance(std::vector<Front>& fronts, const Event& source, const Event& e)
{
    for (Front& f : fronts) {
        if (e.kind == Event::Kind::acquire) { // signal and wait of semaphores, around the presentation
            f.after = f.available = all;
        } else if (e.kind == Event::Kind::barrier) {
            const Barrier& b = e.barrier;
            const bool available = f.available_by(b, source.writes, source.name == e.name);
            if (f.before(b)) f.after |= b.dst_stages;
            if (!available) continue;
            f.available |= b.dst_stages;
            f.visible.emplace_back(b.dst_stages, b.dst_access);
        }
    }
}

/// Empty when `second` comes properly after `first`.
std::string hazard(const std::vector<Front>& fronts, const Event& first, const Event& second)
{
    const bool wrote = modifies(first);
    for (const Front& f : fronts) {
        if (second.kind == Event::Kind::barrier) {
            if (!f.before(second.barrier)) return "not ordered before the change of layout";
            if (wrote && !f.available_by(second.barrier, first.writes, first.name == second.name)) {
                return "not available to the change of layout";
            }
            continue;
        }
        const bool awaited = second.last && (f.stage & ~second.stages) == 0 && f.stage != 0;
        if ((second.stages & ~f.after) != 0 && !awaited) return "not ordered";
        if (wrote && first.kind != Event::Kind::acquire && !f.visible_to(second.stages, second.access)) {
            return "not visible";
        }
    }
    return "";
}

std::string describe(const Event& e)
{
    return fmt::format("{}{} at {} of \"{}\"", is_transition(e) ? "change of layout" : "use", e.last ? " (final)" : "",
                       e.moment, e.name);
}

/// Holds each event against all later ones, those of `a` alone or, where there is a `b`, of one against the other.
std::string check_order(const std::vector<const Event*>& events, bool across)
{
    for (std::size_t i = 0; i < events.size(); ++i) {
        if (!is_operation(*events[i])) continue;
        const Event& first = *events[i];
        std::vector<Front> fronts = start(first);
        for (std::size_t j = i + 1; j < events.size(); ++j) {
            const Event& second = *events[j];
            const bool concerns = !across || first.name != second.name;
            const bool conflict = modifies(first) || modifies(second) || second.last;
            const bool judged = !second.past && second.kind != Event::Kind::acquire && is_operation(second);
            if (concerns && conflict && judged) {
                const std::string what = hazard(fronts, first, second);
                if (!what.empty()) return fmt::format("{} and {}: {}", describe(first), describe(second), what);
            }
            advance(fronts, first, second);
        }
    }
    return "";
}

/// Layouts and contents of one subresource.
std::string check_layouts(const std::vector<const Event*>& events, const ResourceDesc& resource, VkImageLayout layout,
                          bool defined)
{
    const bool starts_known = !resource.initial_parts.empty();
    bool lost = false;
    std::size_t frame = 0;
    for (const Event* e : events) {
        if (e->past) continue;
        if (resource.transient && e->frame != frame) {
            layout = VK_IMAGE_LAYOUT_MAX_ENUM; // other resources may have had the memory
            defined = lost = false;
            frame = e->frame;
        }
        if (e->kind == Event::Kind::barrier) {
            const Barrier& b = e->barrier;
            if (!resource.is_image) {
                if (b.old_layout != VK_IMAGE_LAYOUT_UNDEFINED || b.new_layout != VK_IMAGE_LAYOUT_UNDEFINED)
                    return "a buffer has a layout";
                continue;
            }
            if (b.old_layout == VK_IMAGE_LAYOUT_UNDEFINED)
                lost = defined;
            else if (b.old_layout != layout)
                return fmt::format("wrong old layout at {}", e->moment);
            layout = b.new_layout;
        } else if (e->kind == Event::Kind::use) {
            for (const VkImageLayout wanted : e->layouts) {
                if (wanted != layout) return fmt::format("wrong layout for the use at {}", e->moment);
            }
            if (starts_known && !defined && e->writes == 0)
                return fmt::format("nothing was written before the use at {}", e->moment);
            if (lost && !e->discard) return fmt::format("contents lost before the use at {}", e->moment);
            defined = defined || e->writes != 0;
            lost = false;
        }
    }
    return "";
}

std::vector<const Event*> chosen(const std::vector<Event>& events, const std::optional<BarrierId>& left_out)
{
    std::vector<const Event*> out;
    for (const Event& e : events) {
        if (e.kind != Event::Kind::barrier || e.id != left_out) out.push_back(&e);
    }
    return out;
}

void add_use(const GraphDesc& graph, const Use& use, Event& e)
{
    const gpu::AccessInfo& info = gpu::info(use.access);
    e.discard = e.stages == 0 && e.layouts.empty() ? use.discard : e.discard && use.discard;
    e.stages |= info.stages;
    e.access |= info.access;
    e.writes |= info.writes;
    e.consumes = !e.discard && (e.writes == 0 || (e.access & ~e.writes) != 0);
    // What a depth attachment that is only tested allows: sampling in its own layout.
    if (graph.resources[use.resource].is_image) e.layouts.push_back(info.layout);
}

} // namespace

void Oracle::add_past(const ResourceDesc& resource, Cell& cell) const
{
    const PartState& before = cell.before;
    if (resource.transient || before.last == Access::none || before.last == Access::present) return;
    const gpu::AccessInfo& info = gpu::info(before.last);
    Event e;
    e.past = true;
    e.name = resource.name;
    if (info.writes == 0) {
        e.kind = Event::Kind::unknown_write;
        e.stages = info.stages;
        e.access = info.access;
        cell.events.push_back(e);
    }
    e.kind = Event::Kind::use;
    e.stages = info.stages | before.wait.stages;
    e.access = info.access;
    e.writes = info.writes | before.wait.access;
    cell.events.push_back(e);
}

ResourceIndex Oracle::index_in(std::size_t f, ResourceIndex memory) const
{
    const std::vector<ResourceIndex>& of = frames_[f].memory_of;
    return of.empty() ? memory : static_cast<ResourceIndex>(std::find(of.begin(), of.end(), memory) - of.begin());
}

void Oracle::add_frame(std::size_t f, std::uint32_t mip, std::uint32_t layer, Cell& cell) const
{
    const Frame& frame = frames_[f];
    const ResourceIndex index = index_in(f, cell.resource);
    const ResourceDesc& resource = frame.graph.resources[index];
    Event blank;
    blank.name = frames_.front().graph.resources[cell.resource].name;
    blank.frame = f;
    std::size_t moment = f * 1000000;
    if (!resource.transient && resource.initial == Access::present) {
        cell.events.push_back(blank);
        cell.events.back().kind = Event::Kind::acquire;
        cell.events.back().moment = moment;
    }
    const auto add_barriers = [&](std::size_t pass, const std::vector<Barrier>& barriers) {
        ++moment;
        for (std::size_t b = 0; b < barriers.size(); ++b) {
            if (barriers[b].resource != index || !covers(barriers[b].range, mip, layer)) continue;
            Event e = blank;
            e.kind = Event::Kind::barrier;
            e.moment = moment;
            e.barrier = barriers[b];
            e.id = {f, pass, b};
            cell.events.push_back(e);
        }
        ++moment;
    };
    for (std::size_t p = 0; p < frame.plan.passes.size(); ++p) {
        add_barriers(p, frame.plan.passes[p].barriers);
        Event e = blank;
        e.moment = moment;
        bool used = false;
        for (const Use& use : frame.graph.passes[frame.plan.passes[p].pass].uses) {
            if (use.resource != index || (resource.is_image && !covers(use.range, mip, layer))) continue;
            add_use(frame.graph, use, e);
            used = true;
        }
        const auto is_depth = [](VkImageLayout l) { return l == VK_IMAGE_LAYOUT_DEPTH_STENCIL_READ_ONLY_OPTIMAL; };
        if (std::any_of(e.layouts.begin(), e.layouts.end(), is_depth))
            e.layouts = {VK_IMAGE_LAYOUT_DEPTH_STENCIL_READ_ONLY_OPTIMAL};
        if (used) cell.events.push_back(e);
    }
    add_barriers(frame.plan.passes.size(), frame.plan.final_barriers);
    for (const FinalUse& final_use : frame.finals) {
        if (final_use.resource != index) continue;
        Event e = blank;
        e.moment = moment;
        e.last = true;
        add_use(frame.graph, {final_use.resource, final_use.access}, e);
        cell.events.push_back(e);
    }
}

Oracle::Oracle(std::vector<Frame> frames) : frames_(std::move(frames))
{
    const GraphDesc& graph = frames_.front().graph;
    for (ResourceIndex r = 0; r < graph.resources.size(); ++r) {
        const ResourceDesc& resource = graph.resources[r];
        for (std::uint32_t layer = 0; layer < (resource.is_image ? resource.layers : 1); ++layer) {
            for (std::uint32_t mip = 0; mip < (resource.is_image ? resource.mips : 1); ++mip) {
                PartState before{resource.initial, resource.initial_wait, resource.initial != Access::none};
                if (!resource.initial_parts.empty())
                    before = resource.initial_parts[std::size_t{layer} * resource.mips + mip];
                Cell cell{r, before, {}};
                add_past(resource, cell);
                for (std::size_t f = 0; f < frames_.size(); ++f) add_frame(f, mip, layer, cell);
                cells_.push_back(std::move(cell));
            }
        }
    }
}

bool Oracle::share(ResourceIndex a, ResourceIndex b) const
{
    const Frame& frame = frames_.front();
    const Placement &pa = frame.plan.placements[a], &pb = frame.plan.placements[b];
    return a != b && pa.block != ~0u && pa.block == pb.block && pa.offset < pb.offset + frame.graph.resources[b].size &&
           pb.offset < pa.offset + frame.graph.resources[a].size;
}

std::string Oracle::check_cell(const Cell& cell, const std::optional<BarrierId>& left_out) const
{
    const ResourceDesc& resource = frames_.front().graph.resources[cell.resource];
    const std::vector<const Event*> events = chosen(cell.events, left_out);
    for (std::size_t i = 1; i < events.size(); ++i) {
        if (events[i]->kind == Event::Kind::barrier && events[i - 1]->kind == Event::Kind::barrier &&
            events[i]->moment == events[i - 1]->moment) {
            return "two barriers at once on one subresource of " + resource.name;
        }
    }
    const bool has_layout = resource.is_image && !resource.transient;
    std::string what =
        check_layouts(events, resource, has_layout ? gpu::info(cell.before.last).layout : VK_IMAGE_LAYOUT_UNDEFINED,
                      cell.before.defined);
    if (what.empty()) what = check_order(events, false);
    return what.empty() ? "" : resource.name + ": " + what;
}

std::string Oracle::check_pair(const Cell& a, const Cell& b, const std::optional<BarrierId>& left_out) const
{
    const std::vector<const Event*> of_a = chosen(a.events, left_out), of_b = chosen(b.events, left_out);
    std::vector<const Event*> events;
    std::merge(of_a.begin(), of_a.end(), of_b.begin(), of_b.end(), std::back_inserter(events),
               [](const Event* x, const Event* y) { return x->moment < y->moment; });
    return check_order(events, true);
}

std::string Oracle::problem() const
{
    for (std::size_t i = 0; i < cells_.size(); ++i) {
        if (std::string what = check_cell(cells_[i], std::nullopt); !what.empty()) return what;
        for (std::size_t j = i + 1; j < cells_.size(); ++j) {
            if (!share(cells_[i].resource, cells_[j].resource)) continue;
            if (std::string what = check_pair(cells_[i], cells_[j], std::nullopt); !what.empty()) return what;
        }
    }
    return "";
}

std::string Oracle::problem_without(const BarrierId& left_out) const
{
    const std::vector<ResourceIndex>& of = frames_[left_out.frame].memory_of;
    const ResourceIndex named = barrier(left_out).resource, resource = of.empty() ? named : of[named];
    for (const Cell& cell : cells_) {
        if (cell.resource != resource) continue;
        if (std::string what = check_cell(cell, left_out); !what.empty()) return what;
    }
    for (const Cell& cell : cells_) {
        if (cell.resource != resource) continue;
        for (const Cell& other : cells_) {
            if (!share(resource, other.resource)) continue;
            if (std::string what = check_pair(cell, other, left_out); !what.empty()) return what;
        }
    }
    return "";
}

const Barrier& Oracle::barrier(const BarrierId& id) const
{
    const Plan& plan = frames_[id.frame].plan;
    return id.pass == plan.passes.size() ? plan.final_barriers[id.barrier] : plan.passes[id.pass].barriers[id.barrier];
}

std::vector<BarrierId> Oracle::barriers() const
{
    std::vector<BarrierId> out;
    for (std::size_t f = 0; f < frames_.size(); ++f) {
        const Plan& plan = frames_[f].plan;
        for (std::size_t p = 0; p <= plan.passes.size(); ++p) {
            const std::size_t count =
                p == plan.passes.size() ? plan.final_barriers.size() : plan.passes[p].barriers.size();
            for (std::size_t b = 0; b < count; ++b) out.push_back({f, p, b});
        }
    }
    return out;
}

} // namespace atrium::graph::oracle
