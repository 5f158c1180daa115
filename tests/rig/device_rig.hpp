#pragma once
// One device for a whole test program, under validation: a message of the layer fails the program.

#include "renderer/gpu/pipelines.hpp"
#include "renderer/graph/runner.hpp"

namespace atrium::rig {

/// Shaders of the product and, by their path below tests/, of the tests.
[[nodiscard]] std::span<const std::uint32_t> find_shader(std::string_view name);

struct DeviceRig {
    DeviceRig();
    gpu::Instance instance;
    gpu::Device device;
    gpu::Descriptors descriptors;
    gpu::Pipelines pipelines;
    graph::Runner runner;
};

[[nodiscard]] DeviceRig& device();

} // namespace atrium::rig
