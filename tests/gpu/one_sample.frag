#version 460
// White in the first sample of each pixel, and in no other.
layout(location = 0) out vec4 out_color;

void main()
{
    gl_SampleMask[0] = 1;
    out_color = vec4(1.0);
}
