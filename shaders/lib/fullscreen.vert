#version 460
// One triangle that covers the screen, in the far plane (reversed depth 0). Fragments place themselves by gl_FragCoord.

void main()
{
    vec2 corner = vec2((gl_VertexIndex << 1) & 2, gl_VertexIndex & 2);
    gl_Position = vec4(corner * 2.0 - 1.0, 0.0, 1.0);
}
