#pragma once
// Pipelines, made on demand from small descriptions: keyed, cached in memory and (the driver's part) on disk.

#include "renderer/gpu/descriptors.hpp"
#include "renderer/gpu/format.hpp"

#include <compare>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <mutex>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace atrium::gpu {

enum class VertexInput : std::uint8_t { none, scene }; ///< none: made from gl_VertexIndex; scene: atrium::Vertex
enum class Blend : std::uint8_t { off, add, alpha };
enum class DepthTest : std::uint8_t {
    off,
    greater_equal,
    equal_zero
}; ///< reversed depth; equal_zero: only where nothing was drawn

/// Primitive topology. Patches are required for tessellation and allowed only with it.
enum class Topology : std::uint8_t { triangles, lines, points, patches };

/// What a pass draws with. Formats and sample count come from the pass's attachments; cull mode is dynamic state.
/// Shaders are named by their path below shaders/; an empty name means that the stage is not used.
struct GraphicsPipelineDesc {
    std::string vertex, fragment;                              ///< no fragment shader if only depth is drawn
    std::string tessellation_control, tessellation_evaluation; ///< both or none; OptionalFeatures::tessellation
    std::string geometry;                                      ///< OptionalFeatures::geometry
    VertexInput input = VertexInput::none;
    Topology topology = Topology::triangles;
    std::uint32_t patch_points = 0; ///< control points of a patch
    Blend blend = Blend::off;       ///< of every target
    std::vector<Blend> blends;      ///< one per target, instead of `blend`; empty: `blend` for all
    DepthTest depth_test = DepthTest::off;
    bool depth_write = false;
    bool lines = false;                   ///< edges of triangles only; OptionalFeatures::lines
    std::vector<std::uint32_t> constants; ///< specialisation constants 0, 1, … of all stages
    std::vector<Format> colors;           ///< filled in by the graph
    Format depth = Format::none;          ///< filled in by the graph
    std::uint32_t samples = 1;            ///< filled in by the graph
    PassLayout pass_layout = 0;           ///< of set 2, filled in by the graph
    /// The shaders of all used stages.
    [[nodiscard]] std::vector<std::string> shaders() const;
    auto operator<=>(const GraphicsPipelineDesc&) const = default;
};

struct ComputePipelineDesc {
    std::string shader;
    std::vector<std::uint32_t> constants;
    PassLayout pass_layout = 0; ///< of set 2, filled in by the graph
    auto operator<=>(const ComputePipelineDesc&) const = default;
};

/// SPIR-V of a shader by its path below shaders/; empty when there is none.
using ShaderLookup = std::function<std::span<const std::uint32_t>(std::string_view name)>;

class Pipelines {
public:
    /// `cache_folder`: where the driver's pipeline cache is kept; a stale or damaged file there is ignored.
    Pipelines(const Device& device, const Descriptors& descriptors, ShaderLookup shaders,
              const std::filesystem::path& cache_folder);
    ~Pipelines(); ///< writes the cache back when it grew
    Pipelines(const Pipelines&) = delete;
    Pipelines& operator=(const Pipelines&) = delete;

    /// Compiles those that do not exist yet, on all cores.
    void prepare(std::span<const GraphicsPipelineDesc> graphics, std::span<const ComputePipelineDesc> compute);
    [[nodiscard]] VkPipeline get(const GraphicsPipelineDesc& desc);
    [[nodiscard]] VkPipeline get(const ComputePipelineDesc& desc);
    [[nodiscard]] bool exists(const GraphicsPipelineDesc& desc) const { return graphics_.contains(desc); }
    [[nodiscard]] bool exists(const ComputePipelineDesc& desc) const { return compute_.contains(desc); }
    /// The bindings in set 2 of a shader that the program was built with, in ascending order.
    [[nodiscard]] const std::vector<PassBinding>& pass_bindings(const std::string& shader);
    /// Puts other code in the place of a shader's, also in the pipelines that exist. No frame is in flight. Throws
    /// Error, and changes nothing, where the code wants other inputs than what is embedded, or the driver refuses it.
    void replace(const std::string& shader, std::span<const std::uint32_t> code);
    [[nodiscard]] std::size_t count() const { return graphics_.size() + compute_.size(); }

private:
    template <class Desc>
    using Made = std::map<Desc, VkPipeline>;
    [[nodiscard]] VkShaderModule create_module(const std::string& name, std::span<const std::uint32_t> code) const;
    [[nodiscard]] std::span<const std::uint32_t> code_of(const std::string& name) const;
    [[nodiscard]] VkShaderModule module(const std::string& name);
    [[nodiscard]] VkPipeline create(const GraphicsPipelineDesc& desc);
    [[nodiscard]] VkPipeline create(const ComputePipelineDesc& desc);
    void destroy(VkPipeline pipeline) const;

    const Device& device_;
    const Descriptors& descriptors_;
    ShaderLookup shaders_;
    std::filesystem::path cache_file_;
    VkPipelineCache cache_ = VK_NULL_HANDLE;
    std::size_t cache_size_at_start_ = 0;
    std::mutex mutex_;
    std::map<std::string, VkShaderModule> modules_;
    std::map<std::string, std::vector<PassBinding>> pass_bindings_; ///< by shader
    Made<GraphicsPipelineDesc> graphics_;
    Made<ComputePipelineDesc> compute_;
};

} // namespace atrium::gpu
