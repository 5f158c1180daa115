#include "app/toml_text.hpp"

#include <fmt/format.h>

namespace atrium::app {

std::string toml_string(std::string_view text)
{
    std::string out = "\"";
    for (const char c : text) {
        const auto code = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\') out += '\\';
        if (code < 0x20 || code == 0x7f)
            out += fmt::format("\\u{:04x}", code);
        else
            out += c;
    }
    return out + "\"";
}

std::string toml_vector(const vec3& v)
{
    return fmt::format("[{}, {}, {}]", v.x, v.y, v.z);
}

std::string toml_camera(const Camera& camera)
{
    return fmt::format("eye = {}\ntarget = {}\nfov = {}\n", toml_vector(camera.eye), toml_vector(camera.target),
                       camera.fov);
}

std::string differing_toml(const SettingList& list)
{
    std::string out = "[settings]\n";
    for (const auto& [key, text] : list.differing()) out += fmt::format("{} = {}\n", key, toml_string(text));
    return out;
}

} // namespace atrium::app
