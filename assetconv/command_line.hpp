#pragma once
// Help for CLI11: its errors as ours, and values out of lists of names.

#include <CLI/CLI.hpp>

#include <span>
#include <string>
#include <utility>
#include <vector>

namespace atrium {

/// The value of `typed` in a list of names. Throws Error(usage) that names the nearest valid one.
template <class Value>
[[nodiscard]] Value choose(const std::string& option, const std::string& typed,
                           const std::vector<std::pair<std::string, Value>>& choices);

/// Throws Error(usage): `typed` is not among `names`; tells the nearest and all of them.
[[noreturn]] void refuse_choice(const std::string& option, const std::string& typed,
                                const std::vector<std::string>& names);

/// Throws Error(usage) for arguments that no option of the command took: unknown options name the nearest one.
void refuse_extras(const CLI::App& command, const std::string& program);

/// Throws Error(usage) when the value is not within [low, high].
void check_range(const std::string& option, double value, double low, double high);

template <class Value>
Value choose(const std::string& option, const std::string& typed,
             const std::vector<std::pair<std::string, Value>>& choices)
{
    std::vector<std::string> names;
    for (const auto& [name, value] : choices) {
        if (name == typed) return value;
        names.push_back(name);
    }
    refuse_choice(option, typed, names);
}

} // namespace atrium
