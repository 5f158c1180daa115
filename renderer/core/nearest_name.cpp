#include "renderer/core/nearest_name.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace atrium {
namespace {

// What is typed may come from a hostile file; no name of ours is longer than this.
constexpr std::size_t longest_compared = 128;

/// Optimal string alignment: Damerau 1964, "A technique for computer detection and correction of spelling errors",
/// with no part edited twice.
std::size_t edit_distance(std::string_view a, std::string_view b)
{
    std::vector<std::size_t> before(b.size() + 1), above(b.size() + 1), row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) above[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t replaced = above[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            row[j] = std::min({replaced, above[j] + 1, row[j - 1] + 1});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
                row[j] = std::min(row[j], before[j - 2] + 1);
            }
        }
        before.swap(above);
        above.swap(row);
    }
    return above[b.size()];
}

} // namespace

std::string nearest_name(std::string_view typed, std::span<const std::string> candidates)
{
    typed = typed.substr(0, longest_compared);
    const std::string* best = nullptr;
    std::size_t best_distance = 0;
    for (const std::string& candidate : candidates) {
        const std::size_t distance = edit_distance(typed, std::string_view(candidate).substr(0, longest_compared));
        if (best == nullptr || distance < best_distance) {
            best = &candidate;
            best_distance = distance;
        }
    }
    return best == nullptr ? std::string() : *best;
}

} // namespace atrium
