#version 460
// Moves points on an edge of the patch to the unit circle.
layout(triangles, equal_spacing, ccw) in;

void main()
{
    vec3 b = gl_TessCoord;
    vec2 at = b.x * gl_in[0].gl_Position.xy + b.y * gl_in[1].gl_Position.xy + b.z * gl_in[2].gl_Position.xy;
    if (min(b.x, min(b.y, b.z)) < 1e-4) at = normalize(at);
    gl_Position = vec4(at, 0.5, 1.0);
}
