#pragma once
// An OBJ file's geometry as the file has it: no triangulation, no axes turned, every index checked.

#include "assetconv/warnings.hpp"
#include "renderer/core/math.hpp"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace atrium {

/// Indices from 0 into ObjFile's arrays; -1 where the face gives none.
struct ObjCorner {
    std::int32_t position = -1, uv = -1, normal = -1;
};

/// Smoothing of a face: 0 off (flat), a group's number, or this when the file has said nothing yet.
inline constexpr std::uint32_t smoothing_unset = ~0u;

struct ObjFace {
    std::uint32_t first_corner = 0, corner_count = 0;
    std::uint32_t group = 0;    ///< into ObjFile::groups
    std::int32_t material = -1; ///< into ObjFile::materials; -1 before any usemtl
    std::uint32_t smoothing = smoothing_unset;
    std::uint32_t line = 0;
};

/// A name that the file mentions, and the line where it does so first.
struct ObjName {
    std::string name;
    std::uint32_t line = 0;
};

struct ObjFile {
    std::filesystem::path path;
    std::vector<vec3> positions, normals;
    std::vector<vec2> uvs; ///< v up, as in the file
    std::vector<ObjCorner> corners;
    std::vector<ObjFace> faces;
    std::vector<ObjName> groups;    ///< in order of first appearance; the same name again is the same group
    std::vector<ObjName> materials; ///< names after usemtl
    std::vector<ObjName> libraries; ///< the text after each mtllib, which may hold several names
};

/// Parses through tinyobjloader's callbacks, which know no limit of corners per face. Faces with bad indices and
/// statements without a meaning here are dropped and counted. Throws Error(input) when the file is missing.
[[nodiscard]] ObjFile read_obj(const std::filesystem::path& file, Warnings& warnings);

/// "sponza.obj:212"
[[nodiscard]] std::string place(const std::filesystem::path& file, std::uint32_t line);

} // namespace atrium
