// Class "masked": holes where the opacity is below the cutoff.
#include "materials/surface.glsl"

// The cutoff for which the bake's coarser levels are made. A scene file's cutoff is used at the finest level and blended to
// this one at the second; a mask with hard edges has the same area with either.
const float baked_cutoff = 0.5;

/// `bias`: added to the mip level.
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
