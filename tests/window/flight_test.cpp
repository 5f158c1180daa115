// How fluent the window is without a GPU: flying through Sponza below four soft lights.

#include "tests/window/tabs.hpp"
#include "tests/window/viewed.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace atrium::window {
namespace {

/// What one flight was, from the costs that the window wrote.
struct Flight {
    double rate = 0;         ///< frames a second while moving
    double interface_ms = 0; ///< median of the same frames
    double until_full = 1e9; ///< from before the last input to the end of the full frame, in full frames
};

/// The last one of those written.
Flight flight_of(const fs::path& costs)
{
    Flight out;
    std::vector<double> interface;
    double first = 0, last = 0;
    bool ended = true;
    const nlohmann::json all = nlohmann::json::parse(bytes_of(costs));
    for (const nlohmann::json& frame : all["frames"]) {
        const double at = frame["at_ms"];
        if (frame["scale"] < 1) {
            if (std::exchange(ended, false)) {
                interface.clear();
                first = at;
            }
            last = at;
            interface.push_back(frame["interface_ms"]);
        } else if (!std::exchange(ended, true)) {
            const double full = frame["frame_ms"];
            out.until_full = (at + full - last) / full; // the key was still down when the last moving frame began
        }
    }
    if (interface.size() < 2) return out;
    out.rate = 1000 * static_cast<double>(interface.size() - 1) / (last - first);
    std::nth_element(interface.begin(), interface.begin() + static_cast<std::ptrdiff_t>(interface.size() / 2),
                     interface.end());
    out.interface_ms = interface[interface.size() / 2];
    return out;
}

class Flown : public ViewedProgram {
protected:
    void SetUp() override {} // starts the program itself
};

TEST_F(Flown, sponza_below_four_soft_lights_is_fluent)
{
    if (std::getenv("ATRIUM_SCENES") == nullptr) GTEST_SKIP() << "ATRIUM_SCENES names no folder of scenes";
    const fs::path bake = folder / "sponza.atrium";
    const std::string bake_it = std::string(ATRIUM_BIN) + "/assetconv bake " + std::getenv("ATRIUM_SCENES") +
                                "/sponza/sponza_nobanner.obj --scale 0.01 --quiet -o " + bake.string();
    ASSERT_EQ(std::system(bake_it.c_str()), 0);
    std::vector<std::string> arguments{bake.string(),    "--size", "1280x720",       "--no-lights", "--set",
                                       "ao.method=gtao", "--eye",  "-11.5,1.7,-0.4", "--target",    "10,3.5,-0.4"};
    for (const char* where : {"position=-8:5:-0.4,direction=0.2:-1:0.3", "position=-2:6:-0.4,direction=-0.5:-1:0.3",
                              "position=3:6:-0.4,direction=-0.2:-1:-0.5", "position=-5:9:0,direction=0.3:-1:0.1"}) {
        arguments.emplace_back("--light");
        arguments.push_back(std::string("spot,outer=45,inner=30,size=0.3,") + where);
    }
    view(arguments);
    desktop->click(window, tabs::costs);
    ASSERT_TRUE(settle());
    // Other work on the machine can spoil one: the last of up to three counts.
    Flight flight;
    const auto fluent = [&] { return flight.rate >= 10 && flight.interface_ms <= 8 && flight.until_full <= 1.5; };
    for (int i = 0; i < 3 && !fluent(); ++i) {
        const std::string key = i % 2 == 0 ? "w" : "s";
        desktop->press(key);
        std::this_thread::sleep_for(3s);
        desktop->release(key);
        ASSERT_TRUE(settle());
        desktop->click(window, {65, 345}); // save as JSON
        desktop->move(window, {100, 500});
        ASSERT_TRUE(settle());
        flight = flight_of(folder / ("atrium.000" + std::to_string(i) + ".costs.json"));
        std::printf("%.1f frames a second, interface %.1f ms, full after %.2f full frames\n", flight.rate,
                    flight.interface_ms, flight.until_full);
    }
    EXPECT_GE(flight.rate, 10);
    EXPECT_GT(flight.interface_ms, 0);
    EXPECT_LE(flight.interface_ms, 8);
    EXPECT_LE(flight.until_full, 1.5);
}

} // namespace
} // namespace atrium::window
