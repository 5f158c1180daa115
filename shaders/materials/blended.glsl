// Class "blended" where nothing can be blended (a G-buffer holds one surface a pixel): screen-door transparency, the
// share of pixels that is kept being the opacity. Noise: Jimenez 2014, "Next Generation Post Processing", IGN.
#include "lib/noise.glsl"
#include "materials/surface.glsl"

bool is_kept(float opacity) { return opacity > interleaved_gradient_noise(floor(gl_FragCoord.xy)); }

/// `bias`: added to the mip level.
bool is_hole(Material m, vec2 uv, float bias)
{
    float opacity = m.opacity;
    if (m.base_color_slot != no_texture_slot) opacity *= sample_material(m.base_color_slot, m.sampler_slot, uv, bias).a;
    return !is_kept(opacity);
}

SurfaceSample surface(Material m, SurfacePoint p)
{
    vec4 base_color = sample_base_color(m, p.uv);
    if (!is_kept(base_color.a)) discard;
    return sample_surface(m, p, base_color);
}
