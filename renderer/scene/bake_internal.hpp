#pragma once
// What the sources of the bake share among themselves. Nobody else includes this.

#include "renderer/scene/bake_format.hpp"
#include "renderer/scene/scene.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace atrium::bake {

/// Throws Error(input): damage in `part` ("header", "section archive", …) of `where`, the file or one element in it.
[[noreturn]] void refuse(const std::string& where, std::string_view part, const std::string& why);

/// Header and table of a mapped file, checked in full but for the sections' own hashes.
[[nodiscard]] Table read_table(std::span<const std::byte> file, const std::string& name);

/// XXH3-64 of the header with its hash field zero, then the table.
[[nodiscard]] std::uint64_t hash_header(Header header, const Table& table);

/// The scene as a Boost.Serialization archive, and back. Decoding trusts nothing: it throws Error(input) for `name`
/// rather than take memory that the archive's size does not warrant. The scene's ranges are not checked yet.
[[nodiscard]] std::string encode_archive(const Scene& scene);
[[nodiscard]] Scene decode_archive(std::span<const std::byte> archive, const std::string& name);

} // namespace atrium::bake
