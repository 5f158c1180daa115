#include "app/gui/cost_history.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <string>

namespace atrium::gui {
namespace {

using Json = nlohmann::json;

FrameCost frame(double at_ms)
{
    return {at_ms, 2, 10, {{"gbuffer", 3, 7, 0.5}, {"lighting \"a\"", 4, 1, 4}}, 1000};
}

TEST(cost_history, keeps_the_newest_frames_and_every_pass_s_index)
{
    CostHistory costs;
    for (std::size_t i = 0; i < CostHistory::longest + 5; ++i) costs.add(frame(static_cast<double>(i)));
    EXPECT_EQ(costs.frames().size(), CostHistory::longest);
    EXPECT_EQ(costs.frames().front().at_ms, 5);
    FrameCost other = frame(0);
    other.passes = {{"bloom", 1, 1, 0}};
    costs.add(other);
    EXPECT_EQ(costs.frames().back().passes[0].index, 2u);
    costs.add(frame(0));
    EXPECT_EQ(costs.frames().back().passes[0].index, 0u);
    EXPECT_EQ(costs.frames().back().passes[1].index, 1u);
}

TEST(cost_history, is_written_as_json)
{
    CostHistory costs;
    costs.add(frame(100));
    costs.shown(4);
    costs.shown(5); // the same frame again, such as below a mouse that moves
    const Json json = Json::parse(costs.to_json("a device"));
    EXPECT_EQ(json["device"], "a device");
    ASSERT_EQ(json["frames"].size(), 1u);
    const Json& only = json["frames"][0];
    EXPECT_EQ(only["frame_ms"], 10);
    EXPECT_EQ(only["cpu_ms"], 2);
    EXPECT_EQ(only["interface_ms"], 4);
    EXPECT_EQ(only["scale"], 1);
    EXPECT_EQ(only["memory_bytes"], 1000);
    EXPECT_EQ(only["passes"][1]["name"], "lighting \"a\"");
    EXPECT_EQ(only["passes"][0]["gpu_ms"], 3);
    EXPECT_EQ(only["passes"][0]["draws"], 7);
}

TEST(cost_history, is_written_as_a_trace_in_microseconds)
{
    CostHistory costs;
    costs.add(frame(100));
    costs.add(frame(120));
    const Json events = Json::parse(costs.to_trace("a device"))["traceEvents"];
    int passes = 0, counters = 0, names = 0;
    for (const Json& event : events) {
        const std::string phase = event["ph"];
        names += phase == "M";
        counters += phase == "C";
        if (phase != "X" || event["tid"] != 2) continue;
        ++passes;
        if (event["name"] == "gbuffer" && passes == 1) {
            EXPECT_EQ(event["ts"], 102500); // 100 ms, recorded for 2, half a ms later
            EXPECT_EQ(event["dur"], 3000);
            EXPECT_EQ(event["args"]["draws"], 7);
        }
    }
    EXPECT_EQ(passes, 4);
    EXPECT_EQ(counters, 2);
    EXPECT_EQ(names, 2);
    EXPECT_TRUE(Json::parse(CostHistory().to_trace("none"))["traceEvents"].is_array());
}

} // namespace
} // namespace atrium::gui
