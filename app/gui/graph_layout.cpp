#include "app/gui/graph_layout.hpp"

#include <algorithm>

namespace atrium::gui {
namespace {

constexpr int sweeps = 12; ///< there and back; more change little

/// A graph's boxes, with the neighbours of each at either side.
class Boxes {
public:
    Boxes(std::span<const vec2> sizes, std::span<const GraphEdge> edges, const vec2& gaps)
        : sizes_(sizes), gaps_(gaps), before_(sizes.size()), after_(sizes.size()), corners_(sizes.size())
    {
        for (const GraphEdge& e : edges) {
            after_[e.from].push_back(e.to);
            before_[e.to].push_back(e.from);
        }
        make_columns();
    }

    std::vector<vec2> place()
    {
        for (const std::vector<std::size_t>& column : columns_) set_apart(column);
        for (int i = 0; i < sweeps; ++i) {
            for (auto& column : columns_) move_towards(column, before_);
            for (std::size_t c = columns_.size(); c-- > 0;) move_towards(columns_[c], after_);
        }
        for (auto& column : columns_) move_towards(column, before_);
        float top = 0, left = 0;
        for (const vec2& corner : corners_) top = std::min(top, corner.y);
        for (const std::vector<std::size_t>& column : columns_) {
            float width = 0;
            for (const std::size_t box : column) {
                corners_[box].x = left;
                width = std::max(width, sizes_[box].x);
            }
            left += width + gaps_.x;
        }
        for (vec2& corner : corners_) corner.y -= top;
        return corners_;
    }

private:
    using Neighbours = std::vector<std::vector<std::size_t>>;

    /// As far left as edges allow; then right again, what is joined with at least as much there.
    void make_columns()
    {
        std::vector<std::size_t> column(sizes_.size(), 0);
        for (std::size_t box = 0; box < sizes_.size(); ++box) {
            for (const std::size_t b : before_[box]) column[box] = std::max(column[box], column[b] + 1);
        }
        for (std::size_t box = sizes_.size(); box-- > 0;) {
            if (after_[box].empty() || before_[box].size() > after_[box].size()) continue;
            std::size_t first = sizes_.size();
            for (const std::size_t a : after_[box]) first = std::min(first, column[a]);
            column[box] = first - 1;
        }
        for (std::size_t box = 0; box < sizes_.size(); ++box) {
            if (columns_.size() <= column[box]) columns_.resize(column[box] + 1);
            columns_[column[box]].push_back(box);
        }
    }

    [[nodiscard]] float middle(std::size_t box) const { return corners_[box].y + 0.5f * sizes_[box].y; }

    /// Each box to the mean height of its neighbours, its barycentre, as far as there is room.
    void move_towards(std::vector<std::size_t>& column, const Neighbours& neighbours)
    {
        for (const std::size_t box : column) {
            if (neighbours[box].empty()) continue;
            float sum = 0;
            for (const std::size_t other : neighbours[box]) sum += middle(other);
            corners_[box].y = sum / static_cast<float>(neighbours[box].size()) - 0.5f * sizes_[box].y;
        }
        std::stable_sort(column.begin(), column.end(),
                         [this](std::size_t a, std::size_t b) { return middle(a) < middle(b); });
        set_apart(column);
    }

    /// Pushes down what overlaps, and the whole column up again by the mean of that.
    void set_apart(const std::vector<std::size_t>& column)
    {
        if (column.empty()) return;
        float free = corners_[column.front()].y, pushed = 0;
        for (const std::size_t box : column) {
            const float y = std::max(corners_[box].y, free);
            pushed += y - corners_[box].y;
            corners_[box].y = y;
            free = y + sizes_[box].y + gaps_.y;
        }
        for (const std::size_t box : column) corners_[box].y -= pushed / static_cast<float>(column.size());
    }

    std::span<const vec2> sizes_;
    vec2 gaps_;
    Neighbours before_, after_; ///< by box
    std::vector<std::vector<std::size_t>> columns_;
    std::vector<vec2> corners_;
};

} // namespace

std::vector<vec2> lay_out_graph(std::span<const vec2> sizes, std::span<const GraphEdge> edges, const vec2& gaps)
{
    return Boxes(sizes, edges, gaps).place();
}

} // namespace atrium::gui
