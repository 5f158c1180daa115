#include "renderer/gpu/swapchain.hpp"

#include <gtest/gtest.h>

#include <array>

namespace atrium::gpu {
namespace {

TEST(present_mode, the_best_that_is_offered)
{
    constexpr std::array all{VK_PRESENT_MODE_IMMEDIATE_KHR, VK_PRESENT_MODE_MAILBOX_KHR, VK_PRESENT_MODE_FIFO_KHR,
                             VK_PRESENT_MODE_FIFO_RELAXED_KHR};
    EXPECT_EQ(choose_present_mode(PresentMode::on, all), VK_PRESENT_MODE_FIFO_KHR);
    EXPECT_EQ(choose_present_mode(PresentMode::adaptive, all), VK_PRESENT_MODE_FIFO_RELAXED_KHR);
    EXPECT_EQ(choose_present_mode(PresentMode::off, all), VK_PRESENT_MODE_IMMEDIATE_KHR);

    constexpr std::array untorn{VK_PRESENT_MODE_FIFO_KHR, VK_PRESENT_MODE_MAILBOX_KHR};
    EXPECT_EQ(choose_present_mode(PresentMode::adaptive, untorn), VK_PRESENT_MODE_FIFO_KHR);
    EXPECT_EQ(choose_present_mode(PresentMode::off, untorn), VK_PRESENT_MODE_MAILBOX_KHR);

    constexpr std::array least{VK_PRESENT_MODE_FIFO_KHR};
    for (const PresentMode wanted : {PresentMode::on, PresentMode::adaptive, PresentMode::off})
        EXPECT_EQ(choose_present_mode(wanted, least), VK_PRESENT_MODE_FIFO_KHR);
}

} // namespace
} // namespace atrium::gpu
