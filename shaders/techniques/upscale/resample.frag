#version 460
// A picture at another size by a separable filter, for comparison with EASU. Sources: Keys 1981, "Cubic Convolution
// Interpolation for Digital Image Processing" (Catmull-Rom); Duchon 1979 (Lanczos).
#extension GL_GOOGLE_include_directive : require
#include "lib/pass.glsl"
#include "shared/upscale.h"

layout(constant_id = 0) const uint resample_filter = resample_bilinear;
layout(push_constant, scalar) uniform Push { UpscalePush push; };
layout(PASS_IMAGE(0)) uniform texture2D source; // encoded for display, 0 to 1
layout(location = 0) out vec4 out_color;

const float pi = 3.14159265;
const int radius = resample_filter == resample_bilinear ? 1 : resample_filter == resample_catmull_rom ? 2 : 3;

/// Weight of a pixel at a distance of up to `radius`.
float weight(float x)
{
    x = abs(x);
    if (resample_filter == resample_bilinear) return max(1.0 - x, 0.0);
    if (resample_filter == resample_catmull_rom)
        return x < 1.0 ? (1.5 * x - 2.5) * x * x + 1.0 : x < 2.0 ? ((-0.5 * x + 2.5) * x - 4.0) * x + 2.0 : 0.0;
    if (x < 1e-4) return 1.0;
    return x < 3.0 ? 3.0 * sin(pi * x) * sin(pi * x / 3.0) / (pi * pi * x * x) : 0.0;
}

void main()
{
    vec2 position = floor(gl_FragCoord.xy) * push.scale + push.offset;
    vec2 whole = floor(position), t = position - whole;
    ivec2 last = textureSize(source, 0) - 1;
    float weights_x[2 * radius];
    for (int i = 0; i < 2 * radius; ++i) weights_x[i] = weight(float(i + 1 - radius) - t.x);
    vec3 sum = vec3(0.0);
    float weights = 0.0;
    for (int row = 0; row < 2 * radius; ++row) {
        float weight_y = weight(float(row + 1 - radius) - t.y);
        for (int column = 0; column < 2 * radius; ++column) {
            ivec2 at = clamp(ivec2(whole) + ivec2(column, row) + 1 - radius, ivec2(0), last);
            float w = weights_x[column] * weight_y;
            sum += w * texelFetch(source, at, 0).rgb;
            weights += w;
        }
    }
    out_color = vec4(clamp(sum / weights, 0.0, 1.0), 1.0);
}
