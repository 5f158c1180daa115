#include "app/gui/cost_history.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <utility>

namespace atrium::gui {
namespace {

using Json = nlohmann::ordered_json;

constexpr int processor = 1, device_queue = 2; // threads of a trace

Json thread_name(int thread, const std::string& name)
{
    return {{"name", "thread_name"}, {"ph", "M"}, {"pid", 1}, {"tid", thread}, {"args", {{"name", name}}}};
}

Json complete_event(int thread, const std::string& name, double start_ms, double ms)
{
    return {{"name", name}, {"ph", "X"}, {"ts", 1000 * start_ms}, {"dur", 1000 * ms}, {"pid", 1}, {"tid", thread}};
}

} // namespace

void CostHistory::add(FrameCost frame)
{
    for (PassCost& pass : frame.passes) {
        const auto known = std::find(names_.begin(), names_.end(), pass.name);
        pass.index = static_cast<std::size_t>(known - names_.begin());
        if (known == names_.end()) names_.push_back(pass.name);
    }
    frames_.push_back(std::move(frame));
    if (frames_.size() > longest) frames_.pop_front();
}

void CostHistory::shown(double interface_ms)
{
    if (!frames_.empty() && frames_.back().interface_ms == 0) frames_.back().interface_ms = interface_ms;
}

std::string CostHistory::to_json(const std::string& device) const
{
    Json frames = Json::array();
    for (const FrameCost& frame : frames_) {
        Json passes = Json::array();
        for (const PassCost& p : frame.passes)
            passes.push_back({{"name", p.name}, {"gpu_ms", p.ms}, {"gpu_start_ms", p.start_ms}, {"draws", p.draws}});
        frames.push_back({{"at_ms", frame.at_ms},
                          {"frame_ms", frame.frame_ms},
                          {"cpu_ms", frame.cpu_ms},
                          {"interface_ms", frame.interface_ms},
                          {"scale", frame.scale},
                          {"memory_bytes", frame.memory_bytes},
                          {"passes", std::move(passes)}});
    }
    return Json{{"device", device}, {"frames", std::move(frames)}}.dump(1) + "\n";
}

std::string CostHistory::to_trace(const std::string& device) const
{
    Json events{thread_name(processor, "processor"), thread_name(device_queue, device)};
    for (const FrameCost& frame : frames_) {
        events.push_back(complete_event(processor, "frame", frame.at_ms, frame.frame_ms));
        events.push_back(complete_event(processor, "record", frame.at_ms, frame.cpu_ms));
        for (const PassCost& p : frame.passes) {
            Json event = complete_event(device_queue, p.name, frame.at_ms + frame.cpu_ms + p.start_ms, p.ms);
            event["args"] = {{"draws", p.draws}};
            events.push_back(std::move(event));
        }
        events.push_back({{"name", "device memory"},
                          {"ph", "C"},
                          {"ts", 1000 * frame.at_ms},
                          {"pid", 1},
                          {"args", {{"bytes", frame.memory_bytes}}}});
    }
    return Json{{"traceEvents", std::move(events)}, {"displayTimeUnit", "ms"}}.dump() + "\n";
}

} // namespace atrium::gui
