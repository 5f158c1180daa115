// The index of an invocation in a dispatch. graph::Cmd::dispatch() arranges work groups in several rows if there are more
// than 65,535, the limit along x that every device supports. A shader takes the index of its work item from these macros
// and returns if it is beyond the count. Macros, because gl_WorkGroupSize is known only after the shader's layout.
#ifndef DISPATCH_GLSL
#define DISPATCH_GLSL

#define GROUP_INDEX (gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x)
#define INVOCATION_INDEX                                                                                               \
    (gl_GlobalInvocationID.y * (gl_NumWorkGroups.x * gl_WorkGroupSize.x) + gl_GlobalInvocationID.x)

#endif
