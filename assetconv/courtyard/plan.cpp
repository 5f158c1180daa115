#include "assetconv/courtyard/plan.hpp"

namespace atrium::courtyard {
namespace {

Side make_side(const char* name, int bays, vec3 towards_court, float distance)
{
    Side side{name, bays, 0.5f * bay * static_cast<float>(bays), mat4(1)};
    const vec3 up(0, 1, 0);
    const vec3 along = glm::cross(up, towards_court);
    side.frame[0] = vec4(along, 0);
    side.frame[1] = vec4(up, 0);
    side.frame[2] = vec4(towards_court, 0);
    side.frame[3] = vec4(-towards_court * distance, 1);
    return side;
}

} // namespace

const std::array<Side, 4>& sides()
{
    static const std::array<Side, 4> all{
        make_side("north", long_bays, {0, 0, 1}, half_width), make_side("east", short_bays, {-1, 0, 0}, half_length),
        make_side("south", long_bays, {0, 0, -1}, half_width), make_side("west", short_bays, {1, 0, 0}, half_length)};
    return all;
}

} // namespace atrium::courtyard
