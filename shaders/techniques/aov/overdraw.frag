#version 460
// Adds one for each fragment that is shaded: where there is a depth test, for each that passes it.

layout(early_fragment_tests) in;
layout(location = 0) out vec4 out_count;

void main() { out_count = vec4(1.0); }
