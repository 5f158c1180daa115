#pragma once
// Reading and writing .atrium files.

#include "renderer/core/mapped_file.hpp"
#include "renderer/scene/bake_format.hpp"
#include "renderer/scene/scene.hpp"

#include <array>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace atrium {

/// A bake, mapped. Opening checks header, table and archive in full (hashes, every bound, every index) and bulk
/// sections by size only; whatever the file holds, opening takes memory in proportion to its archive.
/// Throws Error(input) that names the section.
class BakeFile {
public:
    explicit BakeFile(const std::filesystem::path& file);

    [[nodiscard]] const Scene& scene() const { return scene_; }
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    [[nodiscard]] std::span<const std::byte> bytes() const
    {
        return file_.bytes();
    } ///< the whole mapping, page-aligned
    /// scene().vertex_count x sizeof(Vertex)
    [[nodiscard]] std::span<const std::byte> vertices() const { return section(bake::vertices); }
    /// scene().index_count x 4 bytes
    [[nodiscard]] std::span<const std::byte> indices() const { return section(bake::indices); }
    [[nodiscard]] std::span<const std::byte> texels() const { return section(bake::texels); }
    [[nodiscard]] std::span<const std::byte> section(bake::Section s) const;
    [[nodiscard]] const bake::Table& table() const { return table_; }

private:
    std::filesystem::path path_;
    MappedFile file_;
    bake::Table table_{}; ///< a copy: checked once, whatever happens to the file later
    Scene scene_;
};

/// Bulk data of a bake under construction.
struct BakeData {
    Scene scene;
    std::vector<Vertex> vertices;
    std::vector<std::uint32_t> indices;
    std::vector<std::byte> texels;
};

/// Writes atomically. The same data give the same bytes. Throws what check_scene throws, before anything is written.
void write_bake(const std::filesystem::path& file, const BakeData& data);

/// Throws Error(input) if the bytes of a section do not match its hash. Opening checks bulk sections by size only.
void check_hashes(const BakeFile& bake);

/// Everything `verify` checks beyond opening: the hash of every section, every cross reference of the bulk data
/// (each index below its mesh's vertex range), padding, nothing after the last section. Returns one line per section;
/// throws Error(input) at the first damage.
[[nodiscard]] std::vector<std::string> verify_bake(const std::filesystem::path& file);

/// Checks every index, range and finite value inside a scene against its counts and the given bulk sizes.
/// A scene holds at least one mesh; meshes share no clusters, no indices and no texels with each other and leave none
/// over, so that drawing and loading cost no more than the file's size. Throws Error(input) whose where is `where` and
/// the element.
void check_scene(const Scene& scene, std::uint64_t vertices_size, std::uint64_t indices_size, std::uint64_t texels_size,
                 const std::string& where);

} // namespace atrium
