#pragma once
// "Did you mean": the valid name that was probably meant by what was typed.

#include <span>
#include <string>
#include <string_view>

namespace atrium {

/// The candidate with the smallest edit distance (insert, delete, replace, swap of neighbours) among those that a
/// typing mistake explains: at most a third of the letters differ (one letter in a short name), or `typed` is the
/// beginning or the part after the last dot of the candidate, or the candidate is the beginning of `typed`. A group
/// that both share
/// ("ao." in ao.radius) does not count as letters. The first of equals; empty when there is no such candidate.
[[nodiscard]] std::string nearest_name(std::string_view typed, std::span<const std::string> candidates);

/// `did you mean "NAME"?`, options without quotes; `otherwise` when no candidate is near.
[[nodiscard]] std::string did_you_mean(std::string_view typed, std::span<const std::string> candidates,
                                       std::string_view otherwise = "");

/// The same; where no candidate is near, all of them when they are few ("choose one of a, b, c"), else empty.
[[nodiscard]] std::string suggest_name(std::string_view typed, std::span<const std::string> candidates);

} // namespace atrium
