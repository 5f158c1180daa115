#pragma once
// Repeatable random numbers: integer hashes only, so that every machine and thread count gives the same court.

#include "renderer/core/math.hpp"

#include <cstdint>
#include <string_view>

namespace atrium::courtyard {

/// A well-mixed hash of two words (the finaliser of MurmurHash3 over a sum with odd multipliers).
[[nodiscard]] constexpr std::uint32_t mix(std::uint32_t a, std::uint32_t b = 0)
{
    std::uint32_t h = a * 0x9E3779B1u + b * 0x85EBCA77u + 0x165667B1u;
    h = (h ^ (h >> 16)) * 0x85EBCA6Bu;
    h = (h ^ (h >> 13)) * 0xC2B2AE35u;
    return h ^ (h >> 16);
}

/// To [0, 1).
[[nodiscard]] constexpr float unit(std::uint32_t h)
{
    return static_cast<float>(h >> 8) * (1.0f / 16777216.0f);
}

/// A stream of numbers named by seed and purpose: adding a number to one stream leaves the others as they were.
class Random {
public:
    Random(std::uint32_t seed, std::string_view purpose, std::uint32_t index = 0) : state_(mix(seed, index + 1))
    {
        for (const char c : purpose) {
            state_ = mix(state_, static_cast<unsigned char>(c));
        }
    }
    std::uint32_t bits() { return mix(state_, ++count_); }
    float unit() { return courtyard::unit(bits()); }
    float between(float low, float high) { return low + (high - low) * unit(); }
    float around(float middle, float spread) { return between(middle - spread, middle + spread); }
    int below(int count) { return static_cast<int>(unit() * static_cast<float>(count)); }
    bool chance(float p) { return unit() < p; }

private:
    std::uint32_t state_, count_ = 0;
};

} // namespace atrium::courtyard
