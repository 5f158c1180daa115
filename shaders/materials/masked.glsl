// Class "masked": holes where the opacity is below the cutoff.
#include "materials/surface.glsl"

bool is_hole(Material m, vec2 uv, float opacity) { return mask_opacity(m, uv, opacity) < m.alpha_cutoff; }

SurfaceSample surface(Material m, SurfacePoint p)
{
    vec4 base_color = sample_base_color(m, p.uv);
    if (is_hole(m, p.uv, base_color.a)) discard;
    return sample_surface(m, p, base_color);
}
