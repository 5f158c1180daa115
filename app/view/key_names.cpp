#include "app/view/key_names.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <utility>

namespace atrium::app {
namespace {

using NamedKey = std::pair<std::string, int>;

const std::vector<NamedKey>& named_keys()
{
    static const std::vector<NamedKey> table = [] {
        std::vector<NamedKey> keys{
            {"Space", GLFW_KEY_SPACE},
            {"Escape", GLFW_KEY_ESCAPE},
            {"Enter", GLFW_KEY_ENTER},
            {"Tab", GLFW_KEY_TAB},
            {"Insert", GLFW_KEY_INSERT},
            {"Delete", GLFW_KEY_DELETE},
            {"Backspace", GLFW_KEY_BACKSPACE},
            {"Home", GLFW_KEY_HOME},
            {"End", GLFW_KEY_END},
            {"Page down", GLFW_KEY_PAGE_DOWN},
            {"Left", GLFW_KEY_LEFT},
            {"Right", GLFW_KEY_RIGHT},
            {"Page up", GLFW_KEY_PAGE_UP},
            {"Up", GLFW_KEY_UP},
            {"Down", GLFW_KEY_DOWN},
        };
        // GLFW numbers these as ASCII does.
        for (const char c : std::string_view("ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789',-./;=[\\]`"))
            keys.emplace_back(std::string(1, c), c);
        for (int i = 1; i <= 12; ++i) keys.emplace_back(fmt::format("F{}", i), GLFW_KEY_F1 + i - 1);
        return keys;
    }();
    return table;
}

bool same_word(std::string_view a, std::string_view b)
{
    const auto same = [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); };
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), same);
}

constexpr std::pair<std::string_view, int> modifiers[]{{"Ctrl+", GLFW_MOD_CONTROL}, {"Alt+", GLFW_MOD_ALT}};

} // namespace

std::string name_of(const KeyPress& key)
{
    std::string out;
    for (const auto& [name, mod] : modifiers) {
        if ((key.mods & mod) != 0) out += name;
    }
    const std::vector<NamedKey>& keys = named_keys();
    const auto found = std::find_if(keys.begin(), keys.end(), [&](const NamedKey& k) { return k.second == key.key; });
    return found == keys.end() ? "" : out + found->first;
}

std::optional<KeyPress> parse_key(std::string_view name)
{
    KeyPress key;
    for (const auto& [word, mod] : modifiers) {
        if (!same_word(name.substr(0, word.size()), word)) continue;
        key.mods |= mod;
        name.remove_prefix(word.size());
    }
    for (const auto& [known, code] : named_keys()) {
        if (!same_word(name, known)) continue;
        key.key = code;
        return key;
    }
    return std::nullopt;
}

std::vector<std::string> key_names()
{
    std::vector<std::string> names;
    for (const auto& [name, code] : named_keys()) names.push_back(name);
    return names;
}

} // namespace atrium::app
