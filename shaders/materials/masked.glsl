// Class "masked": holes where the opacity is below the cutoff.
#include "materials/surface.glsl"

// What the bake's coarser levels are made for. A scene file's cutoff holds at the finest level; hard masks have the same
// area at any.
const float baked_cutoff = 0.5;

/// `bias`: so many mip levels further than a picture reads.
bool is_hole(Material m, vec2 uv, float bias)
{
    vec2 opacity_level = mask_opacity(m, uv, bias);
    return opacity_level.x < mix(m.alpha_cutoff, baked_cutoff, min(opacity_level.y, 1.0));
}

SurfaceSample surface(Material m, SurfacePoint p)
{
    vec4 base_color = sample_base_color(m, p.uv);
    if (is_hole(m, p.uv, 0.0)) discard;
    return sample_surface(m, p, base_color);
}
