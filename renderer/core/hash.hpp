#pragma once
// XXH3-64 over bytes: section hashes of a bake, keys of caches.

#include <cstddef>
#include <cstdint>
#include <span>

namespace atrium {

[[nodiscard]] std::uint64_t hash64(std::span<const std::byte> bytes, std::uint64_t seed = 0);

} // namespace atrium
