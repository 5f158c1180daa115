#include "app/stats.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace atrium::app {

double median(std::vector<double> values)
{
    if (values.empty()) return 0;
    std::sort(values.begin(), values.end());
    const std::size_t middle = values.size() / 2;
    return values.size() % 2 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

void StatsRecorder::add(const FrameResult& frame)
{
    frame_ms_.push_back(frame.record_ms + frame.stats.wall_ms - frame.stats.cpu_ms);
    cpu_ms_.push_back(frame.record_ms);
    passes_ = frame.stats.passes;
    pass_ms_.resize(passes_.size());
    for (std::size_t i = 0; i < passes_.size(); ++i) pass_ms_[i].push_back(passes_[i].gpu_ms);
    triangles_ = frame.triangles;
    material_changes_ = frame.material_changes;
}

std::string StatsRecorder::to_json() const
{
    nlohmann::ordered_json passes = nlohmann::ordered_json::array();
    std::uint32_t draws = 0, binds = 0;
    for (std::size_t i = 0; i < passes_.size(); ++i) {
        const graph::PassStats& p = passes_[i];
        passes.push_back({{"name", p.name},
                          {"gpu_ms", median(pass_ms_[i])},
                          {"draws", p.draws},
                          {"pipeline_binds", p.pipeline_binds}});
        draws += p.draws;
        binds += p.pipeline_binds;
    }
    const nlohmann::ordered_json json{
        {"device", engine_.device().report().name},
        {"size", {size_.x, size_.y}},
        {"frames", frame_ms_.size()},
        {"load_ms", load_ms_},
        {"frame_ms", median(frame_ms_)},
        {"cpu_ms", median(cpu_ms_)},
        {"passes", passes},
        {"draws", draws},
        {"triangles", triangles_},
        {"pipeline_binds", binds},
        {"material_changes", material_changes_},
        {"memory_bytes", engine_.device().memory_in_use()},
        {"validation_messages", engine_.validation_messages()},
    };
    return json.dump(2) + "\n";
}

} // namespace atrium::app
