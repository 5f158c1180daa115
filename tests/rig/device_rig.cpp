#include "tests/rig/device_rig.hpp"

#include "shaders/embedded.hpp"

#include <gtest/gtest.h>

#include <memory>

namespace atrium::test_shaders {
std::span<const std::uint32_t> find(std::string_view name); // tests/rig/CMakeLists.txt
}

namespace atrium::rig {
namespace {

std::unique_ptr<DeviceRig> g_rig; // NOLINT: one for the program

/// Ends the device before static destruction, and looks at what validation said.
class Ending : public testing::Environment {
    void TearDown() override
    {
        if (!g_rig) return;
        EXPECT_EQ(g_rig->instance.validation().count(), 0u) << "the validation layer complained; see above";
        g_rig.reset();
    }
};
testing::Environment* const g_ending = testing::AddGlobalTestEnvironment(new Ending); // NOLINT

} // namespace

std::span<const std::uint32_t> find_shader(std::string_view name)
{
    const auto own = shaders::find(name);
    return own.empty() ? test_shaders::find(name) : own;
}

DeviceRig::DeviceRig()
    : instance(true), device(instance, gpu::choose_device(instance, "")), descriptors(device),
      pipelines(device, descriptors, find_shader, {}), runner(device, descriptors, pipelines)
{}

DeviceRig& device()
{
    if (!g_rig) g_rig = std::make_unique<DeviceRig>();
    return *g_rig;
}

} // namespace atrium::rig
