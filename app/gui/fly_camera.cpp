#include "app/gui/fly_camera.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace atrium::gui {
namespace {

using glm::dvec2, glm::dvec3;

constexpr double steepest = 89.0 * std::numbers::pi / 180.0;

double sinc(double x)
{
    return std::abs(x) < 1e-6 ? 1.0 - x * x / 6.0 : std::sin(x) / x;
}

// Means of sin(a + b s) and cos(a + b s) over s from 0 to 1.
double mean_sin(double a, double b)
{
    return std::sin(a + b / 2) * sinc(b / 2);
}
double mean_cos(double a, double b)
{
    return std::cos(a + b / 2) * sinc(b / 2);
}

dvec3 forward_of(double yaw, double pitch)
{
    return {std::cos(pitch) * std::sin(yaw), std::sin(pitch), -std::cos(pitch) * std::cos(yaw)};
}

/// forward_of() over the whole of a turn: products of sine and cosine are sums of both.
dvec3 mean_forward(double yaw, double pitch, const dvec2& turn)
{
    const double sum = yaw + pitch, difference = yaw - pitch;
    const double d_sum = turn.x + turn.y, d_difference = turn.x - turn.y;
    return {0.5 * (mean_sin(sum, d_sum) + mean_sin(difference, d_difference)), mean_sin(pitch, turn.y),
            -0.5 * (mean_cos(sum, d_sum) + mean_cos(difference, d_difference))};
}

} // namespace

FlyCamera::FlyCamera(float scene_diagonal) : speed(std::clamp(static_cast<double>(scene_diagonal) / 20.0, 0.001, 1e5))
{}

FlyCamera::Pose FlyCamera::pose_of(const Camera& camera)
{
    const dvec3 eye(camera.eye), view = dvec3(camera.target) - eye;
    const double distance = glm::length(view);
    if (!(distance > 0.0)) return {eye, 0, 0, 1};
    const double pitch = std::asin(std::clamp(view.y / distance, -1.0, 1.0));
    // Straight down, +Z is up on the screen (camera.hpp), so that is where it heads; straight up, away from it.
    const bool vertical = view.x * view.x + view.z * view.z < 1e-10 * distance * distance;
    const double yaw = vertical ? (view.y < 0.0 ? std::numbers::pi : 0.0) : std::atan2(view.x, -view.z);
    return {eye, yaw, pitch, distance};
}

/// Goes `way` (right, up, forward, m) while turning; both evenly.
void FlyCamera::travel(Pose& pose, const dvec3& way, const dvec2& turn)
{
    const dvec3 right(mean_cos(pose.yaw, turn.x), 0, mean_sin(pose.yaw, turn.x));
    pose.eye += way.x * right + dvec3(0, way.y, 0) + way.z * mean_forward(pose.yaw, pose.pitch, turn);
    pose.yaw = std::remainder(pose.yaw + turn.x, 2.0 * std::numbers::pi);
    pose.pitch += turn.y;
}

bool FlyCamera::advance(Camera& camera, const FlyInput& input, double seconds)
{
    speed = std::clamp(speed * std::exp2(static_cast<double>(input.wheel) / 8.0), 0.001, 1e5);
    const bool moves = input.move != vec3(0) && seconds > 0.0, turns = input.turn != vec2(0);
    if (!moves && !turns) return false;

    const bool follows = followed_ && followed_->eye == camera.eye && followed_->target == camera.target;
    Pose pose = follows ? followed_->pose : pose_of(camera);

    dvec3 way(0);
    if (moves) {
        way = dvec3(input.move) / std::max(1.0, glm::length(dvec3(input.move))); // two keys are no faster than one
        way *= speed * (input.fast ? 4.0 : 1.0) * seconds;
    }
    dvec2 turn(input.turn);
    if (turns) pose.pitch = std::clamp(pose.pitch, -steepest, steepest);
    const double room = (turn.y > 0.0 ? steepest : -steepest) - pose.pitch;
    if (turns && std::abs(turn.y) > std::abs(room)) {
        // Up to where the pitch stops, and on from there.
        const double share = room / turn.y;
        travel(pose, way * share, {turn.x * share, room});
        pose.pitch = std::copysign(steepest, turn.y);
        way *= 1.0 - share;
        turn = {turn.x * (1.0 - share), 0.0};
    }
    travel(pose, way, turn);
    const double edge = std::max(0.0, static_cast<double>(world_range.max) - pose.distance);
    pose.eye = glm::clamp(pose.eye, dvec3(-edge), dvec3(edge));

    const vec3 eye(pose.eye), target(pose.eye + pose.distance * forward_of(pose.yaw, pose.pitch));
    if (eye == target) return false; // so far out that floats do not tell them apart
    const bool changed = eye != camera.eye || target != camera.target;
    camera.eye = eye;
    camera.target = target;
    followed_ = {pose, eye, target};
    return changed;
}

} // namespace atrium::gui
