#pragma once
// Runs graphs on a device: plans, places transient resources, issues the plan's barriers, records the passes.

#include "renderer/graph/frame_slot.hpp"
#include "renderer/graph/graph.hpp"

#include <memory>

namespace atrium::graph {

/// What one run of a graph did and took.
struct PassStats {
    std::string name;
    std::uint32_t draws = 0, pipeline_binds = 0; ///< recorded commands; a multi-draw is one
    double gpu_ms = 0;
    double gpu_start_ms = 0; ///< from the first pass's start
};
struct RunStats {
    std::vector<PassStats> passes;
    double cpu_ms = 0;  ///< building excluded: planning, placing, recording
    double wall_ms = 0; ///< from the start of recording until the device is done
};

struct PersistentSlot;

class Runner {
public:
    Runner(const gpu::Device& device, gpu::Descriptors& descriptors, gpu::Pipelines& pipelines);
    ~Runner();

    /// Compiles missing pipelines, records, submits and waits. If it throws before it submits, persistent resources
    /// keep their contents, except those that had to be created again.
    RunStats run(Graph& graph, gpu::TimerMode mode = gpu::TimerMode::overlapped, const gpu::SubmitSync& sync = {});

    /// The plan of the last graph that ran, as text or Graphviz.
    [[nodiscard]] std::string plan_text() const { return to_text(described_, plan_); }
    [[nodiscard]] std::string plan_dot() const { return to_dot(described_, plan_); }
    [[nodiscard]] const Plan& plan() const { return plan_; }
    [[nodiscard]] const GraphDesc& planned() const { return described_; } ///< what `plan()` is of

    /// Releases persistent resources except those of Owner::program; to be called when the scene changes.
    void forget();

private:
    friend class Cmd;
    friend class Graph;
    struct Transients;
    [[nodiscard]] GraphDesc describe(const Graph& graph);
    [[nodiscard]] std::vector<PartState> parts_before(const Graph& graph, ResourceIndex r) const;
    void create_persistents(const Graph& graph);
    void commit(const Graph& graph);
    void prepare_pipelines(Graph& graph);
    void lay_out_bindings(const Graph& graph, Pass& pass);
    void place(const Graph& graph);
    void record(VkCommandBuffer cmd, Graph& graph, gpu::TimerMode mode, RunStats& stats);
    void bind_resources(VkCommandBuffer cmd, const Pass& pass);
    void issue(VkCommandBuffer cmd, const std::vector<Barrier>& barriers) const;
    void begin_rendering(VkCommandBuffer cmd, const Pass& pass, std::uint64_t unstored) const;
    [[nodiscard]] const gpu::Image& image(ResourceIndex r) const;
    [[nodiscard]] VkImage image_of(ResourceIndex r) const;
    [[nodiscard]] VkBuffer buffer_of(ResourceIndex r) const;

    const gpu::Device& device_;
    gpu::Descriptors& descriptors_;
    gpu::Pipelines& pipelines_;
    FrameSlot slot_;
    std::unique_ptr<Transients> transients_;
    std::unique_ptr<Persistents> persistents_;
    std::vector<const PersistentSlot*> slots_; ///< by resource of the graph that runs; null: not persistent
    const Graph* graph_ = nullptr;             ///< while it runs
    GraphDesc described_;
    Plan plan_;
};

/// Turns planned barriers into one vkCmdPipelineBarrier2. `image_of` and `buffer_of` map resources to handles (null
/// where the resource is of the other kind); depth images are told by `is_depth`.
void issue_barriers(VkCommandBuffer cmd, const std::vector<Barrier>& barriers,
                    const std::function<VkImage(ResourceIndex)>& image_of,
                    const std::function<VkBuffer(ResourceIndex)>& buffer_of,
                    const std::function<bool(ResourceIndex)>& is_depth);

/// Viewport and scissor; of negative height, so that clip y points up everywhere.
void set_viewport(VkCommandBuffer cmd, uvec2 origin, uvec2 size);

} // namespace atrium::graph
