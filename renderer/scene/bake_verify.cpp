// What `assetconv verify` checks beyond opening: the bulk sections' bytes and the padding between sections.

#include "renderer/core/hash.hpp"
#include "renderer/scene/bake_file.hpp"
#include "renderer/scene/bake_internal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace atrium {
namespace {

using Bytes = std::span<const std::byte>;

template <class T>
T load(Bytes bytes, std::size_t index)
{
    T value;
    std::memcpy(&value, bytes.data() + index * sizeof(T), sizeof(T));
    return value;
}

void check_padding(const BakeFile& bake, const std::string& name)
{
    std::size_t end = sizeof(bake::Header) + sizeof(bake::Table);
    for (std::size_t i = 0; i < bake::section_count; ++i) {
        const auto begin = static_cast<std::size_t>(bake.table()[i].offset);
        const Bytes padding = bake.bytes().subspan(end, begin - end);
        const auto damage = std::find_if(padding.begin(), padding.end(), [](std::byte b) { return b != std::byte{0}; });
        if (damage != padding.end()) {
            bake::refuse(name, std::string("padding before section ") + bake::section_names[i],
                         fmt::format("byte {} of the file is not zero", end + (damage - padding.begin())));
        }
        end = begin + static_cast<std::size_t>(bake.table()[i].size);
    }
}

void check_vertices(const BakeFile& bake, const std::string& name)
{
    for (std::size_t i = 0; i < bake.scene().vertex_count; ++i) {
        const auto v = load<Vertex>(bake.vertices(), i);
        // A sum is finite only if all of its terms are; far cheaper than a test of each, and terms that overflow only
        // together are looked at again.
        if (std::isfinite(v.position.x + v.position.y + v.position.z + v.uv.x + v.uv.y)) continue;
        for (const float f : {v.position.x, v.position.y, v.position.z, v.uv.x, v.uv.y}) {
            if (!std::isfinite(f)) bake::refuse(name, "section vertices", fmt::format("vertex {} is not finite", i));
        }
    }
}

void check_indices(const BakeFile& bake, const std::string& name)
{
    const Bytes indices = bake.indices();
    const std::vector<Mesh>& meshes = bake.scene().meshes;
    for (std::size_t m = 0; m < meshes.size(); ++m) {
        const Mesh& mesh = meshes[m];
        const std::size_t first = mesh.first_index, end = first + mesh.index_count;
        const auto outside = [&](std::size_t i) {
            return load<std::uint32_t>(indices, i) - mesh.first_vertex >= mesh.vertex_count; // wraps below the range
        };
        unsigned any = 0; // without a branch per index, so that it is vectorised
        for (std::size_t i = first; i < end; ++i) any |= outside(i) ? 1u : 0u;
        for (std::size_t i = first; any != 0 && i < end; ++i) {
            if (!outside(i)) continue;
            bake::refuse(name, "section indices",
                         fmt::format("index {} names vertex {}, mesh {} has {} to {}", i,
                                     load<std::uint32_t>(indices, i), m, mesh.first_vertex,
                                     std::uint64_t{mesh.first_vertex} + mesh.vertex_count - 1));
        }
    }
}

} // namespace

void check_hashes(const BakeFile& bake)
{
    for (std::size_t i = 0; i < bake::section_count; ++i) {
        if (hash64(bake.section(static_cast<bake::Section>(i))) == bake.table()[i].hash) continue;
        bake::refuse(bake.path().string(), std::string("section ") + bake::section_names[i], "its hash does not match");
    }
}

std::vector<std::string> verify_bake(const std::filesystem::path& file)
{
    const BakeFile bake(file);
    const std::string name = file.string();
    check_padding(bake, name);
    check_hashes(bake);

    std::vector<std::string> lines;
    for (std::size_t i = 0; i < bake::section_count; ++i) {
        const bake::SectionEntry& entry = bake.table()[i];
        lines.push_back(fmt::format("{:<8} {:>12} bytes at {:>12}, XXH3 {:016x}: whole", bake::section_names[i],
                                    entry.size, entry.offset, entry.hash));
    }
    check_vertices(bake, name);
    check_indices(bake, name);
    return lines;
}

} // namespace atrium
