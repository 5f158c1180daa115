#pragma once
// Golden pictures: largest channel difference and share of pixels beyond a limit.

#include "renderer/core/image.hpp"

#include <filesystem>
#include <string>

namespace atrium::truth {

struct GoldenResult {
    bool passed = false;
    int largest_difference = 0; ///< of any channel, 0..255
    double failing_share = 0;   ///< of pixels with a channel that differs by more than the limit
    double rmse = 0;            ///< over all channels, 0..255
    std::string text;           ///< figures, and where the pictures of a failure are
};

/// Passes when at most `max_share` (0..1) of the pixels differ by more than `max_channel_difference` in some channel.
/// Pictures of other sizes and a missing golden fail. A failure writes actual, expected and difference (its factor is
/// said in the text) into failure_folder(). With ATRIUM_UPDATE_GOLDENS=1 in the environment the golden is written anew
/// instead, and passes.
[[nodiscard]] GoldenResult compare_golden(const Image8& actual, const std::filesystem::path& golden,
                                          int max_channel_difference, double max_share);

} // namespace atrium::truth
