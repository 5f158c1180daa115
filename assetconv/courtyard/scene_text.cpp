#include "assetconv/courtyard/scene_text.hpp"

#include "assetconv/courtyard/lanterns.hpp"

#include <fmt/format.h>

#include <array>

namespace atrium::courtyard {
namespace {

struct View {
    const char* name;
    vec3 eye, target;
    float fov;
};

constexpr std::array<View, 6> views{{
    {"hero", {-7.9f, 1.75f, 1.55f}, {3.4f, 3.75f, -1.3f}, 66},
    {"fountain", {-4.3f, 1.6f, 0.5f}, {0.6f, 1.3f, -0.45f}, 55},
    {"aisle", {-10.6f, 1.95f, -5.35f}, {2.5f, 2.35f, -5.1f}, 62},
    {"gallery", {-7.7f, 7.2f, 5.4f}, {4.2f, 5.2f, -3.6f}, 64},
    {"relief", {8.0f, 2.0f, 0.9f}, {11.8f, 2.15f, -0.1f}, 58},
    {"above", {-11.0f, 16.5f, 7.5f}, {1.2f, 2.5f, -0.9f}, 56},
}};

std::string vector(const vec3& v)
{
    return fmt::format("[{:.3f}, {:.3f}, {:.3f}]", v.x, v.y, v.z);
}

} // namespace

std::string scene_text()
{
    std::string text = "# The courtyard. Bake courtyard.obj first: assetconv bake courtyard.obj\n"
                       "bake = \"courtyard.atrium\"\n\n[settings]\n"
                       "exposure.ev100 = 0.0\ntonemap.operator = \"aces\"\n";
    for (const View& v : views) {
        text += fmt::format("\n[camera.{}]\neye = {}\ntarget = {}\nfov = {:.1f}\n", v.name, vector(v.eye),
                            vector(v.target), v.fov);
    }
    text += "\n[[light]]\ntype = \"sun\"\nname = \"sun\"\ndirection = [0.52, -1.0, -0.42]\n"
            "color = [1.0, 0.9, 0.76]\nilluminance = 6.5\n";
    for (const Lantern& lantern : lanterns()) {
        if (!lantern.light) {
            continue;
        }
        text += fmt::format("\n[[light]]\ntype = \"point\"\nname = \"lantern_{}_{}\"\nposition = {}\n"
                            "color = [1.0, 0.62, 0.28]\nintensity = 6.0\nsize = 0.1\nrange = 9.0\n"
                            "shadow = false # it stands within glass that would hide it\n",
                            sides()[static_cast<std::size_t>(lantern.side)].name, lantern.bay,
                            vector(lantern_position(lantern)));
    }
    return text;
}

} // namespace atrium::courtyard
