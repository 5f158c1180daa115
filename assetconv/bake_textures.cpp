#include "assetconv/bake_materials.hpp"

#include "assetconv/block_compression.hpp"
#include "assetconv/mips.hpp"
#include "renderer/core/jobs.hpp"
#include "renderer/core/progress.hpp"

#include <cstring>
#include <unordered_map>

namespace atrium {
namespace {

TextureFormat format_of(const TextureRecipe& recipe, TextureEncoding encoding)
{
    const bool bc = encoding == TextureEncoding::bc;
    switch (recipe.role) {
    case TextureRole::base_color:
        if (!bc) return TextureFormat::rgba8_srgb;
        return recipe.alpha ? TextureFormat::bc3_srgb : TextureFormat::bc1_srgb;
    case TextureRole::emission:
        return bc ? TextureFormat::bc1_srgb : TextureFormat::rgba8_srgb;
    case TextureRole::normal:
        return bc ? TextureFormat::bc5_unorm : TextureFormat::rg8_unorm;
    case TextureRole::surface:
        return bc ? TextureFormat::bc3_unorm : TextureFormat::rgba8_unorm;
    }
    return TextureFormat::rgba8_unorm;
}

MipSpace space_of(TextureRole role)
{
    switch (role) {
    case TextureRole::base_color:
    case TextureRole::emission:
        return MipSpace::srgb_color;
    case TextureRole::normal:
        return MipSpace::normals;
    case TextureRole::surface:
        return MipSpace::data;
    }
    return MipSpace::data;
}

/// A texture with its texels, laid out as the bake wants them.
struct BakedTexture {
    Texture texture;
    std::vector<std::byte> texels;
};

BakedTexture bake_texture(const TextureRecipe& recipe, const ImageStore& images, const BakeOptions& options)
{
    std::optional<MaskTest> mask;
    if (recipe.cutoff) mask = MaskTest{*recipe.cutoff, recipe.clamp};
    std::vector<MipLevel> levels =
        build_mips(pack_texture(recipe, images), space_of(recipe.role), mask, options.max_texture_size);
    BakedTexture out;
    Texture& t = out.texture;
    t.file = recipe.file();
    t.width = levels[0].width;
    t.height = levels[0].height;
    t.mips = static_cast<std::uint32_t>(levels.size());
    t.format = format_of(recipe, options.textures);
    t.clamp = recipe.clamp;
    const std::vector<std::uint64_t> offsets = mip_offsets(t.format, t.width, t.height, t.mips);
    t.size = offsets.back();
    out.texels.resize(t.size);
    for (std::size_t i = 0; i < levels.size(); ++i) {
        if (is_block_compressed(t.format)) levels[i].texels = compress_level(levels[i], t.format);
        std::memcpy(&out.texels[offsets[i]], levels[i].texels.data(), levels[i].texels.size());
    }
    return out;
}

} // namespace

void bake_textures(const MaterialSet& set, const BakeOptions& options, BakeData& out)
{
    std::vector<const TextureRecipe*> recipes;
    std::unordered_map<std::string, std::int32_t> known;
    const auto index_of = [&](const std::optional<TextureRecipe>& recipe) {
        if (!recipe) return no_texture;
        const auto [at, added] = known.try_emplace(recipe->key(), static_cast<std::int32_t>(recipes.size()));
        if (added) recipes.push_back(&*recipe);
        return at->second;
    };
    for (const MaterialPlan& plan : set.plans) {
        Material m = plan.material;
        m.base_color_texture = index_of(plan.base_color);
        m.normal_texture = index_of(plan.normal);
        m.surface_texture = index_of(plan.surface);
        m.emission_texture = index_of(plan.emission);
        out.scene.materials.push_back(std::move(m));
    }
    if (recipes.empty()) return;

    std::vector<BakedTexture> baked(recipes.size());
    Progress progress("packing textures", recipes.size());
    parallel_for(recipes.size(), [&](std::size_t i) {
        baked[i] = bake_texture(*recipes[i], set.images, options);
        progress.advance();
    });
    std::uint64_t size = 0;
    for (const BakedTexture& b : baked) size += b.texels.size();
    out.texels.reserve(size);
    for (BakedTexture& b : baked) {
        b.texture.offset = out.texels.size(); // mip_offsets pads each texture to the alignment
        out.scene.textures.push_back(b.texture);
        out.texels.insert(out.texels.end(), b.texels.begin(), b.texels.end());
        b.texels = {};
    }
}

} // namespace atrium
