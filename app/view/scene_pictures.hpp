#pragma once
// The pictures of the scene that the window shows: one, or two beside each other.

#include "app/gui/panels.hpp"
#include "app/gui/view_model.hpp"
#include "renderer/engine.hpp"

#include <array>
#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace atrium::app {

/// At which size to draw while something moves, so that it stays fluent. Time goes with the number of pixels, beyond a
/// part that does not.
class MovingScale {
public:
    /// A frame of `share` of the window along each side took so long.
    void measured(float share, double ms);
    /// 0.2 to 1, in steps coarse enough not to make new images for every frame.
    [[nodiscard]] float choose(double goal_ms) const;

private:
    double full_ms_ = 0;
};

/// Draws what the model says where that is not what stands, smaller while it moves, and tells what it took.
class ScenePictures {
public:
    ScenePictures(Engine& engine, gui::ViewModel& model, gui::FrameFacts& facts)
        : engine_(engine), model_(model), facts_(facts)
    {}

    /// With another scene. What the model does not say of frames is as in `like`.
    void begin(const FrameRequest& like);
    /// They are out of date, whatever they show.
    void invalidate();
    /// Whether what stands is not yet drawn at full size.
    [[nodiscard]] bool unfinished() const;

    struct Look {
        uvec2 pixels{0};                       ///< of the window
        float scale = 1;                       ///< of the interface, which insets lie in
        bool insets = false;                   ///< the pinned buffers too
        std::optional<std::uint32_t> outlined; ///< material with a line around it
        bool moving = false;                   ///< something changes with each frame
        bool always = false;                   ///< draw also what stands
    };
    /// At both sides of a split view. What cannot be drawn leaves the picture of before, and the answer says why.
    /// Throws Error where there was none.
    [[nodiscard]] std::optional<std::string> draw(const Look& look);

    /// A request for the scene as it is now, to be read back, which leaves what stands as it is.
    [[nodiscard]] FrameRequest wanted_picture(uvec2 size) const;

private:
    /// What a picture was drawn from.
    struct Source {
        Settings settings;
        Camera camera;
        std::vector<Light> lights;
        std::vector<MaterialOverride> materials;
        std::vector<gui::PinnedBuffer> insets;
        std::optional<std::uint32_t> outlined;
        uvec2 pixels{0}; ///< of the window
        float scale = 1; ///< of the interface
    };
    struct Kept {
        std::optional<Source> source; ///< none: there is no picture yet
        float share = 0;              ///< of the window's pixels along each side
        std::uint64_t frames = 0;     ///< drawn so far
    };
    [[nodiscard]] FrameRequest wanted_frame(const Settings& settings, uvec2 size) const;
    [[nodiscard]] Insets wanted_insets(const Look& look) const;
    [[nodiscard]] Source source_now(const Settings& settings, const Look& look) const;
    /// Whether a picture drawn now would have the same source. Called in every frame, so it compares without copies.
    [[nodiscard]] bool is_still(const Source& source, const Settings& settings, const Look& look) const;
    /// `before`: the camera of what stands.
    [[nodiscard]] std::optional<std::string> draw_side(PictureSlot slot, const Look& look, const Camera& before);
    void tell(FrameResult frame, const FrameRequest& request);

    Engine& engine_;
    gui::ViewModel& model_;
    gui::FrameFacts& facts_;
    FrameRequest like_;
    Camera shown_camera_;
    MovingScale moving_scale_;
    std::array<Kept, 2> kept_; ///< by PictureSlot
    std::chrono::steady_clock::time_point started_ = std::chrono::steady_clock::now();
};

} // namespace atrium::app
