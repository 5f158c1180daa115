#pragma once
// Times and counts over frames, as `--stats` writes them.

#include "renderer/engine.hpp"

#include <chrono>
#include <span>
#include <string>
#include <vector>

namespace atrium::app {

[[nodiscard]] inline double ms_since(std::chrono::steady_clock::time_point start)
{
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

/// Middle value; of an even number the mean of the middle two. 0 for none.
[[nodiscard]] double median(std::vector<double> values);

class StatsRecorder {
public:
    StatsRecorder(const Engine& engine, uvec2 size) : engine_(engine), size_(size) {}
    void set_load_ms(double ms) { load_ms_ = ms; }
    void add(const FrameResult& frame);
    [[nodiscard]] std::string to_json() const;

private:
    const Engine& engine_;
    uvec2 size_;
    double load_ms_ = 0;
    std::vector<double> frame_ms_, cpu_ms_;
    std::vector<std::vector<double>> pass_ms_; ///< by pass, then frame
    std::vector<graph::PassStats> passes_;     ///< counts, of the last frame
    std::uint64_t triangles_ = 0;
    std::uint32_t material_changes_ = 0;
};

} // namespace atrium::app
