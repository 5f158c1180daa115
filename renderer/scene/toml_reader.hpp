#pragma once
// TOML with the manners of Atrium: every unknown key, wrong type and bad value is an Error(input) that tells file:line.
// For scene_file.cpp and the like; no other header includes it.

#include "renderer/core/setting.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <toml++/toml.h>

namespace atrium {

/// Parses a file of at most 4 MiB. Throws Error(input).
[[nodiscard]] toml::table parse_toml(const std::filesystem::path& file);
/// The same from memory; `file` names it in messages.
[[nodiscard]] toml::table parse_toml_text(std::string_view text, const std::filesystem::path& file);

/// "file:line".
[[nodiscard]] std::string where_in(const std::filesystem::path& file, const toml::source_region& source);

/// "a string", "a table", …: what an error says that it found.
[[nodiscard]] const char* kind_of(const toml::node& node);

struct TomlEntry {
    std::string key;
    const toml::node* node;
    toml::source_region source; ///< of the key
};
/// A table's entries in the order of the file (toml++ sorts them by name).
[[nodiscard]] std::vector<TomlEntry> in_file_order(const toml::table& table);
/// The same with the entries of tables in it, whose keys have dots, in place of the tables.
[[nodiscard]] std::vector<TomlEntry> dotted_entries(const toml::table& table);

/// One table of which every key is known.
class TomlReader {
public:
    /// `what` names the table in messages: camera "nave". Throws for a key that is not among `keys`.
    TomlReader(const std::filesystem::path& file, const toml::table& table, std::string what,
               std::vector<std::string> keys);

    [[nodiscard]] bool has(std::string_view key) const { return table_.contains(key); }
    [[nodiscard]] const toml::table& table() const { return table_; }
    [[nodiscard]] const std::filesystem::path& file() const { return file_; }
    [[nodiscard]] std::string where() const; ///< of the table
    [[nodiscard]] std::string where(std::string_view key) const;

    // Empty when the key is not there; wrong types and ranges throw.
    [[nodiscard]] std::optional<std::string> text(std::string_view key) const;
    [[nodiscard]] std::optional<float> number(std::string_view key, Range range) const;
    [[nodiscard]] std::optional<double> real(std::string_view key) const; ///< any finite value
    [[nodiscard]] std::optional<vec3> vector(std::string_view key, Range range) const;
    [[nodiscard]] std::optional<bool> on_off(std::string_view key) const;             ///< a boolean, or its words
    [[nodiscard]] const toml::table* subtable(std::string_view key) const;            ///< null when not there
    [[nodiscard]] std::vector<const toml::table*> tables(std::string_view key) const; ///< of an array of tables

    // The same for keys that must be there.
    [[nodiscard]] std::string required_text(std::string_view key) const;
    [[nodiscard]] float required_number(std::string_view key, Range range) const;
    [[nodiscard]] vec3 required_vector(std::string_view key, Range range) const;

    [[noreturn]] void fail(std::string_view key, std::string why, std::string next) const;

private:
    void require(std::string_view key) const;
    [[noreturn]] void wrong_kind(std::string_view key, std::string_view expected) const;

    const std::filesystem::path& file_;
    const toml::table& table_;
    std::string what_;
};

} // namespace atrium
