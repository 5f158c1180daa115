#include "app/toml_text.hpp"

#include <fmt/format.h>

#include <cmath>

namespace atrium::app {
namespace {

template <class T>
std::string number_text(T value)
{
    constexpr T safe_integer = 9007199254740992; // 2^53: what TOML's integers and floats both hold
    std::string text = fmt::format("{}", value);
    const bool is_integer = text.find_first_of(".e") == std::string::npos && std::isfinite(value);
    if (is_integer && (std::abs(value) > safe_integer || (value == 0 && std::signbit(value)))) text += ".0";
    return text;
}

} // namespace

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

std::string toml_number(float value)
{
    return number_text(value);
}

std::string toml_number(double value)
{
    return number_text(value);
}

std::string toml_vector(const vec3& v)
{
    return fmt::format("[{}, {}, {}]", toml_number(v.x), toml_number(v.y), toml_number(v.z));
}

std::string toml_value(const Setting& setting)
{
    if (const auto* field = std::get_if<bool*>(&setting.field)) return **field ? "true" : "false";
    if (const auto* field = std::get_if<vec3*>(&setting.field)) return toml_vector(**field);
    if (const auto* field = std::get_if<float*>(&setting.field)) return toml_number(**field);
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
