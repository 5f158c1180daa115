// Class "opaque": a closed surface.
#include "materials/surface.glsl"

SurfaceSample surface(Material m, SurfacePoint p) { return sample_surface(m, p, sample_base_color(m, p.uv)); }
