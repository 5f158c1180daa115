#pragma once
// The frame graph's reasoning, without a device: which passes run, in which order, which barriers stand before each,
// and which transient resources may share memory. Pure data in, pure data out, so that tests can hold every decision
// against an oracle. Source: O'Donnell 2017, "FrameGraph: Extensible Rendering Architecture in Frostbite".

#include "renderer/gpu/access.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace atrium::graph {

using gpu::Access;
using ResourceIndex = std::uint32_t;

/// Mip levels and array layers of an image; buffers are always whole.
struct SubresourceRange {
    std::uint32_t first_mip = 0, mips = 1;
    std::uint32_t first_layer = 0, layers = 1;
};

/// Stages of the pipeline, and kinds of access in them.
struct Scope {
    VkPipelineStageFlags2 stages = 0;
    VkAccessFlags2 access = 0;
};

/// State of a subresource after the previous frame.
struct PartState {
    Access last = Access::none;
    Scope wait{};         ///< what must be waited for in addition to `last`
    bool defined = false; ///< it has contents that a pass wrote
};

struct ResourceDesc {
    std::string name;
    bool is_image = true;
    std::uint32_t mips = 1, layers = 1;
    std::uint32_t samples = 1;      ///< of images
    bool transient = true;          ///< lives within the frame and may share memory; else imported
    bool keep = false;              ///< wanted after the frame: its writers are never dropped
    Access initial = Access::none;  ///< imported: how it was last used before this frame
    std::uint64_t size = 0;         ///< transient: bytes of memory; 0: it brings its own and is not placed
    std::uint64_t alignment = 1;    ///< a power of two
    std::uint32_t memory_class = 0; ///< only resources of one class may share memory
    /// Imported, used before: what else there is to wait for, beside `initial`: the last plan's `final_waits`.
    Scope initial_wait{};
    /// Imported: the state of each subresource (layer after layer, the mips of each together), from the last plan's
    /// `final_parts`. Replaces `initial` and `initial_wait`; a subresource that is not defined must be written before
    /// it is read. Empty: all subresources have the same state and have contents.
    std::vector<PartState> initial_parts{};
};

struct Use {
    ResourceIndex resource = 0;
    Access access = Access::none;
    SubresourceRange range{}; ///< ignored for buffers
    bool discard = false;     ///< the pass overwrites the range: earlier contents do not matter
    bool as_array = false;    ///< sampled as an array, even with one layer; not used by the plan
};

struct PassDesc {
    std::string name;
    std::vector<Use> uses;
    bool side_effect = false; ///< never dropped
};

struct GraphDesc {
    std::vector<ResourceDesc> resources;
    std::vector<PassDesc> passes; ///< in order of declaration; a pass reads what earlier passes wrote
};

/// One dependency of a pass. For buffers the layouts are UNDEFINED and the range is whole.
struct Barrier {
    ResourceIndex resource = 0;
    SubresourceRange range{};
    VkPipelineStageFlags2 src_stages = 0, dst_stages = 0;
    VkAccessFlags2 src_access = 0, dst_access = 0;
    VkImageLayout old_layout = VK_IMAGE_LAYOUT_UNDEFINED, new_layout = VK_IMAGE_LAYOUT_UNDEFINED;
    /// The memory comes from other resources. To the letter of Vulkan a barrier of one resource makes available only
    /// what was written through that resource: issue a VkMemoryBarrier2 of the same stages and accesses beside it.
    bool takes_memory = false;
};

struct PlannedPass {
    std::uint32_t pass = 0;        ///< index into GraphDesc::passes
    std::vector<Barrier> barriers; ///< issued together, before the pass
    /// Bit u: no one reads the result of use u, an attachment, so it is not stored. Uses from 64 on are always stored.
    std::uint64_t unstored = 0;
};

/// Where a transient resource lives: `offset` bytes into memory block `block`.
struct Placement {
    std::uint32_t block = ~0u; ///< ~0u: imported, unused, or of no size
    std::uint64_t offset = 0;
};

struct Plan {
    std::vector<PlannedPass> passes;    ///< passes that run, in order
    std::vector<std::uint32_t> dropped; ///< passes whose outputs nobody uses
    std::vector<Placement> placements;  ///< by resource
    std::vector<std::uint64_t> block_sizes;
    std::vector<std::uint32_t> block_class; ///< memory_class of each block
    std::vector<std::uint64_t> block_alignment;
    std::vector<Barrier> final_barriers; ///< empty unless `finals` asked for some
    std::vector<Access> final_access; ///< by resource: the last access (of its first subresource), for the next frame
    std::vector<Scope> final_waits;   ///< by resource: all that the next frame waits for, as `initial_wait`
    /// By resource: the state of each subresource, for the next frame. Of those with `initial_parts` only.
    std::vector<std::vector<PartState>> final_parts;
};

/// How a resource shall be left (e.g. swapchain: present). Counts as a reader after the last pass, and hands the
/// resource over: who then waits for `access` alone waits for everything that used it. Images whose subresources end in
/// different layouts need one, or the next frame's `initial` is wrong for some of them.
struct FinalUse {
    ResourceIndex resource = 0;
    Access access = Access::none;
};

/// Derives the plan. Rules: read after write waits and makes visible; write after read waits only; write after write
/// does both; a change of layout counts as a write, even before a read; a read after a read needs nothing when the
/// earlier barrier already covers its stages and access. Order is that of declaration. A pass is dropped when nothing
/// it writes is read later, kept, or given a final use, and it has no side effect. An image last presented is waited
/// for in the stages that use it next, which the acquire semaphore must hold up.
///
/// Aliasing: resources of one memory class whose lifetimes [first, last] do not meet may share memory; the first use
/// of the later one waits for every use of the earlier. What is kept or has a final use shares with nobody after it.
/// The first use of a transient also waits for what the frame before did with its memory, taking it that the same
/// graph ran; where another one did on the same memory, let the device fall idle in between.
///
/// Throws std::logic_error naming pass and resource when a pass reads (part of) a transient that no earlier pass
/// wrote, uses one range twice in ways that need two layouts (save sampled_fragment beside depth_read, which covers it
/// and decides the layout), or declares what makes no sense (ranges outside, accesses that the resource cannot have).
[[nodiscard]] Plan make_plan(const GraphDesc& graph, std::span<const FinalUse> finals = {});

/// The plan as indented text (stable, for tests and `--graph FILE.txt`) and as Graphviz (`--graph FILE.dot`).
[[nodiscard]] std::string to_text(const GraphDesc& graph, const Plan& plan);
[[nodiscard]] std::string to_dot(const GraphDesc& graph, const Plan& plan);

} // namespace atrium::graph
