#pragma once
// Graphs of frames that never were, by names.

#include "renderer/graph_facts.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace atrium::test {

struct GraphOfFrame {
    GraphFacts facts;

    void image(const std::string& name, bool outlives_frame = false)
    {
        facts.resources.push_back({name, "R32_FLOAT", {320, 180}, 1, 230400, outlives_frame, true, {}});
    }
    void buffer(const std::string& name) { facts.resources.push_back({name, "", {}, 1, 1024, false, false, {}}); }
    void pass(const std::string& name, const std::vector<std::string>& reads, const std::vector<std::string>& writes)
    {
        for (const bool writing : {false, true}) {
            for (const std::string& resource : writing ? writes : reads) {
                const auto found = std::find_if(facts.resources.begin(), facts.resources.end(),
                                                [&](const GraphResourceFacts& r) { return r.name == resource; });
                const auto index = static_cast<std::size_t>(found - facts.resources.begin());
                facts.uses.push_back(
                    {facts.passes.size(), index, writing, writing ? "color_write" : "sampled_fragment"});
            }
        }
        facts.passes.push_back({name, 1.5});
    }
};

} // namespace atrium::test
