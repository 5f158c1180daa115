// Where an invocation is in a dispatch. graph::Cmd::dispatch() lays out work groups in several rows where there are more
// than the 65,535 that every device takes along x: a shader that is dispatched by it numbers its work by these, and
// leaves out what is beyond its count. Macros, because gl_WorkGroupSize is known only after the shader's layout.
#ifndef DISPATCH_GLSL
#define DISPATCH_GLSL

#define GROUP_INDEX (gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x)
#define INVOCATION_INDEX (GROUP_INDEX * gl_WorkGroupSize.x + gl_LocalInvocationIndex)

#endif
