#pragma once
// Layout of a .atrium file: header, table of sections, sections. See docs/bake-format.md.
// Little-endian; offsets from the start of the file; padding is zero; nothing follows the last section.

#include <array>
#include <cstddef>
#include <cstdint>

namespace atrium::bake {

inline constexpr std::array<char, 8> magic{'A', 'T', 'R', 'I', 'U', 'M', '\r', '\n'};
inline constexpr std::uint32_t format_version = 1;
inline constexpr std::uint32_t endian_mark = 0x01020304u;
inline constexpr std::uint32_t swapped_endian_mark = 0x04030201u; ///< what the other byte order leaves
inline constexpr std::uint32_t word_size = sizeof(std::size_t);
/// Every section begins at the first multiple of this after what stands before it, so that the mapping of bulk sections
/// can be imported as device memory.
inline constexpr std::uint64_t section_alignment = 4096;
[[nodiscard]] constexpr std::uint64_t align_section(std::uint64_t offset)
{
    return (offset + section_alignment - 1) / section_alignment * section_alignment;
}

enum Section : std::uint32_t { archive, vertices, indices, texels, section_count };
inline constexpr std::array<const char*, section_count> section_names{"archive", "vertices", "indices", "texels"};

struct Header {
    std::array<char, 8> magic;
    std::uint32_t version;
    std::uint32_t endian;
    std::uint32_t word_size;
    std::uint32_t sections;
    std::uint64_t file_size;
    std::uint64_t hash; ///< XXH3-64 of header (this field zero) and table
};
static_assert(sizeof(Header) == 40);

struct SectionEntry {
    std::array<char, 16> name; ///< zero-padded
    std::uint64_t offset;
    std::uint64_t size;
    std::uint64_t hash; ///< XXH3-64 of the section's bytes
};
static_assert(sizeof(SectionEntry) == 40);
using Table = std::array<SectionEntry, section_count>;

// The most that a bake may hold. Cluster and index counts bound the renderer's draw records; the others are chosen so
// that tables of short names, which are larger in memory than in the file, outgrow the archive by less than 64 MiB.
inline constexpr std::uint64_t max_materials = 1u << 16;
inline constexpr std::uint64_t max_textures = 1u << 16;
inline constexpr std::uint64_t max_meshes = 1u << 20;
inline constexpr std::uint64_t max_clusters = 1u << 24;
inline constexpr std::uint64_t max_warnings = 1u << 12;
inline constexpr std::uint64_t max_vertices = 1u << 31;
inline constexpr std::uint64_t max_indices = 0xffffffffu; ///< ranges of indices are 32 bit
inline constexpr std::uint64_t max_text = 0xffff;         ///< bytes of a name
inline constexpr std::uint32_t max_texture_size = 16384;  ///< texels along one axis

} // namespace atrium::bake
