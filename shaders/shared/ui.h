// The user interface: triangles over the picture.
#ifndef SHARED_UI_H
#define SHARED_UI_H
#include "types.h"
SHARED_BEGIN

// What a triangle is textured with: nothing, the font's coverage, the buffers beside the picture, or a texture of the
// scene's, its slot counted on.
const uint ui_plain = 0, ui_font = 1, ui_insets = 2, ui_textures = 3;

struct UiVertex {
    vec2 position; // pixels from the window's upper left
    vec2 uv;
    uint color;    // RGBA8, red lowest; sRGB-encoded, as the window is
};

struct UiPush {
    vec2 inv_size; // of the window, 1 / pixels
    uint image;    // ui_…
};

struct PicturesPush {
    vec2 inv_size; // of the window, 1 / pixels
    float divider; // the first pixel of the main picture; left of it stands the other one
};

SHARED_END
#ifdef __cplusplus
static_assert(sizeof(atrium::shared::UiVertex) == 20);
#endif
#endif
