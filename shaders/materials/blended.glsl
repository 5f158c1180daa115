// Class "blended" where nothing can be blended (a G-buffer holds one surface a pixel): screen-door transparency, the
// share of pixels that is kept being the opacity. Noise: Jimenez 2014, "Next Generation Post Processing", IGN.
#include "materials/surface.glsl"

SurfaceSample surface(Material m, SurfacePoint p)
{
    vec4 base_color = sample_base_color(m, p.uv);
    vec2 pixel = floor(gl_FragCoord.xy);
    float threshold = fract(52.9829189 * fract(dot(pixel, vec2(0.06711056, 0.00583715))));
    if (base_color.a <= threshold) discard;
    return sample_surface(m, p, base_color);
}
