// Shader functions on the device against their C++ twins.

#include "renderer/core/math.hpp"
#include "renderer/gpu/pipelines.hpp"
#include "renderer/graph/runner.hpp"
#include "renderer/scene/vertex_packing.hpp"
#include "tests/gpu/brdf_twin.hpp"
#include "tests/rig/device_rig.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <random>
#include <vector>

namespace atrium {
namespace {

struct Case {
    vec3 direction;
    float roughness;
    vec3 color;
    float metallic;
    float n_v, n_l, v_l;
    float specular;
};
struct Result {
    vec3 normal16;
    std::uint32_t packed16;
    vec3 normal12;
    std::uint32_t packed_color;
    vec3 color;
    float specular;
    vec3 brdf;
    std::uint32_t packed_specular;
    vec3 aces;
    float unused;
};

std::vector<Result> run_on_device(const std::vector<Case>& cases)
{
    rig::DeviceRig& d = rig::device();
    gpu::Buffer in(d.device, "cases", cases.size() * sizeof(Case), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT,
                   gpu::MemoryUse::upload);
    std::memcpy(in.mapped().data(), cases.data(), cases.size() * sizeof(Case));
    in.flush();
    const std::uint64_t bytes = cases.size() * sizeof(Result);
    gpu::Buffer back(d.device, "results", bytes, VK_BUFFER_USAGE_TRANSFER_DST_BIT, gpu::MemoryUse::readback);

    graph::Graph g;
    const graph::Buf source = g.import("cases", in), results = g.buffer("results", bytes),
                     target = g.import("back", back);
    g.keep(target, gpu::Access::host_read);
    g.compute("functions")
        .reads(source)
        .writes(results)
        .pipeline(gpu::ComputePipelineDesc{"gpu/functions.comp", {}})
        .record([&](graph::Cmd& cmd) {
            cmd.bind();
            cmd.dispatch(static_cast<std::uint32_t>(cases.size()), 64);
        });
    g.transfer("read back").reads(results).writes(target).record([=](graph::Cmd& cmd) {
        cmd.copy(results, target, bytes);
    });
    static_cast<void>(d.runner.run(g));
    back.invalidate();
    std::vector<Result> out(cases.size());
    std::memcpy(out.data(), back.mapped().data(), bytes);
    return out;
}

/// 4096 random cases; directions cover the sphere and its axes.
const std::vector<Case>& all_cases()
{
    static const std::vector<Case> cases = [] {
        std::mt19937 random(7);
        std::uniform_real_distribution<float> unit(0, 1), symmetric(-1, 1);
        std::vector<Case> out;
        for (int i = 0; i < 4096; ++i) {
            Case c{};
            vec3 n(symmetric(random), symmetric(random), symmetric(random));
            if (i < 6) n = vec3(i / 2 == 0, i / 2 == 1, i / 2 == 2) * (i % 2 ? -1.0f : 1.0f);
            c.direction = glm::normalize(n + vec3(1e-12f));
            c.roughness = unit(random);
            c.color = vec3(unit(random), unit(random), unit(random)) * std::exp2(20 * unit(random) - 10);
            if (i >= 2048) c.color = vec3(unit(random), unit(random), unit(random));
            c.metallic = unit(random);
            c.specular = 0.25f * unit(random);
            // Cosines of real directions, so that |v + l| and the angles fit together.
            const float theta_v = 1.5f * unit(random), theta_l = 1.5f * unit(random), phi = pi * unit(random);
            c.n_v = std::cos(theta_v);
            c.n_l = std::cos(theta_l);
            c.v_l = c.n_v * c.n_l + std::sin(theta_v) * std::sin(theta_l) * std::cos(phi);
            out.push_back(c);
        }
        return out;
    }();
    return cases;
}

const std::vector<Result>& results()
{
    static const std::vector<Result> r = run_on_device(all_cases());
    return r;
}

double angle_between(const vec3& a, const vec3& b)
{
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

TEST(shader_functions, octahedral_normals_match_the_converter_and_come_back)
{
    for (std::size_t i = 0; i < all_cases().size(); ++i) {
        const vec3 n = all_cases()[i].direction;
        const std::uint32_t twin = pack_normal(n), packed = results()[i].packed16;
        // Rounding at the edge of a step may fall either way between two float implementations.
        EXPECT_LE(std::abs(int(twin & 0xffff) - int(packed & 0xffff)), 1) << i;
        EXPECT_LE(std::abs(int(twin >> 16) - int(packed >> 16)), 1) << i;
        EXPECT_LT(angle_between(n, results()[i].normal16), 1e-4) << i; // 16 bits: 0.003 degrees
        EXPECT_LT(angle_between(n, results()[i].normal12), 1e-3) << i; // 12 bits: 0.04 degrees
        EXPECT_NEAR(glm::length(results()[i].normal16), 1.0f, 1e-5f) << i;
        if (i < 6) {
            EXPECT_EQ(glm::round(n), results()[i].normal12) << i; // along an axis
        }
    }
}

TEST(shader_functions, shared_exponent_colours_keep_nine_bits)
{
    for (std::size_t i = 0; i < all_cases().size(); ++i) {
        const vec3 c = all_cases()[i].color, r = results()[i].color;
        const float top = std::max({c.x, c.y, c.z});
        for (int k = 0; k < 3; ++k) EXPECT_NEAR(r[k], c[k], top / 500) << i; // half a step of 1/256 to 1/512 of the top
    }
}

TEST(shader_functions, specular_survives_eight_bits_and_the_default_is_exact)
{
    for (std::size_t i = 0; i < all_cases().size(); ++i)
        EXPECT_NEAR(results()[i].specular, all_cases()[i].specular, 0.001f) << i;
    EXPECT_EQ(std::lround(2 * std::sqrt(0.04) * 255), 102);
    EXPECT_FLOAT_EQ(0.25f * (102 / 255.0f) * (102 / 255.0f), 0.04f);
}

TEST(shader_functions, brdf_matches_its_twin)
{
    for (std::size_t i = 0; i < all_cases().size(); ++i) {
        const Case& c = all_cases()[i];
        const glm::dvec3 twin =
            brdf_twin(glm::dvec3(c.color), c.metallic, c.roughness, c.specular, c.n_v, c.n_l, c.v_l);
        for (int k = 0; k < 3; ++k) EXPECT_NEAR(results()[i].brdf[k], twin[k], 2e-3 * std::abs(twin[k]) + 1e-5) << i;
    }
}

TEST(shader_functions, aces_matches_known_values)
{
    // Hill's fit; the values are those of the reference implementation for grey 0.18, 1 and 16.
    const std::vector<std::pair<vec3, vec3>> known{{vec3(0.18f), vec3(0.10559f)},
                                                   {vec3(1), vec3(0.61912f)},
                                                   {vec3(16), vec3(0.98994f)},
                                                   {vec3(0.5f, 0.2f, 0.1f), vec3(0.36523f, 0.12881f, 0.05364f)}};
    std::vector<Case> cases;
    for (const auto& [in, out] : known) cases.push_back({vec3(0, 0, 1), 0.5f, in, 0, 0.5f, 0.5f, 0.5f, 0.04f});
    const std::vector<Result> got = run_on_device(cases);
    for (std::size_t i = 0; i < known.size(); ++i) {
        for (int k = 0; k < 3; ++k) EXPECT_NEAR(got[i].aces[k], known[i].second[k], 1e-4f) << i;
    }
}

} // namespace
} // namespace atrium
