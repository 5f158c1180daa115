#include "app/gui/graph_boxes.hpp"

#include <algorithm>
#include <string_view>

namespace atrium::gui {
namespace {

/// "a.b" of "a.b.12", and of anything else nothing.
std::string_view series_of(std::string_view name)
{
    const std::size_t end = name.find_last_not_of("0123456789");
    const bool numbered = end != std::string_view::npos && end + 1 < name.size() && name[end] == '.';
    return numbered ? name.substr(0, end) : std::string_view{};
}

/// Passes in groups, each of which is to be one box.
std::vector<GraphBox> group_passes(const GraphFacts& graph)
{
    std::vector<GraphBox> out;
    std::string_view series;
    for (std::size_t p = 0; p < graph.passes.size(); ++p) {
        const std::string_view own = series_of(graph.passes[p].name);
        if (!own.empty() && own == series)
            ++out.back().passes;
        else
            out.push_back({p, 1, std::nullopt});
        series = own;
    }
    return out;
}

/// The groups of passes that use a resource, in order.
struct Users {
    std::vector<std::size_t> writers, readers;
};

std::vector<Users> users_of(const GraphFacts& graph, const std::vector<GraphBox>& groups)
{
    std::vector<std::size_t> group_of;
    for (std::size_t g = 0; g < groups.size(); ++g) group_of.insert(group_of.end(), groups[g].passes, g);
    std::vector<Users> out(graph.resources.size());
    for (const GraphUseFacts& use : graph.uses) {
        std::vector<std::size_t>& list = use.writes ? out[use.resource].writers : out[use.resource].readers;
        if (list.empty() || list.back() != group_of[use.pass]) list.push_back(group_of[use.pass]);
    }
    return out;
}

/// The last of `groups` before that one, if any.
std::optional<std::size_t> last_before(const std::vector<std::size_t>& groups, std::size_t group)
{
    const auto next = std::lower_bound(groups.begin(), groups.end(), group);
    return next == groups.begin() ? std::nullopt : std::optional(*(next - 1));
}

class Drawing {
public:
    explicit Drawing(const GraphFacts& graph) : groups_(group_passes(graph)), users_(users_of(graph, groups_))
    {
        add_boxes(graph);
        for (std::size_t r = 0; r < users_.size(); ++r) add_lines(r);
    }
    GraphBoxes take() { return std::move(out_); }

private:
    /// Images that nobody writes stand first, each other behind the last group that writes it.
    void add_boxes(const GraphFacts& graph)
    {
        image_box_.resize(users_.size());
        group_box_.resize(groups_.size());
        const auto add_images = [&](const auto& stands_here) {
            for (std::size_t r = 0; r < users_.size(); ++r) {
                const bool used = !users_[r].writers.empty() || !users_[r].readers.empty();
                if (!graph.resources[r].can_be_shown || !used || !stands_here(users_[r].writers)) continue;
                image_box_[r] = out_.boxes.size();
                out_.boxes.push_back({0, 0, r});
            }
        };
        add_images([](const auto& writers) { return writers.empty(); });
        for (std::size_t g = 0; g < groups_.size(); ++g) {
            group_box_[g] = out_.boxes.size();
            out_.boxes.push_back(groups_[g]);
            add_images([g](const auto& writers) { return !writers.empty() && writers.back() == g; });
        }
    }

    void add_line(std::size_t from, std::size_t to, std::size_t resource)
    {
        const GraphLine line{from, to, resource};
        if (std::find(out_.lines.begin(), out_.lines.end(), line) == out_.lines.end()) out_.lines.push_back(line);
    }

    void add_lines(std::size_t resource)
    {
        const std::vector<std::size_t>&writers = users_[resource].writers, &readers = users_[resource].readers;
        const std::optional<std::size_t> box = image_box_[resource];
        const auto add_from_writer = [&](std::size_t group) {
            if (const auto writer = last_before(writers, group))
                add_line(group_box_[*writer], group_box_[group], resource);
        };
        for (const std::size_t writer : writers) {
            if (box) add_line(group_box_[writer], *box, resource);
            add_from_writer(writer);
        }
        for (const std::size_t reader : readers) {
            if (box && (writers.empty() || reader > writers.back()))
                add_line(*box, group_box_[reader], resource);
            else
                add_from_writer(reader);
        }
    }

    GraphBoxes out_;
    std::vector<GraphBox> groups_;
    std::vector<Users> users_;                          ///< by resource
    std::vector<std::size_t> group_box_;                ///< by group
    std::vector<std::optional<std::size_t>> image_box_; ///< by resource
};

} // namespace

GraphBoxes make_graph_boxes(const GraphFacts& graph)
{
    return Drawing(graph).take();
}

} // namespace atrium::gui
