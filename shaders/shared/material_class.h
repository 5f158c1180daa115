// Vertex functions of material classes: cases of shape_vertex() in materials/position.glsl.
#ifndef SHARED_MATERIAL_CLASS_H
#define SHARED_MATERIAL_CLASS_H
#include "types.h"
SHARED_BEGIN

const uint vertex_rigid = 0; // as baked

SHARED_END
#endif
