#include "renderer/core/nearest_name.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

#include <fmt/format.h>

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

/// Without the dashes of an option and without the group ("ao.") that it shares with the other name.
std::string_view own_part(std::string_view name, std::string_view other)
{
    const std::size_t group = name.rfind('.');
    if (group != std::string_view::npos && other.starts_with(name.substr(0, group + 1))) name.remove_prefix(group + 1);
    name.remove_prefix(std::min(name.find_first_not_of('-'), name.size()));
    return name;
}

/// Whether a typing mistake can explain this distance between the two.
bool is_near(std::string_view typed, std::string_view candidate, std::size_t distance)
{
    constexpr std::size_t shortest_part = 3; // too many names begin with fewer letters
    const std::string_view t = own_part(typed, candidate), c = own_part(candidate, typed);
    const std::size_t letters = std::max(t.size(), c.size());
    const std::size_t allowed = std::max<std::size_t>(1, letters / 3);
    if (distance <= allowed && distance < letters) return true;
    const std::string_view last = candidate.substr(candidate.rfind('.') + 1); // npos + 1 is 0
    return (t.size() >= shortest_part && (c.starts_with(t) || typed == last)) ||
           (c.size() >= shortest_part && t.starts_with(c));
}

} // namespace

std::string nearest_name(std::string_view typed, std::span<const std::string> candidates)
{
    typed = typed.substr(0, longest_compared);
    const std::string* best = nullptr;
    std::size_t best_distance = 0;
    for (const std::string& candidate : candidates) {
        const std::string_view name = std::string_view(candidate).substr(0, longest_compared);
        const std::size_t distance = edit_distance(typed, name);
        if ((best == nullptr || distance < best_distance) && is_near(typed, name, distance)) {
            best = &candidate;
            best_distance = distance;
        }
    }
    return best == nullptr ? std::string() : *best;
}

std::string did_you_mean(std::string_view typed, std::span<const std::string> candidates, std::string_view otherwise)
{
    const std::string nearest = nearest_name(typed, candidates);
    if (nearest.empty()) return std::string(otherwise);
    return nearest.starts_with('-') ? fmt::format("did you mean {}?", nearest)
                                    : fmt::format("did you mean \"{}\"?", nearest);
}

std::string suggest_name(std::string_view typed, std::span<const std::string> candidates)
{
    constexpr std::size_t few = 12;
    std::string nearest = did_you_mean(typed, candidates);
    if (!nearest.empty() || candidates.empty() || candidates.size() > few) return nearest;
    return fmt::format("choose one of {}", fmt::join(candidates, ", "));
}

} // namespace atrium
