#pragma once
// Random graphs that obey the rules of make_plan(), each the same for the same seed.

#include "tests/graph/plan_oracle.hpp"

#include <cstdint>

namespace atrium::graph {

/// A frame without its plan.
[[nodiscard]] oracle::Frame random_frame(std::uint64_t seed);

/// The same frame once more, its imported resources as `previous` left them.
[[nodiscard]] oracle::Frame next_frame(const oracle::Frame& previous);

} // namespace atrium::graph
