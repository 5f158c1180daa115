// What the AOV pass can write: the values that follow from the G-buffer.
#ifndef SHARED_AOV_H
#define SHARED_AOV_H
#include "types.h"
SHARED_BEGIN

const uint aov_depth = 0, aov_position = 1, aov_geometric_normal = 2, aov_normal = 3, aov_albedo = 4, aov_roughness = 5,
           aov_metallic = 6, aov_specular = 7, aov_emission = 8, aov_material = 9, aov_mesh = 10, aov_instance = 11,
           aov_motion = 12, aov_light_count = 13, aov_constant = 14, aov_hdr = 15, aov_ao = 16, aov_ao_raw = 17;

struct AovPush {
    float background;  // aov_constant: the value everywhere
    uint scale;        // aov_ao_raw: pixels along the side of a texel
};

SHARED_END
#endif
