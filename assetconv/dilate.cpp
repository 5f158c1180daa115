#include "assetconv/dilate.hpp"

#include "assetconv/srgb.hpp"

namespace atrium {
namespace {

/// Linear colour times weight, weight.
struct Level {
    int width, height;
    std::vector<vec4> texels;

    vec4& at(int x, int y)
    {
        return texels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
    }
};

Level pull(Level& fine)
{
    Level coarse{(fine.width + 1) / 2, (fine.height + 1) / 2, {}};
    coarse.texels.assign(static_cast<std::size_t>(coarse.width) * static_cast<std::size_t>(coarse.height), vec4(0));
    for (int y = 0; y < fine.height; ++y) {
        for (int x = 0; x < fine.width; ++x) coarse.at(x / 2, y / 2) += fine.at(x, y);
    }
    return coarse;
}

} // namespace

void dilate_color(PackedImage& image, int visible_code)
{
    const std::array<float, 256>& decode = srgb_decode_table();
    Level level{image.width, image.height, {}};
    level.texels.reserve(image.texels.size() / 4);
    bool any_hidden = false;
    for (std::size_t i = 0; i < image.texels.size(); i += 4) {
        const std::uint8_t* t = &image.texels[i];
        const bool visible = t[3] >= visible_code;
        any_hidden |= !visible;
        level.texels.push_back(visible ? vec4(decode[t[0]], decode[t[1]], decode[t[2]], 1) : vec4(0));
    }
    if (!any_hidden) return;
    std::vector<Level> levels;
    levels.push_back(std::move(level));
    while (levels.back().width > 1 || levels.back().height > 1) levels.push_back(pull(levels.back()));
    if (levels.back().texels[0].w == 0) return; // nothing is visible at all
    for (std::size_t l = levels.size() - 1; l-- > 0;) {
        for (int y = 0; y < levels[l].height; ++y) {
            for (int x = 0; x < levels[l].width; ++x) {
                vec4& t = levels[l].at(x, y);
                if (t.w > 0)
                    t /= t.w;
                else
                    t = levels[l + 1].at(x / 2, y / 2) / levels[l + 1].at(x / 2, y / 2).w;
            }
        }
    }
    for (std::size_t i = 0; i < levels[0].texels.size(); ++i) {
        std::uint8_t* t = &image.texels[i * 4];
        if (t[3] >= visible_code) continue;
        for (int k = 0; k < 3; ++k) t[k] = srgb_encode8(levels[0].texels[i][k]);
    }
}

} // namespace atrium
