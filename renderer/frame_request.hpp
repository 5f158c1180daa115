#pragma once
// The input of a frame: everything that it is drawn from, except the scene.

#include "renderer/gpu/timers.hpp"
#include "renderer/picture_slot.hpp"
#include "renderer/scene/camera.hpp"
#include "renderer/scene/instance.hpp"
#include "renderer/scene/light.hpp"
#include "renderer/scene/material_override.hpp"
#include "renderer/settings.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace atrium {

/// A buffer shown small next to the picture, with its own display range and colours.
struct Inset {
    Aov aov;
    BufferViewSettings view;
};

struct Insets {
    std::vector<Inset> buffers;
    uvec2 size{0}; ///< of each, pixels
};

struct FrameRequest {
    uvec2 size{1280, 720};
    Camera camera;
    Camera previous_camera; ///< of the frame before, for motion vectors
    vec2 jitter{0};         ///< View::jitter
    std::uint64_t frame_index = 0;
    double time = 0, time_step = 0;                   ///< s; since the frame before
    bool cut = false;                                 ///< no history of the previous frame is valid
    std::vector<PreviousInstance> previous_instances; ///< those that have moved since the previous frame
    std::vector<Light> lights;                        ///< at most max_lights, named
    Settings settings;
    std::vector<MaterialOverride> materials; ///< after those that the scene was loaded with
    std::optional<std::uint32_t> outlined;   ///< index of a material whose pixels are outlined in the picture
    std::vector<Aov> aovs;
    bool want_picture = true, want_hdr = false;
    std::optional<PictureSlot> keep_picture; ///< on the device, for show(); the insets too
    Insets insets;                           ///< at most max_insets
    bool keep_buffers = false;               ///< values of the buffers shown, for buffer_value()
    bool want_graph = false;                 ///< a description of the frame's graph
    bool want_statistics = false;            ///< triangles and material changes, read back from the device
    /// Two-phase culling: draw the previous frame's visible triangles first, which is faster while cameras move little.
    /// Which one of several surfaces at equal depth is visible can then depend on the previous frame.
    bool remember = false;
    gpu::TimerMode timers = gpu::TimerMode::overlapped;
};

} // namespace atrium
