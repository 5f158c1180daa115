// Cut, padded, flipped and foreign files.

#include "tests/scene/bake_refusal.hpp"
#include "tests/scene/bake_rig.hpp"

#include <gtest/gtest.h>

#include <set>

namespace atrium {
namespace {

using namespace bake_rig;

class bake_damage : public testing::Test {
protected:
    bake_damage() : path_(folder_ / "damaged.atrium")
    {
        write_bake(path_, rich_bake());
        whole_ = read_bytes(path_);
    }
    std::string opening(const Bytes& file)
    {
        write_bytes(path_, file);
        return refusal([&] { const BakeFile bake(path_); });
    }
    std::string verifying(const Bytes& file)
    {
        write_bytes(path_, file);
        return refusal([&] { (void)verify_bake(path_); });
    }
    void expect_opens(const Bytes& file)
    {
        write_bytes(path_, file);
        EXPECT_NO_THROW({ const BakeFile bake(path_); });
    }

    TempFolder folder_;
    std::filesystem::path path_;
    Bytes whole_;
};

Bytes flipped(Bytes file, std::size_t at, unsigned mask)
{
    file[at] ^= static_cast<std::byte>(mask);
    return file;
}

TEST_F(bake_damage, a_cut_anywhere_is_refused_and_named)
{
    std::set<std::size_t> cuts{0, 1, 7, 8, 9, 39, 40, 41, 199, 200, 201, whole_.size() - 1};
    for (const bake::SectionEntry& e : table(whole_)) {
        for (const std::uint64_t at : {e.offset, e.offset + e.size}) cuts.insert({at - 1, at, at + 1});
    }
    for (std::size_t at = 0; at < whole_.size(); at += 97) cuts.insert(at);
    for (const std::size_t at : cuts) {
        if (at >= whole_.size()) continue;
        SCOPED_TRACE(at);
        const std::string text = opening(Bytes(whole_.begin(), whole_.begin() + static_cast<std::ptrdiff_t>(at)));
        EXPECT_TRUE(at < 8 || has(text, "cut short")) << text;
        if (at < table_end) {
            EXPECT_TRUE(has(text, at < table_offset ? "header" : "table")) << text;
        }
        for (std::uint32_t s = 0; s < bake::section_count; ++s) {
            const bake::SectionEntry e = table(whole_)[s];
            if (at < e.offset || at >= e.offset + e.size) continue;
            EXPECT_TRUE(has(text, std::string("section ") + bake::section_names[s])) << text;
        }
    }
}

TEST_F(bake_damage, bytes_after_the_last_section_are_refused)
{
    Bytes longer = whole_;
    longer.push_back(std::byte{0});
    EXPECT_TRUE(has(opening(longer), "1 bytes follow the last section"));
    longer.resize(whole_.size() + 4096);
    EXPECT_TRUE(has(opening(longer), "4096 bytes follow the last section"));

    put(longer, offsetof(bake::Header, file_size), std::uint64_t{longer.size()}); // and the header agrees
    rehash(longer);
    EXPECT_TRUE(has(opening(longer), "table"));
}

TEST_F(bake_damage, a_flip_of_any_bit_of_header_or_table_is_refused)
{
    for (std::size_t at = 0; at < table_end; ++at) {
        for (unsigned bit = 0; bit < 8; ++bit) {
            SCOPED_TRACE(at);
            const std::string text = opening(flipped(whole_, at, 1u << bit));
            EXPECT_TRUE(has(text, "header") || has(text, "table")) << text;
        }
    }
}

TEST_F(bake_damage, a_flip_in_the_archive_is_refused_by_opening)
{
    const bake::SectionEntry archive = table(whole_)[bake::archive];
    for (std::size_t i = 0; i < archive.size; ++i) {
        SCOPED_TRACE(i);
        const std::string text = opening(flipped(whole_, archive.offset + i, 1u << i % 8));
        EXPECT_TRUE(has(text, "section archive")) << text;
    }
}

TEST_F(bake_damage, a_flip_anywhere_is_refused_by_verify)
{
    std::set<std::size_t> places;
    for (std::size_t at = 0; at < whole_.size(); at += 61) places.insert(at);
    for (const bake::SectionEntry& e : table(whole_)) { // both ends of each section and of the padding between
        for (const std::uint64_t at : {e.offset, e.offset + e.size}) places.insert({at - 1, at});
    }
    for (const std::size_t at : places) {
        if (at >= whole_.size()) continue;
        SCOPED_TRACE(at);
        const std::string text = verifying(flipped(whole_, at, 1u << at % 8));
        std::string part = at < table_end ? "" : "padding";
        for (std::uint32_t s = 0; s < bake::section_count; ++s) {
            const bake::SectionEntry e = table(whole_)[s];
            if (at >= e.offset && at < e.offset + e.size) part = std::string("section ") + bake::section_names[s];
        }
        EXPECT_TRUE(has(text, part)) << text;
    }
}

TEST_F(bake_damage, opening_looks_at_bulk_sections_by_size_only)
{
    for (const bake::Section s : {bake::vertices, bake::indices, bake::texels}) {
        expect_opens(flipped(whole_, table(whole_)[s].offset, 1));
    }
}

TEST_F(bake_damage, verify_finds_bad_indices_and_vertices_behind_right_hashes)
{
    const Mesh mesh = rich_bake().scene.meshes[0];
    const std::size_t index = table(whole_)[bake::indices].offset + 4 * (mesh.first_index + 5);
    for (const std::uint32_t bad : {mesh.first_vertex - 1, mesh.first_vertex + mesh.vertex_count, 0xffffffffu}) {
        Bytes file = whole_;
        put(file, index, bad);
        rehash(file);
        expect_opens(file);
        const std::string text = verifying(file);
        EXPECT_TRUE(has(text, "section indices") && has(text, "vertex " + std::to_string(bad))) << text;
    }
    for (const std::size_t field : {0u, 4u, 8u, 20u, 24u}) {
        for (const float bad : {std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN()}) {
            Bytes file = whole_;
            put(file, table(whole_)[bake::vertices].offset + 28 * 17 + field, bad);
            rehash(file);
            const std::string text = verifying(file);
            EXPECT_TRUE(has(text, "section vertices") && has(text, "vertex 17")) << text;
        }
    }
    Bytes file = whole_; // finite numbers whose sum is not
    put(file, table(whole_)[bake::vertices].offset, vec3(3e38f));
    rehash(file);
    write_bytes(path_, file);
    EXPECT_NO_THROW((void)verify_bake(path_));
}

TEST_F(bake_damage, other_versions_are_refused_by_number)
{
    for (const bool right_hash : {false, true}) {
        Bytes file = whole_;
        put(file, offsetof(bake::Header, version), 7u);
        if (right_hash) rehash(file);
        const std::string text = opening(file);
        EXPECT_TRUE(has(text, "version is 7") && has(text, "version 1")) << text;
        EXPECT_TRUE(has(text, "assetconv bake")) << text;
    }
}

TEST_F(bake_damage, another_endianness_and_word_size_are_named)
{
    Bytes file = whole_;
    put(file, offsetof(bake::Header, endian), 0x04030201u);
    put(file, offsetof(bake::Header, version), 0x01000000u); // as a big-endian machine would have written it
    EXPECT_TRUE(has(opening(file), "big-endian"));
    file = whole_;
    put(file, offsetof(bake::Header, endian), 0x04030201u);
    rehash(file);
    EXPECT_TRUE(has(opening(file), "big-endian"));
    file = whole_;
    put(file, offsetof(bake::Header, word_size), 4u);
    rehash(file);
    EXPECT_TRUE(has(opening(file), "word size is 4 bytes"));
}

TEST_F(bake_damage, other_files_are_told_apart)
{
    const std::string obj = "# an OBJ\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    const auto bytes = std::as_bytes(std::span(obj));
    EXPECT_TRUE(has(opening(Bytes(bytes.begin(), bytes.end())), "not an Atrium bake"));
    const std::string missing = refusal([&] { const BakeFile bake(folder_ / "missing.atrium"); });
    EXPECT_TRUE(has(missing, "missing.atrium")) << missing;
}

TEST_F(bake_damage, a_table_with_a_right_hash_must_still_hold_together)
{
    const auto refuses = [&](auto&& change) {
        Bytes file = whole_;
        bake::Table entries = table(file);
        change(entries);
        put(file, table_offset, entries);
        rehash(file);
        const std::string text = opening(file);
        EXPECT_TRUE(has(text, "table")) << text;
    };
    const std::uint64_t huge = ~std::uint64_t{0};
    for (std::size_t s = 0; s < bake::section_count; ++s) {
        SCOPED_TRACE(bake::section_names[s]);
        refuses([&](bake::Table& t) { t[s].name[15] = 'x'; });
        refuses([&](bake::Table& t) { t[s].offset += bake::section_alignment; });
        refuses([&](bake::Table& t) { t[s].offset -= bake::section_alignment; });
        refuses([&](bake::Table& t) { t[s].offset += 8; });
        refuses([&](bake::Table& t) { t[s].offset = huge; });
        refuses([&](bake::Table& t) { t[s].offset = huge - bake::section_alignment + 1; });
        refuses([&](bake::Table& t) { t[s].size = huge; });
        refuses([&](bake::Table& t) { t[s].size = huge - t[s].offset + 1; });
        refuses([&](bake::Table& t) { t[s].size += bake::section_alignment; });
        refuses([&](bake::Table& t) { t[s].size = 0; });
    }
    refuses([&](bake::Table& t) { std::swap(t[1], t[2]); });
    refuses([&](bake::Table& t) { t[3].size -= 1; });
}

} // namespace
} // namespace atrium
