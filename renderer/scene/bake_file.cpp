// Opening and writing .atrium files: header, table and the order of the checks.

#include "renderer/scene/bake_file.hpp"

#include "renderer/core/atomic_file.hpp"
#include "renderer/core/error.hpp"
#include "renderer/core/hash.hpp"
#include "renderer/scene/bake_internal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstring>

namespace atrium {
namespace bake {
namespace {

constexpr std::uint64_t table_end = sizeof(Header) + sizeof(Table);
constexpr const char* bake_again = "bake the scene again with `assetconv bake`";
static_assert(std::endian::native == std::endian::little, "the format is little-endian");

std::array<char, 16> padded_name(std::size_t section)
{
    std::array<char, 16> name{};
    std::string_view(section_names[section]).copy(name.data(), name.size());
    return name;
}

/// A bake that is whole, but not for this program.
[[noreturn]] void refuse_foreign(const std::string& name, const std::string& what, const std::string& why)
{
    throw Error(ExitCode::input, "cannot read the bake: " + what, name + ", header", why, bake_again);
}

/// All that can be said before the hash is known to be right: is it a bake, and one for this program?
void check_header(const Header& header, const std::string& name)
{
    if (header.endian == swapped_endian_mark) {
        refuse_foreign(name, "its endianness is not this machine's",
                       "the header says that it was baked on a big-endian machine");
    }
    if (header.endian != endian_mark) {
        refuse(name, "header", fmt::format("the endianness mark is {:08x}, not {:08x}", header.endian, endian_mark));
    }
    if (header.version != format_version) {
        refuse_foreign(name, fmt::format("its format version is {}", header.version),
                       fmt::format("this program reads format version {}", format_version));
    }
    if (header.word_size != word_size) {
        refuse_foreign(name, fmt::format("its word size is {} bytes", header.word_size),
                       fmt::format("this program's word size is {} bytes", word_size));
    }
    if (header.sections != section_count) {
        refuse(name, "header", fmt::format("it names {} sections, not {}", header.sections, +section_count));
    }
}

/// The name of the part that the byte at `offset` belongs to.
std::string part_at(const Table& table, std::uint64_t offset)
{
    for (std::size_t i = 0; i < section_count; ++i) {
        if (offset < table[i].offset) return std::string("padding before section ") + section_names[i];
        if (offset < table[i].offset + table[i].size) return std::string("section ") + section_names[i];
    }
    return "end";
}

/// Every section where the sizes before it put it, the last one ending with the file.
void check_table(const Table& table, std::uint64_t file_size, const std::string& name)
{
    std::uint64_t end = table_end;
    for (std::size_t i = 0; i < section_count; ++i) {
        const SectionEntry& entry = table[i];
        if (entry.name != padded_name(i)) {
            refuse(name, "table", fmt::format("entry {} is not named \"{}\"", i, section_names[i]));
        }
        if (entry.offset != align_section(end)) {
            refuse(
                name, "table",
                fmt::format("section {} begins at {}, not at {}", section_names[i], entry.offset, align_section(end)));
        }
        if (entry.offset > file_size || entry.size > file_size - entry.offset) {
            refuse(name, "table",
                   fmt::format("section {} ({} bytes at {}) reaches beyond the file's {} bytes", section_names[i],
                               entry.size, entry.offset, file_size));
        }
        end = entry.offset + entry.size;
    }
    if (end != file_size) {
        refuse(name, "table", fmt::format("the last section ends at {}, the file at {}", end, file_size));
    }
}

} // namespace

void refuse(const std::string& where, std::string_view part, const std::string& why)
{
    throw Error(ExitCode::input, fmt::format("the bake is damaged in its {}", part), where, why, bake_again);
}

std::uint64_t hash_header(Header header, const Table& table)
{
    header.hash = 0;
    std::array<std::byte, table_end> bytes;
    std::memcpy(bytes.data(), &header, sizeof(header));
    std::memcpy(bytes.data() + sizeof(header), table.data(), sizeof(table));
    return hash64(bytes);
}

Table read_table(std::span<const std::byte> file, const std::string& name)
{
    if (file.size() < magic.size() || std::memcmp(file.data(), magic.data(), magic.size()) != 0) {
        throw Error(ExitCode::input, "not an Atrium bake", name,
                    file.empty() ? "the file is empty: there is no header"
                                 : "its header does not begin as a bake's does",
                    "give an .atrium file; `assetconv bake` makes one from an .obj");
    }
    Header header;
    Table table;
    if (file.size() < sizeof(header)) refuse(name, "header", fmt::format("the file is cut short at {}", file.size()));
    std::memcpy(&header, file.data(), sizeof(header));
    check_header(header, name);
    if (file.size() < table_end) refuse(name, "table", fmt::format("the file is cut short at {}", file.size()));
    std::memcpy(table.data(), file.data() + sizeof(header), sizeof(table));

    if (header.hash != hash_header(header, table)) refuse(name, "header or table", "the hash over both does not match");
    check_table(table, header.file_size, name);
    if (file.size() < header.file_size) {
        refuse(name, part_at(table, file.size()),
               fmt::format("the file is cut short at {} of {} bytes", file.size(), header.file_size));
    }
    if (file.size() > header.file_size) {
        refuse(name, "end", fmt::format("{} bytes follow the last section", file.size() - header.file_size));
    }
    return table;
}

} // namespace bake

BakeFile::BakeFile(const std::filesystem::path& file) : path_(file), file_(file)
{
    const std::string name = file.string();
    table_ = bake::read_table(bytes(), name);
    const std::span<const std::byte> archive = section(bake::archive);
    if (hash64(archive) != table_[bake::archive].hash) bake::refuse(name, "section archive", "its hash does not match");
    scene_ = bake::decode_archive(archive, name);
    check_scene(scene_, vertices().size(), indices().size(), texels().size(), name);
}

std::span<const std::byte> BakeFile::section(bake::Section s) const
{
    return bytes().subspan(static_cast<std::size_t>(table_[s].offset), static_cast<std::size_t>(table_[s].size));
}

void write_bake(const std::filesystem::path& file, const BakeData& data)
{
    const auto vertices = std::as_bytes(std::span(data.vertices));
    const auto indices = std::as_bytes(std::span(data.indices));
    const std::span<const std::byte> texels = data.texels;
    check_scene(data.scene, vertices.size(), indices.size(), texels.size(), file.string());
    const std::string archive = bake::encode_archive(data.scene);
    const std::array<std::span<const std::byte>, bake::section_count> sections{std::as_bytes(std::span(archive)),
                                                                               vertices, indices, texels};

    bake::Header header{
        bake::magic, bake::format_version, bake::endian_mark, bake::word_size, bake::section_count, 0, 0};
    bake::Table table{};
    std::uint64_t end = bake::table_end;
    for (std::size_t i = 0; i < bake::section_count; ++i) {
        const std::uint64_t offset = bake::align_section(end);
        table[i] = {bake::padded_name(i), offset, sections[i].size(), hash64(sections[i])};
        end = offset + sections[i].size();
    }
    header.file_size = end;
    header.hash = bake::hash_header(header, table);

    AtomicFile out(file);
    out.write(std::as_bytes(std::span(&header, 1)));
    out.write(std::as_bytes(std::span(table)));
    constexpr std::array<std::byte, bake::section_alignment> zeros{};
    std::uint64_t at = bake::table_end;
    for (std::size_t i = 0; i < bake::section_count; ++i) {
        out.write(std::span(zeros).first(static_cast<std::size_t>(table[i].offset - at)));
        out.write(sections[i]);
        at = table[i].offset + table[i].size;
    }
    out.commit();
}

} // namespace atrium
