#version 460
// The same colour, half opaque, into two targets.
layout(location = 0) out vec4 out_first;
layout(location = 1) out vec4 out_second;

void main() { out_first = out_second = vec4(1.0, 0.5, 0.25, 0.5); }
