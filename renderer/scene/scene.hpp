#pragma once
// The scene as the bake holds it: what the converter writes and the renderer draws. No Vulkan here.
// World: right-handed, +Y up, metres. UV (0,0) is the image's upper left (the converter flipped v once).

#include "renderer/core/math.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace atrium {

enum class MaterialClass : std::uint8_t { opaque, masked, blended, cloth };
inline constexpr int material_class_count = 4;
[[nodiscard]] const char* to_string(MaterialClass c);

/// Texel formats of the bake. The name printed by `assetconv info` is to_string's.
enum class TextureFormat : std::uint8_t {
    rgba8_srgb,  ///< colour, alpha linear
    rgba8_unorm, ///< data
    rg8_unorm,   ///< xy of a tangent-space normal, n = 2c - 1, z = sqrt(1 - x^2 - y^2)
    r8_unorm,
    bc1_srgb,
    bc3_srgb,
    bc3_unorm,
    bc5_unorm,
};
[[nodiscard]] const char* to_string(TextureFormat f);
[[nodiscard]] bool is_block_compressed(TextureFormat f);
/// Bytes of one mip level of the given size.
[[nodiscard]] std::uint64_t mip_bytes(TextureFormat f, std::uint32_t width, std::uint32_t height);

/// A texture with its mip chain, down to 1x1 (for masks it may end earlier), stored level after level from `offset` of
/// the texels section.
/// Each level starts at a multiple of texel_alignment.
struct Texture {
    std::string file; ///< name in the source; several joined by "+" when the bake packed them together
    std::uint32_t width = 0, height = 0, mips = 0;
    TextureFormat format = TextureFormat::rgba8_unorm;
    bool clamp = false;       ///< clamp to edge instead of repeat
    std::uint64_t offset = 0; ///< bytes from the start of the texels section
    std::uint64_t size = 0;   ///< bytes, padding between levels included
};
inline constexpr std::uint64_t texel_alignment = 16;
/// Byte offsets of each mip from the texture's own offset, and the total size as last element (mips + 1 values).
[[nodiscard]] std::vector<std::uint64_t> mip_offsets(TextureFormat f, std::uint32_t width, std::uint32_t height,
                                                     std::uint32_t mips);

inline constexpr std::int32_t no_texture = -1;

/// The one material model (TECHNIQUES of the field: metallic-roughness with a dielectric F0). Texture indices are into
/// Scene::textures or no_texture. A factor multiplies its texture's channel.
struct Material {
    std::string name;
    MaterialClass cls = MaterialClass::opaque;
    bool two_sided = false;
    vec3 base_color{0.8f};                        ///< linear Rec.709
    float opacity = 1.0f;                         ///< multiplies the base colour texture's alpha
    float alpha_cutoff = 0.5f;                    ///< masked: alpha below this is a hole
    float roughness = 1.0f;                       ///< perceptual, 0..1; multiplies surface.g
    float metallic = 0.0f;                        ///< multiplies surface.b
    float specular = 0.04f;                       ///< dielectric F0; multiplies surface.r
    vec3 emission{0.0f};                          ///< radiance
    std::int32_t base_color_texture = no_texture; ///< rgb base colour, a opacity
    std::int32_t normal_texture = no_texture;     ///< tangent-space xy, green up (+y along the bitangent)
    std::int32_t surface_texture = no_texture;    ///< r specular scale, g roughness, b metallic; linear
    std::int32_t emission_texture = no_texture;
};

/// Interleaved vertex as the vertices section and the GPU's vertex buffer hold it. 28 bytes.
/// `normal`: octahedral, 16-bit unorm x | y << 16. `tangent`: octahedral, x 16 bits, y 15 bits << 16, bit 31 set when
/// the handedness w is -1; bitangent b = w cross(n, t).
struct Vertex {
    vec3 position;
    std::uint32_t normal;
    std::uint32_t tangent;
    vec2 uv;
};
static_assert(sizeof(Vertex) == 28);

/// A run of the index buffer small enough to be culled as one. Indices are 32 bit and absolute (into all vertices).
/// Cone: every triangle faces away from eye when dot(centre - eye, axis) >= cutoff * |centre - eye| + radius
/// (meshoptimizer's rule); cutoff >= 1 never culls.
struct Cluster {
    vec3 centre{0};
    float radius = 0;
    vec3 cone_axis{0, 0, 1};
    float cone_cutoff = 1;
    std::uint32_t first_index = 0, index_count = 0;
};

/// One OBJ group (or object) x material. Its clusters, and so its indices, are contiguous and in order.
struct Mesh {
    std::string name;
    std::uint32_t material = 0;
    std::uint32_t first_index = 0, index_count = 0;
    std::uint32_t first_vertex = 0, vertex_count = 0;
    std::uint32_t first_cluster = 0, cluster_count = 0;
    bool two_sided = false;
    Bounds bounds;
};

/// A warning of the bake, counted by kind; `first` tells where the first one stood.
struct BakeWarning {
    std::string kind;
    std::uint64_t count = 0;
    std::string first;
};

/// Everything of a bake but its bulk data.
struct Scene {
    std::vector<Material> materials;
    std::vector<Texture> textures;
    std::vector<Mesh> meshes;
    std::vector<Cluster> clusters;
    std::vector<BakeWarning> warnings;
    Bounds bounds;
    std::uint64_t vertex_count = 0, index_count = 0;
    std::string source; ///< file name of the OBJ, without folder
};

} // namespace atrium
