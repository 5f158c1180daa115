#pragma once
// What the last frames took, and as text for other programs. No ImGui.

#include <cstddef>
#include <cstdint>
#include <deque>
#include <string>
#include <vector>

namespace atrium::gui {

struct PassCost {
    std::string name;
    double ms = 0;
    std::uint32_t draws = 0;
    double start_ms = 0;   ///< on the device, from the first pass's start
    std::size_t index = 0; ///< of its name among all so far: CostHistory::add() tells
};

struct FrameCost {
    double at_ms = 0;             ///< when it began, from the history's start
    double cpu_ms = 0;            ///< until everything was recorded
    double frame_ms = 0;          ///< until the device was done
    std::vector<PassCost> passes; ///< in the order in which they ran
    std::uint64_t memory_bytes = 0;
    double scale = 1;        ///< share of the window's pixels along each side that was drawn
    double interface_ms = 0; ///< what the interface took in the window's frame that first showed it
};

class CostHistory {
public:
    static constexpr std::size_t longest = 240; ///< frames: then the oldest goes

    /// A pass of one name keeps its index, so that it can have a colour of its own.
    void add(FrameCost frame);
    /// The last frame is in the window for the first time; nothing where there is none, or it is not the first time.
    void shown(double interface_ms);
    [[nodiscard]] const std::deque<FrameCost>& frames() const { return frames_; }

    /// {"device", "frames": [{"at_ms", "frame_ms", "cpu_ms", "interface_ms", "scale", "memory_bytes", "passes":
    /// [{"name", "gpu_ms", "gpu_start_ms", "draws"}]}]}
    [[nodiscard]] std::string to_json(const std::string& device) const;
    /// Chrome's Trace Event Format, which ui.perfetto.dev and chrome://tracing open: complete events in microseconds on
    /// a thread for the processor and one for the device, and memory as a counter. A pass begins where its frame's
    /// recording ended, and as much later as the device says.
    [[nodiscard]] std::string to_trace(const std::string& device) const;

private:
    std::deque<FrameCost> frames_;
    std::vector<std::string> names_; ///< of all passes so far
};

} // namespace atrium::gui
