// The courtyard's mesh: sound triangles, within its budget, of the materials it promises, and nothing that fights in
// depth.
#include "assetconv/courtyard/court.hpp"
#include "assetconv/courtyard/materials.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <string>

namespace atrium::courtyard {
namespace {

using Detail = CourtyardOptions::Detail;

Court make(Detail detail, std::uint32_t seed = 1)
{
    Court court;
    court.fine = fineness(detail);
    court.seed = seed;
    build_all(court);
    return court;
}

const Court& medium()
{
    static const Court court = make(Detail::medium);
    return court;
}

struct Triangle {
    std::array<Corner, 3> corner;
    vec3 across; ///< twice the area, along the winding's normal
};

template <typename F>
void for_triangles(const Part& part, F body)
{
    for (std::size_t i = 0; i + 2 < part.indices.size(); i += 3) {
        Triangle t{
            {part.corners[part.indices[i]], part.corners[part.indices[i + 1]], part.corners[part.indices[i + 2]]}, {}};
        t.across = glm::cross(t.corner[1].position - t.corner[0].position, t.corner[2].position - t.corner[0].position);
        body(t);
    }
}

TEST(courtyard, has_as_many_triangles_as_its_detail_promises)
{
    EXPECT_GE(medium().model.triangle_count(), 50'000u);
    EXPECT_LE(medium().model.triangle_count(), 150'000u);
    const std::size_t low = make(Detail::low).model.triangle_count(), high = make(Detail::high).model.triangle_count();
    EXPECT_GE(low, 10'000u);
    EXPECT_LE(low, 26'000u);
    EXPECT_GE(high, 300'000u);
    EXPECT_LE(high, 450'000u);
}

TEST(courtyard, is_sound_at_every_detail)
{
    for (const Detail detail : {Detail::low, Detail::medium, Detail::high}) {
        const Court court = make(detail);
        ASSERT_GT(court.model.parts().size(), 20u);
        for (const Part& part : court.model.parts()) {
            SCOPED_TRACE(part.group + " / " + part.material);
            ASSERT_FALSE(part.indices.empty());
            ASSERT_EQ(part.indices.size() % 3, 0u);
            ASSERT_LT(*std::max_element(part.indices.begin(), part.indices.end()), part.corners.size());
            for (const Corner& c : part.corners) {
                ASSERT_NEAR(glm::length(c.normal), 1.0f, 1e-4f);
                ASSERT_TRUE(std::isfinite(c.position.x + c.position.y + c.position.z + c.uv.x + c.uv.y));
            }
            std::size_t count = 0, agree = 0;
            for_triangles(part, [&](const Triangle& t) {
                ++count;
                ASSERT_GT(glm::length(t.across), 1e-7f);
                const float size = glm::length(t.across);
                agree += std::all_of(t.corner.begin(), t.corner.end(), [&](const Corner& c) {
                    return glm::dot(t.across, c.normal) >
                           -0.35f * size; // coarse folds of cloth turn far in one triangle
                });
            });
            EXPECT_GE(static_cast<double>(agree), 0.995 * static_cast<double>(count));
        }
    }
}

TEST(courtyard, has_texture_coordinates_that_span_an_area)
{
    ASSERT_GT(medium().model.parts().size(), 20u);
    for (const Part& part : medium().model.parts()) {
        std::size_t count = 0, flat = 0;
        for_triangles(part, [&](const Triangle& t) {
            const vec2 a = t.corner[1].uv - t.corner[0].uv, b = t.corner[2].uv - t.corner[0].uv;
            ++count;
            flat += std::abs(a.x * b.y - a.y * b.x) < 1e-9f;
        });
        EXPECT_LE(flat * 50, count) << part.group << " / " << part.material; // no tangents where flat: at most 2 %
    }
}

TEST(courtyard, uses_every_material_and_no_other)
{
    std::set<std::string> used;
    for (const Part& part : medium().model.parts()) {
        used.insert(part.material);
    }
    EXPECT_GE(used.size(), 12u);
    std::set<std::string> known;
    for (const MaterialInfo& m : materials()) {
        known.insert(m.name);
    }
    EXPECT_EQ(used, known);
}

TEST(courtyard, keeps_its_plan_whatever_the_seed)
{
    const auto architecture = [](const Court& court) {
        std::map<std::string, std::size_t> sizes;
        for (const Part& part : court.model.parts()) {
            const bool grown = part.material == "leaf" || part.material == "frond" || part.material == "bark";
            if (!grown) {
                sizes[part.group + part.material] = part.corners.size();
            }
        }
        return sizes;
    };
    const Court other = make(Detail::medium, 2);
    EXPECT_EQ(architecture(medium()), architecture(other));
    std::size_t different = 0;
    for (std::size_t i = 0; i < std::min(other.model.parts().size(), medium().model.parts().size()); ++i) {
        const Part &a = medium().model.parts()[i], &b = other.model.parts()[i];
        different += a.corners.size() != b.corners.size() || a.corners.front().position != b.corners.front().position ||
                     a.corners.front().uv != b.corners.front().uv;
    }
    EXPECT_GT(different, 30u); // plants, and which piece of stone each slab is
}

// ---- surfaces that share a plane ----

struct Flat {
    std::array<vec3, 3> p;
    vec3 normal;
    std::uint32_t group;
};

/// Whether two triangles of one plane overlap by more than `margin` metres: no edge of either separates them.
bool overlap(const Flat& a, const Flat& b, float margin)
{
    for (const Flat* f : {&a, &b}) {
        for (std::size_t i = 0; i < 3; ++i) {
            const vec3 edge = f->p[(i + 1) % 3] - f->p[i];
            const vec3 out = glm::normalize(glm::cross(edge, f->normal));
            float most_a = -1e9f, least_a = 1e9f, most_b = -1e9f, least_b = 1e9f;
            for (std::size_t k = 0; k < 3; ++k) {
                most_a = std::max(most_a, glm::dot(out, a.p[k]));
                least_a = std::min(least_a, glm::dot(out, a.p[k]));
                most_b = std::max(most_b, glm::dot(out, b.p[k]));
                least_b = std::min(least_b, glm::dot(out, b.p[k]));
            }
            if (most_a < least_b + margin || most_b < least_a + margin) {
                return false;
            }
        }
    }
    return true;
}

bool same_plane(const Flat& a, const Flat& b)
{
    if (std::abs(glm::dot(a.normal, b.normal)) < 0.99995f) {
        return false;
    }
    return std::all_of(b.p.begin(), b.p.end(),
                       [&](const vec3& q) { return std::abs(glm::dot(a.normal, q - a.p[0])) < 3e-4f; });
}

TEST(courtyard, has_no_surfaces_of_two_groups_in_one_plane)
{
    // All triangles larger than 10 cm2, in half-metre cells; every pair of different groups in a cell.
    std::vector<Flat> flats;
    std::vector<std::string> groups;
    for (const Part& part : medium().model.parts()) {
        groups.push_back(part.group);
        for_triangles(part, [&](const Triangle& t) {
            const float twice = glm::length(t.across);
            if (twice < 2e-3f) {
                return;
            }
            flats.push_back({{t.corner[0].position, t.corner[1].position, t.corner[2].position},
                             t.across / twice,
                             static_cast<std::uint32_t>(groups.size() - 1)});
        });
    }
    std::map<std::array<int, 3>, std::vector<std::size_t>> cells;
    for (std::size_t i = 0; i < flats.size(); ++i) {
        Bounds box;
        for (const vec3& p : flats[i].p) {
            box.add(p);
        }
        const ivec2 x(glm::floor(vec2(box.min.x, box.max.x) * 2.0f)), y(glm::floor(vec2(box.min.y, box.max.y) * 2.0f)),
            z(glm::floor(vec2(box.min.z, box.max.z) * 2.0f));
        for (int a = x[0]; a <= x[1]; ++a) {
            for (int b = y[0]; b <= y[1]; ++b) {
                for (int c = z[0]; c <= z[1]; ++c) {
                    cells[{a, b, c}].push_back(i);
                }
            }
        }
    }
    std::map<std::string, int> fights;
    std::size_t compared = 0; // pairs of different groups in one plane, which must not overlap
    for (const auto& [cell, members] : cells) {
        for (std::size_t i = 0; i < members.size(); ++i) {
            for (std::size_t j = i + 1; j < members.size(); ++j) {
                const Flat &a = flats[members[i]], &b = flats[members[j]];
                if (groups[a.group] == groups[b.group] || !same_plane(a, b)) {
                    continue;
                }
                ++compared;
                if (!overlap(a, b, 2e-3f)) {
                    continue;
                }
                ++fights[groups[a.group] + " and " + groups[b.group]];
            }
        }
    }
    for (const auto& [who, count] : fights) {
        ADD_FAILURE() << who << ": " << count << " pairs";
    }
    EXPECT_GT(compared, 100u);
}

} // namespace
} // namespace atrium::courtyard
