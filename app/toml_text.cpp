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

std::string toml_value(const Setting& setting)
{
    if (const auto* field = std::get_if<bool*>(&setting.field)) return **field ? "true" : "false";
    if (const auto* field = std::get_if<vec3*>(&setting.field)) return toml_vector(**field);
    if (std::holds_alternative<float*>(setting.field)) return setting.get();
    return toml_string(setting.get());
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

std::string materials_toml(const std::vector<MaterialOverride>& materials)
{
    Material described;
    SettingList keys("material key", "");
    describe(keys, described);
    std::string out;
    for (const MaterialOverride& o : materials) {
        out += fmt::format("\n[[material]]\nmatch = {}\n", toml_string(o.match));
        for (const auto& [key, text] : o.values) {
            keys.set(key, text, ExitCode::internal, o.match);
            out += fmt::format("{} = {}\n", key, toml_value(*keys.find(key)));
        }
    }
    return out;
}

} // namespace atrium::app
