#pragma once
// A camera that is flown: keys and mouse become a Camera.

#include "renderer/core/math.hpp"
#include "renderer/scene/camera.hpp"

#include <optional>

namespace atrium::gui {

/// What was held and moved during one step.
struct FlyInput {
    vec3 move{0};      ///< right (level), up (+Y), forward (along the view), -1 to 1 each
    vec2 turn{0};      ///< radians during the step: to the right, upwards
    bool fast = false; ///< four times the speed
    float wheel = 0;   ///< notches: eight of them double the speed
};

/// Moves at a constant speed and turns at a constant rate during each step, and the path between is integrated in
/// closed form: the same input in one step or in a hundred leads to the same place. The distance from eye to target
/// stays, the horizon stays level, the view stays within 89 degrees of it once it is turned.
class FlyCamera {
public:
    /// The speed crosses `scene_diagonal` (m) in 20 s.
    explicit FlyCamera(float scene_diagonal = 20.0f);

    double speed; ///< m/s

    /// Whether the camera moved or turned. Of a camera that was changed elsewhere since, it goes on from there.
    bool advance(Camera& camera, const FlyInput& input, double seconds);

private:
    struct Pose { // in doubles: thousands of small steps add up
        glm::dvec3 eye{0};
        double yaw = 0, pitch = 0; ///< radians; yaw from -Z towards +X
        double distance = 1;
    };
    [[nodiscard]] static Pose pose_of(const Camera& camera);
    static void travel(Pose& pose, const glm::dvec3& way, const glm::dvec2& turn);

    struct Followed {
        Pose pose;
        vec3 eye, target; ///< as they were written to the camera
    };
    std::optional<Followed> followed_;
};

} // namespace atrium::gui
