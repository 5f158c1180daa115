#pragma once
// An independent judge of plans: plays frames through a small model of Vulkan's memory and asks of every two uses of
// overlapping memory whether barriers put them in order. Slow and plain on purpose, and shares no code with the
// planner.
//
// The model. Work of a stage is before a barrier when the barrier's source stages name that stage, or when an earlier
// barrier carried the work to a stage that they name (chain). Then all work in the destination stages is after it.
// A write is available once a barrier names its stage and its access as source; visible to a stage and an access once
// that barrier, or a later one in a chain from it, names them as destination. A change of layout reads and writes: all
// uses before must be ordered before it, the writes among them available, and it is itself available, and visible to
// the destination of its barrier. Stricter than Vulkan: only barriers on the memory in question count, the order of
// stages within a pipeline does not, and a write too needs the write before to be visible to it.

#include "renderer/graph/plan.hpp"

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace atrium::graph::oracle {

struct Frame {
    GraphDesc graph;
    std::vector<FinalUse> finals;
    Plan plan;
    /// For each resource of this frame, the resource of the first frame that has its memory; empty: the same one. Pairs
    /// of a history swap.
    std::vector<ResourceIndex> memory_of{};
    /// Images of this frame, and what the one before left in their place.
    std::vector<std::pair<ResourceIndex, ResourceIndex>> histories{};
    std::vector<PassDesc> passes_with_history{}; ///< when histories are valid
};

/// One barrier of one frame. `pass` is an index into the plan's passes, or their number for the final barriers.
struct BarrierId {
    std::size_t frame = 0, pass = 0, barrier = 0;
    bool operator==(const BarrierId&) const = default;
};

/// Something that happens to one subresource, in the order of `moment`.
struct Event {
    enum class Kind { use, barrier, acquire, unknown_write };
    Kind kind = Kind::use;
    std::size_t moment = 0, frame = 0;
    bool past = false; ///< before the first frame: nothing to check
    bool last = false; ///< final use
    bool discard = false, consumes = false;
    VkPipelineStageFlags2 stages = 0;
    VkAccessFlags2 access = 0, writes = 0;
    std::vector<VkImageLayout> layouts; ///< those that the uses demand
    Barrier barrier;
    BarrierId id;
    std::string name;
};

/// The frames one after the other on one queue: the transients of all have the same memory, imported ones go on.
class Oracle {
public:
    explicit Oracle(std::vector<Frame> frames);

    /// The first thing wrong, in words; empty when nothing is.
    [[nodiscard]] std::string problem() const;
    /// The same with one barrier left out. Looks only at the memory that this barrier is about.
    [[nodiscard]] std::string problem_without(const BarrierId& left_out) const;
    [[nodiscard]] std::vector<BarrierId> barriers() const;
    [[nodiscard]] const Barrier& barrier(const BarrierId& id) const;

private:
    struct Cell {
        ResourceIndex resource; ///< of the first frame
        PartState before;
        std::vector<Event> events;
    };
    void add_past(const ResourceDesc& resource, Cell& cell) const;
    [[nodiscard]] ResourceIndex index_in(std::size_t f, ResourceIndex memory) const;
    void add_frame(std::size_t f, std::uint32_t mip, std::uint32_t layer, Cell& cell) const;
    [[nodiscard]] std::string check_cell(const Cell& cell, const std::optional<BarrierId>& left_out) const;
    [[nodiscard]] std::string check_pair(const Cell& a, const Cell& b, const std::optional<BarrierId>& left_out) const;
    [[nodiscard]] bool share(ResourceIndex a, ResourceIndex b) const;

    std::vector<Frame> frames_;
    std::vector<Cell> cells_;
};

/// What is wrong with the choice of passes, or with the placing of transients; empty when nothing is.
[[nodiscard]] std::string passes_problem(const Frame& frame);
[[nodiscard]] std::string placement_problem(const Frame& frame);
/// Errors in the choice of attachments that are not stored, and in the state of contents passed to the next frame.
[[nodiscard]] std::string contents_problem(const Frame& frame);

} // namespace atrium::graph::oracle
