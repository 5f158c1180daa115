#pragma once
// Small scenes written into a folder of their own, and baked from there.

#include "assetconv/bake.hpp"
#include "renderer/core/image.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>

namespace atrium::test {

/// A folder that goes away with the test.
class Folder {
public:
    Folder()
    {
        std::string name = (std::filesystem::temp_directory_path() / "atrium-assetconv-XXXXXX").string();
        path_ = mkdtemp(name.data());
    }
    ~Folder()
    {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    [[nodiscard]] std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

    std::filesystem::path write(const std::string& name, const std::string& text) const
    {
        std::filesystem::create_directories((path_ / name).parent_path());
        std::ofstream(path_ / name, std::ios::binary) << text;
        return path_ / name;
    }

    /// `texel(x, y)` gives 0..255 for each channel.
    template <class Texel>
    std::filesystem::path write_image(const std::string& name, int width, int height, int channels, Texel&& texel) const
    {
        Image8 image(width, height, channels);
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                const auto value = texel(x, y);
                for (int k = 0; k < channels; ++k)
                    image.at(x, y)[k] = static_cast<std::uint8_t>(value[static_cast<std::size_t>(k)]);
            }
        }
        std::filesystem::create_directories((path_ / name).parent_path());
        write_png(path_ / name, image);
        return path_ / name;
    }

private:
    std::filesystem::path path_;
};

using Rgb = std::array<int, 3>;
using Rgba = std::array<int, 4>;

/// One square of two triangles in the xy plane that uses every corner of a texture.
inline const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"
                                  "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvn 0 0 1\n";
inline const std::string square_face = "f 1/1/1 2/2/1 3/3/1 4/4/1\n";

/// Bakes a square with one material, whose MTL lines are given.
inline BakeData bake_material(const Folder& folder, const std::string& mtl, BakeOptions options = {})
{
    folder.write("m.mtl", "newmtl m\n" + mtl);
    options.input = folder.write("m.obj", "mtllib m.mtl\n" + square + "usemtl m\n" + square_face);
    return bake_scene(options);
}

inline BakeData bake_text(const Folder& folder, const std::string& obj, BakeOptions options = {})
{
    options.input = folder.write("scene.obj", obj);
    return bake_scene(options);
}

inline std::uint64_t warnings_of(const BakeData& bake, const std::string& kind)
{
    for (const BakeWarning& w : bake.scene.warnings) {
        if (w.kind == kind) return w.count;
    }
    return 0;
}

/// Channel `k` of a texel of a mip of a bake's texture.
inline int texel(const BakeData& bake, std::int32_t texture, std::uint32_t mip, std::uint32_t x, std::uint32_t y, int k)
{
    const Texture& t = bake.scene.textures.at(static_cast<std::size_t>(texture));
    const std::uint64_t channels = t.format == TextureFormat::rg8_unorm ? 2 : 4;
    const std::uint64_t width = std::max(1u, t.width >> mip);
    const std::uint64_t at = t.offset + mip_offsets(t.format, t.width, t.height, t.mips)[mip] +
                             (y * width + x) * channels + static_cast<std::uint64_t>(k);
    return std::to_integer<int>(bake.texels.at(at));
}

} // namespace atrium::test
