#include "assetconv/srgb.hpp"

#include <algorithm>

namespace atrium {
namespace {

/// starts[i]: the code of i / buckets; edges[c]: the linear value from which code c is the nearest.
struct EncodeTable {
    static constexpr int buckets = 4096;
    std::array<std::uint8_t, buckets + 1> starts{};
    std::array<float, 257> edges{};

    EncodeTable()
    {
        for (int c = 1; c < 256; ++c)
            edges[static_cast<std::size_t>(c)] = srgb_decode((static_cast<float>(c) - 0.5f) / 255.0f);
        edges[0] = -1;
        edges[256] = 2;
        std::uint8_t code = 0;
        for (int i = 0; i <= buckets; ++i) {
            while (static_cast<float>(i) / buckets >= edges[code + 1u]) ++code;
            starts[static_cast<std::size_t>(i)] = code;
        }
    }
};

} // namespace

const std::array<float, 256>& srgb_decode_table()
{
    static const std::array<float, 256> table = [] {
        std::array<float, 256> t{};
        for (std::size_t i = 0; i < t.size(); ++i) t[i] = srgb_decode(static_cast<float>(i) / 255.0f);
        return t;
    }();
    return table;
}

std::uint8_t srgb_encode8(float linear)
{
    static const EncodeTable table;
    const float x = linear > 0 ? std::min(linear, 1.0f) : 0.0f;
    std::uint8_t code = table.starts[static_cast<std::size_t>(x * EncodeTable::buckets)];
    while (x >= table.edges[code + 1u]) ++code;
    return code;
}

} // namespace atrium
