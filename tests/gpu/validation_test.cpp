// The counter of validation messages counts: a hazard planted on purpose is seen.

#include "renderer/gpu/resources.hpp"

#include <gtest/gtest.h>

namespace atrium::gpu {
namespace {

constexpr VkBufferUsageFlags target = VK_BUFFER_USAGE_TRANSFER_DST_BIT;

TEST(validation, counts_a_planted_hazard)
{
    const Instance instance(true);
    const Device device(instance, choose_device(instance, ""));
    const Buffer buffer(device, "raced over", 1024, target, MemoryUse::device);
    device.run([&](VkCommandBuffer cmd) { // two writes of one buffer and no barrier between them
        vkCmdFillBuffer(cmd, buffer.handle(), 0, VK_WHOLE_SIZE, 1);
        vkCmdFillBuffer(cmd, buffer.handle(), 0, VK_WHOLE_SIZE, 2);
    });
    EXPECT_GE(instance.validation().count(), 1u);
    ASSERT_FALSE(instance.validation().messages().empty());
    EXPECT_NE(instance.validation().messages().front().find("SYNC-HAZARD-WRITE-AFTER-WRITE"), std::string::npos);
}

TEST(validation, is_silent_about_one_fill)
{
    const Instance instance(true);
    const Device device(instance, choose_device(instance, ""));
    const Buffer buffer(device, "filled once", 1024, target, MemoryUse::device);
    device.run([&](VkCommandBuffer cmd) { vkCmdFillBuffer(cmd, buffer.handle(), 0, VK_WHOLE_SIZE, 1); });
    EXPECT_EQ(instance.validation().count(), 0u);
}

TEST(device_choice, refuses_a_name_that_no_device_has_and_lists_reasons)
{
    const Instance instance(false);
    EXPECT_FALSE(list_devices(instance).empty());
    EXPECT_ANY_THROW(static_cast<void>(choose_device(instance, "no such device anywhere")));
    EXPECT_EQ(choose_device(instance, "0").index, 0u);
}

} // namespace
} // namespace atrium::gpu
