#version 460
// Three points, at x = -0.5, 0 and 0.5.

void main() { gl_Position = vec4(0.5 * float(gl_VertexIndex) - 0.5, 0.0, 0.5, 1.0); }
