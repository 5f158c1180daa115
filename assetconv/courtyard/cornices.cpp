#include "assetconv/courtyard/court.hpp"
#include "assetconv/courtyard/shapes.hpp"

#include <fmt/format.h>

namespace atrium::courtyard {
namespace {

/// The string course between the floors: frieze moulding, corona and sloping top, on the face of the lower wall.
Profile string_course(const Cut& cut)
{
    ProfilePath p({-0.03f, string_course_bottom}, cut);
    p.by(0.055f, 0).by(0, 0.035f).cavetto(0.035f, 0.045f).by(0.008f, 0).by(0, 0.1f); // the dentils' band
    p.by(0.075f, 0).by(0, 0.05f).ovolo(0.03f, 0.035f).by(0, 0.012f);
    p.to(0.02f, gallery_floor - 0.005f).to(-0.2f, gallery_floor);
    return p.finish(0.007f);
}

/// Under the eaves.
Profile eaves_cornice(const Cut& cut)
{
    ProfilePath p({-0.03f, eaves_cornice_bottom}, cut);
    p.by(0.05f, 0).by(0, 0.04f).torus(0.028f).by(0.006f, 0).by(0, 0.03f);
    p.cyma(0.07f, 0.1f).by(0.01f, 0).to(0.106f, eaves_top - 0.02f).by(-0.2f, 0);
    return p.finish(0.006f);
}

void draw_dentils(Court& court, const Side& side)
{
    Pen stone = court.pen("dentils_" + side.name, "limestone_trim", side.frame);
    constexpr float pitch = 0.2f, width = 0.1f;
    const float reach = side.half - wall_half - 0.16f;
    const int count = static_cast<int>(2 * reach / pitch);
    for (int i = 0; i < count; ++i) {
        const float x = (static_cast<float>(i) + 0.5f - 0.5f * static_cast<float>(count)) * pitch;
        const float y = string_course_bottom + 0.088f;
        stone.set_uv_offset({0, 0.13f * static_cast<float>(i % 7)});
        draw_box(stone, {{x - 0.5f * width, y, wall_half + 0.04f},
                         {x + 0.5f * width, y + 0.085f, wall_half + 0.115f},
                         0.006f,
                         face_back | face_top});
    }
}

} // namespace

void build_cornices(Court& court)
{
    Pen lower = court.pen("string_course", "limestone_trim");
    draw_rect_sweep(lower, string_course(court.fine.cut),
                    {half_length - wall_half, half_width - wall_half, true, 0, long_bays});
    Pen upper = court.pen("eaves_cornice", "limestone_trim");
    draw_rect_sweep(upper, eaves_cornice(court.fine.cut),
                    {half_length - upper_wall_half, half_width - upper_wall_half, true, 0, long_bays});
    if (court.fine.small_things) {
        for (const Side& side : sides()) {
            draw_dentils(court, side);
        }
    }
}

} // namespace atrium::courtyard
