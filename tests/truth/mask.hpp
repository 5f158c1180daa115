#pragma once
// Which pixels of a picture a comparison looks at.

#include <cstddef>
#include <cstdint>
#include <vector>

namespace atrium::truth {

/// width x height, 1 where the pixel counts. Row 0 is the top.
struct Mask {
    int width = 0, height = 0;
    std::vector<std::uint8_t> values;

    Mask() = default;
    Mask(int w, int h, bool fill = false)
        : width(w), height(h), values(static_cast<std::size_t>(w) * static_cast<std::size_t>(h), fill ? 1 : 0)
    {}
    [[nodiscard]] std::size_t index(int x, int y) const
    {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    }
    [[nodiscard]] bool at(int x, int y) const { return values[index(x, y)] != 0; }
    void set(int x, int y, bool on) { values[index(x, y)] = on ? 1 : 0; }
    /// Share of the pixels that are set, 0..1.
    [[nodiscard]] double share() const;
};

/// The three take masks of one size.
[[nodiscard]] Mask both(const Mask& a, const Mask& b);
[[nodiscard]] Mask without(const Mask& a, const Mask& b); ///< a and not b
[[nodiscard]] Mask inverse(const Mask& a);
/// Set where any of the 3x3 pixels around is.
[[nodiscard]] Mask grown(const Mask& a);

} // namespace atrium::truth
