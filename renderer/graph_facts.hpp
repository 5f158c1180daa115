#pragma once
// What a frame's graph was, as plain facts for who shows it.

#include "renderer/core/math.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace atrium {

namespace graph {
class Graph;
class Runner;
struct RunStats;
} // namespace graph
struct Frame;

struct GraphPassFacts {
    std::string name;
    double gpu_ms = 0;
};

/// An image or buffer that passes use.
struct GraphResourceFacts {
    std::string name;
    std::string format; ///< of an image; empty: it is a buffer
    uvec2 size{0};      ///< of an image, texels
    std::uint32_t layers = 1;
    std::uint64_t bytes = 0;         ///< of device memory
    bool outlives_frame = false;     ///< else it has memory only from its first pass to its last
    bool can_be_shown = false;       ///< as the AOV "graph.NAME"
    std::vector<std::size_t> shares; ///< the resources that have part of the same memory at other times
};

struct GraphUseFacts {
    std::size_t pass = 0, resource = 0; ///< by their places below
    bool writes = false;
    std::string access; ///< as the graph's text calls it
};

struct GraphFacts {
    std::vector<GraphPassFacts> passes; ///< that ran, in order, but those that only look at images
    std::vector<GraphResourceFacts> resources;
    std::vector<GraphUseFacts> uses; ///< by pass
};

/// Of the frame that ran last.
[[nodiscard]] GraphFacts make_graph_facts(const graph::Graph& g, const Frame& frame, const graph::Runner& runner,
                                          const graph::RunStats& stats);

} // namespace atrium
