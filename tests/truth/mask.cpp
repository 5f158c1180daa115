#include "tests/truth/mask.hpp"

#include <algorithm>

namespace atrium::truth {

double Mask::share() const
{
    if (values.empty()) return 0;
    return static_cast<double>(std::count(values.begin(), values.end(), std::uint8_t{1})) /
           static_cast<double>(values.size());
}

Mask both(const Mask& a, const Mask& b)
{
    Mask out = a;
    for (std::size_t i = 0; i < out.values.size(); ++i) out.values[i] &= b.values[i];
    return out;
}

Mask without(const Mask& a, const Mask& b)
{
    return both(a, inverse(b));
}

Mask inverse(const Mask& a)
{
    Mask out = a;
    for (std::uint8_t& v : out.values) v ^= 1;
    return out;
}

Mask grown(const Mask& a)
{
    Mask out(a.width, a.height);
    for (int y = 0; y < a.height; ++y) {
        for (int x = 0; x < a.width; ++x) {
            bool any = false;
            for (int v = std::max(0, y - 1); v <= std::min(a.height - 1, y + 1); ++v) {
                for (int u = std::max(0, x - 1); u <= std::min(a.width - 1, x + 1); ++u) any = any || a.at(u, v);
            }
            out.set(x, y, any);
        }
    }
    return out;
}

} // namespace atrium::truth
