// Class "blended" where nothing can be blended (a G-buffer holds one surface a pixel): screen-door transparency, the
// share of pixels that is kept being the opacity. Noise: Jimenez 2014, "Next Generation Post Processing", IGN.
#include "lib/noise.glsl"
#include "materials/surface.glsl"

bool is_hole(Material m, vec2 uv, float opacity) { return opacity <= interleaved_gradient_noise(floor(gl_FragCoord.xy)); }

SurfaceSample surface(Material m, SurfacePoint p)
{
    vec4 base_color = sample_base_color(m, p.uv);
    if (is_hole(m, p.uv, base_color.a)) discard;
    return sample_surface(m, p, base_color);
}
