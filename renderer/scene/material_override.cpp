#include "renderer/scene/material_override.hpp"

#include <algorithm>

namespace atrium {

std::array<const char*, material_class_count> enum_names(MaterialClass)
{
    std::array<const char*, material_class_count> names{};
    for (int i = 0; i < material_class_count; ++i)
        names[static_cast<std::size_t>(i)] = to_string(static_cast<MaterialClass>(i));
    return names;
}

bool matches_pattern(std::string_view pattern, std::string_view name)
{
    // On a mismatch, the last star takes one character more: linear in memory, at worst the product in time.
    std::size_t p = 0, n = 0, star = std::string_view::npos, star_n = 0;
    while (n < name.size()) {
        if (p < pattern.size() && pattern[p] == '*') {
            star = p++;
            star_n = n;
        } else if (p < pattern.size() && (pattern[p] == '?' || pattern[p] == name[n])) {
            ++p;
            ++n;
        } else if (star != std::string_view::npos) {
            p = star + 1;
            n = ++star_n;
        } else {
            return false;
        }
    }
    while (p < pattern.size() && pattern[p] == '*') ++p;
    return p == pattern.size();
}

std::string pattern_of(std::string_view name)
{
    std::string pattern(name);
    std::replace_if(
        pattern.begin(), pattern.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
    return pattern;
}

void apply(const MaterialOverride& o, Material& material)
{
    Material described; // with defaults within their ranges, which a bake's values need not be
    SettingList keys("material key", "");
    describe(keys, described);
    described = material;
    for (const auto& [key, text] : o.values) keys.set(key, text, ExitCode::internal, o.match);
    material = described;
}

Material overridden(Material material, std::span<const MaterialOverride> overrides)
{
    for (const MaterialOverride& o : overrides) {
        if (matches_pattern(o.match, material.name)) apply(o, material);
    }
    return material;
}

MaterialOverride difference(const Material& from, const Material& to)
{
    Material described;
    SettingList keys("material key", "");
    describe(keys, described);
    MaterialOverride o{pattern_of(from.name), {}};
    for (const Setting& key : keys.all()) {
        described = from;
        const std::string before = key.get();
        described = to;
        if (key.get() != before) o.values.emplace_back(key.key, key.get());
    }
    return o;
}

void add_missing(const MaterialOverride& from, MaterialOverride& to)
{
    for (const auto& value : from.values) {
        const bool there =
            std::any_of(to.values.begin(), to.values.end(), [&](const auto& v) { return v.first == value.first; });
        if (!there) to.values.push_back(value);
    }
}

std::vector<MaterialOverride> spelled_out(std::span<const Material> materials,
                                          std::span<const MaterialOverride> overrides)
{
    std::vector<MaterialOverride> out;
    for (const Material& material : materials) {
        MaterialOverride o = difference(material, overridden(material, overrides));
        const auto named =
            std::find_if(out.begin(), out.end(), [&](const auto& other) { return other.match == o.match; });
        if (named != out.end())
            add_missing(o, *named); // another of the same name, which had some of the values already
        else if (!o.values.empty())
            out.push_back(std::move(o));
    }
    return out;
}

} // namespace atrium
