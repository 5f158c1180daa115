#include "app/gui/light_handles.hpp"

#include "tests/gui/headless.hpp"

#include <gtest/gtest.h>
#include <imgui/imgui.h>

#include <algorithm>
#include <cmath>

namespace atrium::gui {
namespace {

const vec2 display(800, 600);

Camera looking_north()
{
    return {{0, 0, 5}, {0, 0, 0}, 60};
}

Light light_at(LightType type, const vec3& position)
{
    Light light = default_light(type);
    light.position = position;
    return light;
}

Handle handle_of(const Light& light, const Projection& view, HandleKind kind)
{
    const std::vector<Handle> all = handles_of(light, view, 1);
    const auto found = std::find_if(all.begin(), all.end(), [&](const Handle& h) { return h.kind == kind; });
    if (found == all.end()) throw std::logic_error("the light has no such handle");
    return *found;
}

void expect_near(const vec3& got, const vec3& wanted, float bound = 1e-4f)
{
    EXPECT_LT(glm::distance(got, wanted), bound) << got.x << " " << got.y << " " << got.z;
}

TEST(projection, puts_points_where_the_renderer_draws_them)
{
    const Camera camera{{3, 2, 1}, {-1, 4, -6}, 47};
    const Projection view(camera, display);
    const mat4 clip = clip_from_view(camera.fov, display.x / display.y, 0.1f) * view_from_world(camera);
    for (const vec3& p : {vec3(0, 3, -3), vec3(1, 5, -8), vec3(-2, 4, -5)}) {
        const vec4 c = clip * vec4(p, 1);
        const auto at = view.project(p);
        ASSERT_TRUE(at);
        EXPECT_NEAR(at->x, (0.5f + 0.5f * c.x / c.w) * display.x, 1e-2f);
        EXPECT_NEAR(at->y, (0.5f - 0.5f * c.y / c.w) * display.y, 1e-2f);
        const vec2 moved = *view.project(p + view.in_view_plane(p, {30, -12}));
        EXPECT_LT(glm::distance(moved, *at + vec2(30, -12)), 1e-2f);
    }
    EXPECT_FALSE(view.project({7, 0, 9})); // behind
}

TEST(light_handles, move_a_light_in_the_view_s_plane_and_along_axes)
{
    const Projection view(looking_north(), display);
    const Light light = light_at(LightType::point, {0.5f, 0.5f, 0});
    const float pixel = view.pixel_size(light.position);
    EXPECT_NEAR(pixel, 2 * 5 * std::tan(glm::radians(30.0f)) / 600, 1e-6f);
    const auto moved = [&](HandleKind kind) {
        return dragged(light, handle_of(light, view, kind), view, {40, 20}).position - light.position;
    };
    expect_near(moved(HandleKind::place), {40 * pixel, -20 * pixel, 0});
    expect_near(moved(HandleKind::along_x), {40 * pixel, 0, 0});
    expect_near(moved(HandleKind::along_y), {0, -20 * pixel, 0});
    expect_near(moved(HandleKind::along_z), vec3(0)); // seen end on: a pixel would be any distance
}

TEST(light_handles, aim_open_and_size)
{
    const Projection view(looking_north(), display);
    Light spot = light_at(LightType::spot, {0, 0, 0});
    spot.direction = {0, -2, 0};
    const Handle aim = handle_of(spot, view, HandleKind::aim);
    const vec2 from = *view.project(aim.from), at = *view.project(aim.at);
    // To the right, as far as the tip was below.
    expect_near(dragged(spot, aim, view, from + vec2(at.y - from.y, 0) - at).direction, {1, 0, 0});
    expect_near(dragged(spot, aim, view, vec2(0)).direction, {0, -1, 0});

    const Handle outer = handle_of(spot, view, HandleKind::outer);
    const vec2 ring = *view.project(outer.at);
    const float side = ring.x - from.x, below = ring.y - from.y;
    const float to = below * std::tan(glm::radians(50.0f)) * (side > 0 ? 1.0f : -1.0f);
    EXPECT_NEAR(dragged(spot, outer, view, {to - side, 0}).outer, 50, 1e-2f);
    const Light narrow = dragged(spot, outer, view, {-side, 0});
    EXPECT_LT(narrow.outer, 1);
    EXPECT_LE(narrow.inner, narrow.outer);
    EXPECT_EQ(dragged(spot, handle_of(spot, view, HandleKind::inner), view, {3000, 0}).inner, spot.outer);

    const float pixel = view.pixel_size(spot.position);
    EXPECT_NEAR(dragged(spot, handle_of(spot, view, HandleKind::extent), view, {-30, 0}).size, 0.05f + 30 * pixel,
                1e-4f);
    EXPECT_NEAR(dragged(spot, handle_of(spot, view, HandleKind::extent), view, {3000, 0}).size, 1e-3f, 1e-6f);

    Light rect = light_at(LightType::rect, {0, 0, 0});
    rect.direction = {0, 0, 1};
    const Handle height = handle_of(rect, view, HandleKind::extent_up);
    EXPECT_NEAR(dragged(rect, height, view, {0, -50}).height, 1 + 100 * view.pixel_size(height.at), 1e-3f);

    const Light sun = default_light(LightType::sun);
    const Light turned = dragged(sun, handle_of(sun, view, HandleKind::aim), view, {200, 0});
    EXPECT_GT(turned.direction.x, glm::normalize(sun.direction).x + 0.5f);
    EXPECT_THROW(handle_of(sun, view, HandleKind::place), std::logic_error);
}

struct Scene {
    test::HeadlessGui gui{display.x, display.y};
    ViewModel model;
    LightHandles handles;
    bool touched = false;

    Scene()
    {
        model.reset(Settings(), looking_north(),
                    {light_at(LightType::point, {-1, 0, 0}), light_at(LightType::point, {1, 0, 0})});
        model.selected = 0;
    }
    vec2 place(std::size_t light) const
    {
        return *Projection(model.camera, display).project(model.lights[light].position);
    }
    void mouse(vec2 at, bool held)
    {
        gui.mouse(at.x, at.y, held);
        gui.frame([&] { touched = handles.update(model, 1); }, false);
        if (!handles.holds()) model.checkpoint();
    }
};

TEST(light_handles, are_taken_with_the_mouse_and_let_go)
{
    Scene s;
    const vec2 from = s.place(1), to = from + vec2(60, 30);
    s.mouse(from, false);
    EXPECT_TRUE(s.touched);
    s.mouse(from, true);
    EXPECT_EQ(s.model.selected, 1u);
    EXPECT_TRUE(s.handles.holds());
    s.mouse(from + vec2(20, 5), true);
    s.mouse(to, true);
    EXPECT_LT(glm::distance(s.place(1), to), 0.1f);
    s.mouse(to, false);
    EXPECT_FALSE(s.handles.holds());
    s.mouse(to + vec2(100, 100), false);
    EXPECT_FALSE(s.touched);
    EXPECT_LT(glm::distance(s.place(1), to), 0.1f);
    s.model.undo(); // all of the drag
    EXPECT_LT(glm::distance(s.place(1), from), 0.1f);
}

TEST(light_handles, leave_a_drag_that_began_elsewhere_to_the_view)
{
    Scene s;
    s.mouse({400, 500}, true);
    EXPECT_FALSE(s.touched);
    s.mouse(s.place(1), true);
    EXPECT_FALSE(s.touched);
    s.mouse(s.place(1) + vec2(30, 0), true);
    EXPECT_FALSE(s.handles.holds());
    EXPECT_EQ(s.model.selected, 0u);
    EXPECT_FALSE(s.model.can_undo());
}

TEST(light_handles, survive_a_light_that_is_taken_away)
{
    Scene s;
    s.mouse(s.place(0), false);
    s.mouse(s.place(0), true);
    s.model.remove_selected();
    s.model.remove_selected();
    s.mouse({300, 300}, true);
    EXPECT_FALSE(s.touched);
}

} // namespace
} // namespace atrium::gui
