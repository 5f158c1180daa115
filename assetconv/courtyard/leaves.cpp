#include "assetconv/courtyard/leaves.hpp"

#include <cmath>

namespace atrium::courtyard {

vec3 any_direction(Random& random)
{
    const float y = random.around(0, 1), angle = random.unit() * 2 * pi;
    const float r = std::sqrt(std::max(0.0f, 1 - y * y));
    return {r * std::cos(angle), y, r * std::sin(angle)};
}

void draw_leaf_card(Pen& pen, const LeafCard& card)
{
    vec3 across = glm::cross(card.along, card.facing);
    const float size = glm::length(across);
    across = size > 1e-3f ? across / size : glm::normalize(glm::cross(card.along, vec3(0.3f, 0.2f, 0.93f)));
    vec3 at = card.foot, way = card.along;
    const float step = card.length / static_cast<float>(card.pieces);
    std::uint32_t previous = 0;
    for (int i = 0; i <= card.pieces; ++i) {
        const vec3 up = glm::normalize(glm::cross(across, way));
        vec3 normal = up + card.rounded;
        if (glm::dot(normal, up) < 0.3f) {
            normal = up;
        }
        const float v = 0.5f * (card.cell.y + 0.01f + 0.98f * static_cast<float>(i) / static_cast<float>(card.pieces));
        const float u = 0.5f * (card.cell.x + 0.01f), du = 0.49f;
        const std::uint32_t id = pen.add(at - 0.5f * card.width * across, normal, {u, v});
        pen.add(at + 0.5f * card.width * across, normal, {u + du, v});
        if (i > 0) {
            pen.strip(previous, id, 2);
        }
        previous = id;
        at += step * way;
        const float bend =
            card.droop / static_cast<float>(card.pieces); // turn towards the ground about the card's width
        way = glm::normalize(way * std::cos(bend) - up * std::sin(bend));
    }
}

} // namespace atrium::courtyard
