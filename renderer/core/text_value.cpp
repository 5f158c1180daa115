#include "renderer/core/text_value.hpp"

#include <charconv>
#include <cmath>

#include <fmt/format.h>

namespace atrium {
namespace {

template <class T>
std::optional<T> parse_number(std::string_view text)
{
    // from_chars knows no plus sign, and must not be given "+-1" as "-1".
    if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
    T value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return value;
}

} // namespace

std::optional<bool> parse_bool(std::string_view text)
{
    if (text == "on" || text == "true") return true;
    if (text == "off" || text == "false") return false;
    return std::nullopt;
}

std::optional<int> parse_int(std::string_view text)
{
    return parse_number<int>(text);
}

std::optional<float> parse_float(std::string_view text)
{
    const auto value = parse_number<float>(text);
    return value && std::isfinite(*value) ? value : std::nullopt;
}

std::optional<vec3> parse_vec3(std::string_view text)
{
    vec3 value(0);
    for (int i = 0; i < 3; ++i) {
        const std::size_t colon = i < 2 ? text.find(':') : text.size();
        if (colon == std::string_view::npos) return std::nullopt;
        const auto component = parse_float(text.substr(0, colon));
        if (!component) return std::nullopt;
        value[i] = *component;
        if (i < 2) text.remove_prefix(colon + 1);
    }
    return value;
}

std::string to_text(bool value)
{
    return value ? "on" : "off";
}

std::string to_text(int value)
{
    return fmt::format("{}", value);
}

std::string to_text(float value)
{
    return fmt::format("{}", value);
}

std::string to_text(const vec3& value)
{
    return fmt::format("{}:{}:{}", value.x, value.y, value.z);
}

} // namespace atrium
