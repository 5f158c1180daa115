// Archives that lie, with right hashes. ATRIUM_FUZZ_SECONDS=60 makes the random part run that long.

#include "tests/scene/bake_memory.hpp"
#include "tests/scene/bake_refusal.hpp"
#include "tests/scene/bake_rig.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <random>

namespace atrium {
namespace {

using namespace bake_rig;

Bytes baked(const TempFolder& folder, const BakeData& data)
{
    write_bake(folder / "whole.atrium", data);
    return read_bytes(folder / "whole.atrium");
}

/// The one byte of the archive that `change` changes.
std::size_t byte_of(const TempFolder& folder, const std::function<void(Scene&)>& change)
{
    BakeData data = rich_bake();
    const Bytes before = section(baked(folder, data), bake::archive);
    change(data.scene);
    const Bytes after = section(baked(folder, data), bake::archive);
    EXPECT_EQ(before.size(), after.size());
    const auto [a, b] = std::mismatch(before.begin(), before.end(), after.begin());
    EXPECT_TRUE(a != before.end() && std::equal(a + 1, before.end(), b + 1)) << "one byte was to differ";
    return static_cast<std::size_t>(a - before.begin());
}

std::string opening(const TempFolder& folder, const Bytes& file)
{
    write_bytes(folder / "hostile.atrium", file);
    return refusal([&] { const BakeFile bake(folder / "hostile.atrium"); });
}

TEST(bake_hostile, bools_and_enums_are_checked_before_they_are_bools_and_enums)
{
    const TempFolder folder;
    const Bytes whole = baked(folder, rich_bake());
    const std::pair<std::function<void(Scene&)>, int> fields[] = {
        {[](Scene& s) { s.materials[1].cls = MaterialClass::cloth; }, 4},
        {[](Scene& s) { s.materials[1].two_sided ^= true; }, 2},
        {[](Scene& s) { s.textures[1].clamp ^= true; }, 2},
        {[](Scene& s) { s.meshes[1].two_sided ^= true; }, 2},
    };
    for (const auto& [change, first_bad] : fields) {
        const std::size_t at = byte_of(folder, change);
        for (const int bad : {first_bad, 128, 255}) {
            Bytes archive = section(whole, bake::archive);
            archive[at] = static_cast<std::byte>(bad);
            const std::string text = opening(folder, with_section(whole, bake::archive, archive));
            EXPECT_TRUE(has(text, "section archive") && has(text, std::to_string(bad) + " is not a")) << text;
        }
    }
}

TEST(bake_hostile, bytes_after_the_scene_are_refused)
{
    const TempFolder folder;
    const Bytes whole = baked(folder, rich_bake());
    Bytes archive = section(whole, bake::archive);
    archive.push_back(std::byte{0});
    EXPECT_TRUE(has(opening(folder, with_section(whole, bake::archive, archive)), "1 bytes follow the scene"));
}

TEST(bake_hostile, counts_above_the_limits_are_refused_before_anything_is_read)
{
    // The warnings come last: two of them behind their count.
    const TempFolder folder;
    const BakeData data = rich_bake();
    const Bytes whole = baked(folder, data);
    Bytes archive = section(whole, bake::archive);
    std::size_t count_at = archive.size() - 8;
    for (const BakeWarning& w : data.scene.warnings) count_at -= 24 + w.kind.size() + w.first.size();
    ASSERT_EQ(get<std::uint64_t>(archive, count_at), 2u);
    archive.resize(archive.size() + 24 * 4095); // empty ones
    put(archive, count_at, std::uint64_t{4097});
    const std::string text = opening(folder, with_section(whole, bake::archive, archive));
    EXPECT_TRUE(has(text, "a count of 4097, at most 4096 are allowed")) << text;
}

TEST(bake_hostile, a_cut_archive_is_refused_at_every_byte)
{
    const TempFolder folder;
    const Bytes whole = baked(folder, rich_bake());
    Bytes archive = section(whole, bake::archive);
    while (!archive.empty()) {
        archive.pop_back();
        const std::string text = opening(folder, with_section(whole, bake::archive, archive));
        ASSERT_TRUE(has(text, "section archive")) << archive.size() << " " << text;
    }
}

/// What a bake that opens must keep to, whatever it holds: said again here, apart from check_scene.
void expect_drawable(const BakeFile& bake)
{
    const Scene& s = bake.scene();
    ASSERT_EQ(bake.vertices().size(), s.vertex_count * 28);
    ASSERT_EQ(bake.indices().size(), s.index_count * 4);
    std::uint64_t drawn = 0;
    for (const Mesh& m : s.meshes) {
        ASSERT_LT(m.material, s.materials.size());
        ASSERT_LE(std::uint64_t{m.first_index} + m.index_count, s.index_count);
        ASSERT_LE(std::uint64_t{m.first_vertex} + m.vertex_count, s.vertex_count);
        ASSERT_LE(std::uint64_t{m.first_cluster} + m.cluster_count, s.clusters.size());
        for (std::uint32_t c = m.first_cluster; c < m.first_cluster + m.cluster_count; ++c) {
            const Cluster& cluster = s.clusters[c];
            ASSERT_GE(cluster.first_index, m.first_index);
            ASSERT_LE(std::uint64_t{cluster.first_index} + cluster.index_count,
                      std::uint64_t{m.first_index} + m.index_count);
            drawn += cluster.index_count;
        }
    }
    ASSERT_EQ(drawn, s.index_count);
    std::uint64_t texels = 0;
    for (const Texture& t : s.textures) {
        ASSERT_TRUE(t.width > 0 && t.height > 0 && t.width <= 16384 && t.height <= 16384);
        ASSERT_EQ(t.offset % 16, 0u);
        ASSERT_LE(t.size, bake.texels().size());
        ASSERT_LE(t.offset, bake.texels().size() - t.size);
        std::uint64_t bytes = 0;
        for (std::uint32_t i = 0; i < t.mips; ++i) {
            bytes += mip_bytes(t.format, std::max(1u, t.width >> i), std::max(1u, t.height >> i));
        }
        ASSERT_LE(bytes, t.size);
        texels += t.size;
    }
    ASSERT_LE(texels, bake.texels().size());
    for (const Material& m : s.materials) {
        ASSERT_LT(static_cast<int>(m.cls), material_class_count);
        for (const int t : {m.base_color_texture, m.normal_texture, m.surface_texture, m.emission_texture}) {
            ASSERT_TRUE(t >= -1 && t < static_cast<int>(s.textures.size()));
        }
    }
}

class Mutator {
public:
    explicit Mutator(std::uint64_t seed) : random_(seed) {}

    /// Tampers with an archive in one to four ways.
    void archive(Bytes& bytes)
    {
        for (std::size_t n = 1 + below(4); n > 0 && bytes.size() > 8; --n) one(bytes);
    }
    std::size_t below(std::size_t n) { return static_cast<std::size_t>(random_() % n); }

private:
    void one(Bytes& bytes)
    {
        const std::size_t at = below(bytes.size() - 8);
        switch (below(8)) {
        case 0:
            bytes[at] ^= static_cast<std::byte>(1u << below(8));
            break;
        case 1:
            bytes[at] = static_cast<std::byte>(below(256));
            break;
        case 2:
            put(bytes, at, huge());
            break;
        case 3:
            put(bytes, at, static_cast<std::uint64_t>(below(bytes.size())));
            break;
        case 4:
            put(bytes, at, static_cast<std::uint32_t>(huge()));
            break;
        case 5:
            put(bytes, at, static_cast<std::uint32_t>(below(1000)));
            break;
        case 6: // a piece goes, or comes twice
            if (below(2) == 0)
                bytes.erase(place(bytes, at), place(bytes, at + 1 + below(8)));
            else
                bytes.insert(place(bytes, at), 1 + below(8), std::byte{0});
            break;
        default: // swap neighbours
            std::swap_ranges(place(bytes, at), place(bytes, at + 4), place(bytes, at + 4));
        }
    }
    static Bytes::iterator place(Bytes& bytes, std::size_t at)
    {
        return bytes.begin() + static_cast<std::ptrdiff_t>(at);
    }
    std::uint64_t huge()
    {
        const std::uint64_t values[] = {~std::uint64_t{0},
                                        std::uint64_t{1} << 63,
                                        std::uint64_t{1} << 40,
                                        std::uint64_t{0x7fffffff},
                                        0x80000000u,
                                        0xffffffffu,
                                        1u << 24,
                                        1u << 20,
                                        1u << 16};
        return values[below(std::size(values))] - below(2);
    }

    std::mt19937_64 random_;
};

/// Opens whatever it is. Memory stays within four times the file and a little for Boost and the messages.
/// @return whether it opened
bool open_hostile(const std::filesystem::path& path, const Bytes& file)
{
    write_bytes(path, file);
    bool opened = false;
    const std::size_t memory = peak_memory_of([&] {
        try {
            const BakeFile bake(path);
            opened = true;
            expect_drawable(bake);
        } catch (const Error& e) {
            EXPECT_EQ(e.code(), ExitCode::input) << e.text();
        }
    });
    EXPECT_LE(memory, 4 * file.size() + 65536);
    if (!opened) return false;
    try {
        (void)verify_bake(path);
    } catch (const Error& e) {
        EXPECT_EQ(e.code(), ExitCode::input) << e.text();
    }
    return true;
}

TEST(bake_hostile, every_number_of_the_archive_overwritten)
{
    const TempFolder folder;
    const Bytes whole = baked(folder, tiny_bake());
    const Bytes archive = section(whole, bake::archive);
    for (std::size_t at = 0; at + 8 <= archive.size(); ++at) {
        for (const std::uint64_t value : {~std::uint64_t{0}, std::uint64_t{1} << 62, std::uint64_t{1} << 20,
                                          std::uint64_t{0x10000}, std::uint64_t{archive.size()}, std::uint64_t{0}}) {
            SCOPED_TRACE(at);
            Bytes hostile = archive;
            put(hostile, at, value);
            open_hostile(folder / "hostile.atrium", with_section(whole, bake::archive, hostile));
            if (HasFatalFailure()) return;
        }
    }
}

TEST(bake_hostile, random_archives_with_right_hashes)
{
    using Clock = std::chrono::steady_clock;
    const char* seconds = std::getenv("ATRIUM_FUZZ_SECONDS");
    const auto end = Clock::now() + std::chrono::seconds(seconds != nullptr ? std::atoi(seconds) : 0);
    const TempFolder folder;
    const Bytes wholes[] = {baked(folder, rich_bake()), baked(folder, tiny_bake())};
    const Bytes archives[] = {section(wholes[0], bake::archive), section(wholes[1], bake::archive)};

    std::uint64_t seed = 0, opened = 0;
    for (; seed < 6000 || Clock::now() < end; ++seed) {
        SCOPED_TRACE(seed);
        Mutator mutate(seed);
        Bytes archive = archives[seed % 2];
        mutate.archive(archive);
        Bytes file = with_section(wholes[seed % 2], bake::archive, archive);
        if (mutate.below(8) == 0) { // the table too
            put(file, mutate.below(table_end - 8), static_cast<std::uint64_t>(mutate.below(file.size() + 4096)));
            rehash(file);
        }
        opened += open_hostile(folder / "hostile.atrium", file) ? 1 : 0;
        if (HasFailure()) return;
    }
    // Changed names and numbers are no damage; if nothing opened, or all did, the test would show nothing.
    EXPECT_GT(opened, seed / 100);
    EXPECT_LT(opened, seed / 2);
    RecordProperty("seeds", std::to_string(seed));
}

} // namespace
} // namespace atrium
