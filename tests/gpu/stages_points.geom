#version 460
// A square of side 0.25 around each point.
layout(points) in;
layout(triangle_strip, max_vertices = 4) out;

void main()
{
    for (int i = 0; i < 4; ++i) {
        gl_Position = gl_in[0].gl_Position + vec4(0.25 * vec2(i & 1, i >> 1) - 0.125, 0.0, 0.0);
        EmitVertex();
    }
}
