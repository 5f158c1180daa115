// Class "masked": holes where the opacity is below the cutoff.
#include "materials/surface.glsl"

SurfaceSample surface(Material m, SurfacePoint p)
{
    vec4 base_color = sample_base_color(m, p.uv);
    if (mask_opacity(m, p.uv, base_color.a) < m.alpha_cutoff) discard;
    return sample_surface(m, p, base_color);
}
