#pragma once
// GPU time per pass, from timestamps.

#include "renderer/gpu/device.hpp"

#include <string>
#include <vector>

namespace atrium::gpu {

enum class TimerMode {
    overlapped, ///< timestamps as they fall: passes may run into each other, single figures can mislead
    serialized, ///< full barriers around each timestamp: every figure is its pass's own, their sum is the frame
};

struct PassTime {
    std::string name;
    double ms = 0;
    double start_ms = 0; ///< from the first's start
};

class Timers {
public:
    Timers(const Device& device, std::uint32_t capacity);
    ~Timers();
    Timers(const Timers&) = delete;
    Timers& operator=(const Timers&) = delete;

    void reset(); ///< before a frame is recorded; the device must be done with the last one
    void begin(VkCommandBuffer cmd, std::string name, TimerMode mode);
    void end(VkCommandBuffer cmd, TimerMode mode);
    /// In order of begin(). The device must be done.
    [[nodiscard]] std::vector<PassTime> read() const;

private:
    void stamp(VkCommandBuffer cmd, TimerMode mode);
    const Device& device_;
    VkQueryPool pool_ = VK_NULL_HANDLE;
    std::uint32_t capacity_ = 0, used_ = 0;
    std::vector<std::string> names_;
};

} // namespace atrium::gpu
