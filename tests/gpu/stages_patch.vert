#version 460
// Control points of a patch: an equilateral triangle in the unit circle, counter-clockwise.

void main()
{
    float angle = radians(90.0 + 120.0 * float(gl_VertexIndex));
    gl_Position = vec4(cos(angle), sin(angle), 0.5, 1.0);
}
