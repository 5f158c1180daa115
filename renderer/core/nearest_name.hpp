#pragma once
// "Did you mean": the valid name that a mistyped one was probably meant to be.

#include <span>
#include <string>
#include <string_view>

namespace atrium {

/// The candidate with the smallest edit distance (insert, delete, replace, swap of neighbours) that may be a typing
/// mistake: at most a third of the letters differ (one letter in a short name), or `typed` is the beginning or the part
/// after the last dot of the candidate, or the candidate is the beginning of `typed`. A group that both share ("ao." in
/// ao.radius) is ignored. With equal distances the first one; empty if there is no such candidate.
[[nodiscard]] std::string nearest_name(std::string_view typed, std::span<const std::string> candidates);

/// `did you mean "NAME"?` (options without quotes), or `otherwise` if no candidate is near.
[[nodiscard]] std::string did_you_mean(std::string_view typed, std::span<const std::string> candidates,
                                       std::string_view otherwise = "");

/// The same; if no candidate is near, a list of all if they are few ("choose one of a, b, c"), otherwise empty.
[[nodiscard]] std::string suggest_name(std::string_view typed, std::span<const std::string> candidates);

} // namespace atrium
