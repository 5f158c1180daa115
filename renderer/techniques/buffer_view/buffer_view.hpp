#pragma once
// A buffer as a picture: channels, range, colours, and the statistics of its values. README.md beside this file.

#include "renderer/core/setting.hpp"
#include "renderer/graph/graph.hpp"

#include <array>
#include <cstdint>
#include <string>

namespace atrium {

enum class BufferChannels : std::uint8_t { all, r, g, b, a };
constexpr auto enum_names(BufferChannels)
{
    return std::array{"all", "r", "g", "b", "a"};
}

enum class BufferRange : std::uint8_t { usual, fitted, given };
constexpr auto enum_names(BufferRange)
{
    return std::array{"usual", "fitted", "given"};
}

enum class BufferColors : std::uint8_t { usual, grey, viridis };
constexpr auto enum_names(BufferColors)
{
    return std::array{"usual", "grey", "viridis"};
}

struct BufferViewSettings {
    BufferChannels channels = BufferChannels::all;
    BufferRange range = BufferRange::usual;
    float low = 0, high = 1;
    BufferColors colors = BufferColors::usual;
};

template <class V>
void describe(V& v, BufferViewSettings& s)
{
    v.group("buffer_view", "Buffer view");
    v("channels", s.channels, "Channels of the buffer that debug.view names; one that it has not is 0");
    v("range", s.range,
      "What is darkest and brightest: the buffer's usual range, its least and greatest value, or low and high");
    v("low", s.low, "Darkest value, where range is given");
    v("high", s.high, "Brightest value, where range is given; below low: inverted");
    v("colors", s.colors, "The buffer's usual ones; grey or false colours, of several channels by their length");
}

/// How a buffer is shown where nobody wishes otherwise.
struct BufferLook {
    int channels = 1;   ///< 1 to 4 of the image's
    std::uint32_t mode; ///< shared::view_…
    float low, high;    ///< usual range; the same: there is none, and it is fitted
};

/// What of a buffer's look the settings change.
struct ChosenView {
    std::uint32_t mode, pick; ///< shared::view_…, pick_…
    BufferRange range;        ///< `usual` only where the buffer's usual range means what is picked
};
[[nodiscard]] ChosenView choose_view(const BufferLook& look, const BufferViewSettings& s);

/// Of the finite values of a buffer that is shown, in the channels that are shown.
struct BufferFacts {
    float low = 0, mean = 0, high = 0;
    vec2 range{0, 1};        ///< what is drawn darkest and brightest
    std::uint32_t mode = 0;  ///< shared::view_…: what its colours say
    std::uint32_t count = 0; ///< of values; 0: low, mean and high mean nothing
    bool absent = false;     ///< the frame has no such image, and nothing is shown
};

/// Most buffers that are shown small beside the picture.
inline constexpr std::size_t max_insets = 8;

/// A part of a picture, in pixels from its upper left.
struct PictureArea {
    uvec2 origin{0}, size{0};
};

/// Reads  a buffer (R32F or RGBA32F).  Writes  shared::BufferStatistics of all of its texels.
/// @param name  of its passes: NAME.tiles, NAME.total
[[nodiscard]] graph::Buf add_buffer_statistics(graph::Graph& g, graph::Tex buffer, const BufferLook& look,
                                               const BufferViewSettings& s, const std::string& name);

/// Reads  a buffer, its statistics.  Returns  the picture (RGBA8 sRGB) with the buffer in an area of it, sampled at the
/// nearest texel.
/// @param load  what becomes of the rest of the picture
[[nodiscard]] graph::Tex add_buffer_view(graph::Graph& g, graph::Tex buffer, graph::Buf statistics,
                                         const BufferLook& look, const BufferViewSettings& s, graph::Tex picture,
                                         const PictureArea& area, graph::Load load, const std::string& name);

} // namespace atrium
