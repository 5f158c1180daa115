#version 460
// Splits each edge into a constant number of segments.
layout(constant_id = 0) const uint factor = 1u;
layout(vertices = 3) out;

void main()
{
    gl_out[gl_InvocationID].gl_Position = gl_in[gl_InvocationID].gl_Position;
    for (int i = 0; i < 3; ++i) gl_TessLevelOuter[i] = float(factor);
    gl_TessLevelInner[0] = float(factor);
}
