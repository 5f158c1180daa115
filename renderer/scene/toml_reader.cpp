#include "renderer/scene/toml_reader.hpp"

#include "renderer/core/error.hpp"
#include "renderer/core/mapped_file.hpp"
#include "renderer/core/nearest_name.hpp"
#include "renderer/core/text_value.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace atrium {
namespace {

constexpr std::size_t max_file_bytes = std::size_t{4} << 20;
constexpr int max_dots = 32;

bool may_stand_in_key(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-' ||
           c == ' ' || c == '\t';
}

/// The place behind a quoted string that begins at `i`. A string that does not end is left to the parser.
std::size_t skip_string(std::string_view text, std::size_t i)
{
    const char quote = text[i];
    const bool escapes = quote == '"', multi_line = text.substr(i, 3) == std::string(3, quote);
    for (i += multi_line ? 3 : 1; i < text.size(); ++i) {
        if (escapes && text[i] == '\\') {
            ++i;
        } else if (multi_line && text.substr(i, 3) == std::string(3, quote)) {
            i += 3;
            for (int more = 0; more < 2 && i < text.size() && text[i] == quote; ++more) ++i; // they belong to it
            return i;
        } else if (!multi_line && (text[i] == quote || text[i] == '\n')) {
            return i + 1;
        }
    }
    return text.size();
}

/// toml++ bounds the nesting of values, but not the parts of a dotted key, each of which is a table in a table: half a
/// megabyte of "a.a.a…" would overflow the stack when they are destroyed. Returns the line of such a key, or 0.
std::size_t line_of_endless_key(std::string_view text)
{
    std::size_t line = 1;
    int dots = 0;
    for (std::size_t i = 0; i < text.size();) {
        const char c = text[i];
        if (c == '"' || c == '\'') {
            const std::size_t end = skip_string(text, i);
            line += static_cast<std::size_t>(std::count(text.begin() + static_cast<std::ptrdiff_t>(i),
                                                        text.begin() + static_cast<std::ptrdiff_t>(end), '\n'));
            i = end;
            continue;
        }
        if (c == '#') {
            i = std::min(text.find('\n', i), text.size());
            continue;
        }
        if (c == '.') {
            if (++dots > max_dots) return line;
        } else if (!may_stand_in_key(c)) {
            dots = 0;
        }
        if (c == '\n') ++line;
        ++i;
    }
    return 0;
}

std::optional<double> finite_number(const toml::node& node)
{
    if (!node.is_number()) return std::nullopt;
    const auto value = node.value<double>();
    return value && std::isfinite(*value) ? value : std::nullopt;
}

/// Compared after conversion to float, because the shortest text of the largest float is a little above its value.
bool within(double value, Range range)
{
    constexpr double beyond_floats = 3.4028236e38;
    if (std::abs(value) >= beyond_floats) return false;
    const auto number = static_cast<float>(value);
    return number >= range.min && number <= range.max;
}

void add_dotted_entries(const toml::table& table, const std::string& prefix, int depth, std::vector<TomlEntry>& out)
{
    constexpr int deepest = 4; // no key has as many parts
    for (TomlEntry& entry : in_file_order(table)) {
        entry.key = prefix + entry.key;
        if (const toml::table* inner = entry.node->as_table(); inner != nullptr && depth < deepest)
            add_dotted_entries(*inner, entry.key + ".", depth + 1, out);
        else
            out.push_back(std::move(entry));
    }
}

} // namespace

toml::table parse_toml(const std::filesystem::path& file)
{
    const MappedFile mapped(file);
    const auto bytes = mapped.bytes();
    if (bytes.size() > max_file_bytes) {
        throw Error(
            ExitCode::input, fmt::format("\"{}\" is too large", file.string()), file.string(),
            fmt::format("it has {} bytes; a scene or settings file has at most {}", bytes.size(), max_file_bytes),
            "give a TOML file");
    }
    return parse_toml_text({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, file);
}

toml::table parse_toml_text(std::string_view text, const std::filesystem::path& file)
{
    if (const std::size_t line = line_of_endless_key(text); line != 0) {
        throw Error(ExitCode::input, "a key has too many parts", fmt::format("{}:{}", file.string(), line),
                    fmt::format("it has more than {} dots", max_dots), "mend the key");
    }
    try {
        return toml::parse(text, file.string());
    } catch (const toml::parse_error& e) {
        throw Error(ExitCode::input, fmt::format("\"{}\" is not valid TOML", file.string()), where_in(file, e.source()),
                    std::string(e.description()), "mend the file at that line");
    }
}

std::string where_in(const std::filesystem::path& file, const toml::source_region& source)
{
    return fmt::format("{}:{}", file.string(), source.begin.line);
}

const char* kind_of(const toml::node& node)
{
    switch (node.type()) {
    case toml::node_type::table:
        return "a table";
    case toml::node_type::array:
        return "an array";
    case toml::node_type::string:
        return "a string";
    case toml::node_type::integer:
        return "a whole number";
    case toml::node_type::floating_point:
        return "a number";
    case toml::node_type::boolean:
        return "a boolean";
    default:
        return "a date or time";
    }
}

std::vector<TomlEntry> in_file_order(const toml::table& table)
{
    std::vector<TomlEntry> entries;
    for (const auto& [key, node] : table) entries.push_back({std::string(key.str()), &node, key.source()});
    std::stable_sort(entries.begin(), entries.end(),
                     [](const TomlEntry& a, const TomlEntry& b) { return a.source.begin < b.source.begin; });
    return entries;
}

std::vector<TomlEntry> dotted_entries(const toml::table& table)
{
    std::vector<TomlEntry> out;
    add_dotted_entries(table, "", 0, out);
    return out;
}

TomlReader::TomlReader(const std::filesystem::path& file, const toml::table& table, std::string what,
                       std::vector<std::string> keys)
    : file_(file), table_(table), what_(std::move(what))
{
    for (const TomlEntry& entry : in_file_order(table)) {
        if (std::find(keys.begin(), keys.end(), entry.key) != keys.end()) continue;
        throw Error(ExitCode::input, fmt::format("unknown key \"{}\" in {}", entry.key, what_),
                    where_in(file, entry.source), fmt::format("its keys are {}", fmt::join(keys, ", ")),
                    did_you_mean(entry.key, keys, "use one of them, or remove the line"));
    }
}

std::string TomlReader::where() const
{
    return where_in(file_, table_.source());
}

std::string TomlReader::where(std::string_view key) const
{
    const auto found = table_.find(key);
    return found == table_.end() ? where() : where_in(file_, found->first.source());
}

void TomlReader::fail(std::string_view key, std::string why, std::string next) const
{
    throw Error(ExitCode::input, fmt::format("bad value of \"{}\" in {}", key, what_), where(key), std::move(why),
                std::move(next));
}

void TomlReader::wrong_kind(std::string_view key, std::string_view expected) const
{
    fail(key, fmt::format("expected {}, found {}", expected, kind_of(*table_.get(key))),
         fmt::format("give {}", expected));
}

void TomlReader::require(std::string_view key) const
{
    if (has(key)) return;
    throw Error(ExitCode::input, fmt::format("{} has no \"{}\"", what_, key), where(), "the key is required",
                "add it to the table");
}

std::optional<std::string> TomlReader::text(std::string_view key) const
{
    if (!has(key)) return std::nullopt;
    auto value = table_.get(key)->value_exact<std::string>();
    if (!value) wrong_kind(key, "a string");
    return value;
}

std::optional<float> TomlReader::number(std::string_view key, Range range) const
{
    if (!has(key)) return std::nullopt;
    const auto value = finite_number(*table_.get(key));
    if (!value) wrong_kind(key, "a finite number");
    if (!within(*value, range)) {
        fail(key, fmt::format("the range is {} to {}", range.min, range.max), "give a number in the range");
    }
    return static_cast<float>(*value);
}

std::optional<double> TomlReader::real(std::string_view key) const
{
    if (!has(key)) return std::nullopt;
    auto value = finite_number(*table_.get(key));
    if (!value) wrong_kind(key, "a finite number");
    return value;
}

std::optional<vec3> TomlReader::vector(std::string_view key, Range range) const
{
    if (!has(key)) return std::nullopt;
    const toml::array* array = table_.get(key)->as_array();
    if (array == nullptr || array->size() != 3) wrong_kind(key, "an array of three numbers");
    vec3 value(0);
    for (int i = 0; i < 3; ++i) {
        const auto component = finite_number((*array)[static_cast<std::size_t>(i)]);
        if (!component) wrong_kind(key, "an array of three finite numbers");
        if (!within(*component, range)) {
            fail(key, fmt::format("the range of each number is {} to {}", range.min, range.max),
                 "give numbers in the range");
        }
        value[i] = static_cast<float>(*component);
    }
    return value;
}

std::optional<bool> TomlReader::on_off(std::string_view key) const
{
    if (!has(key)) return std::nullopt;
    const toml::node& node = *table_.get(key);
    auto value = node.value_exact<bool>();
    if (const auto word = node.value_exact<std::string_view>()) value = parse_bool(*word);
    if (!value) wrong_kind(key, "true, false, \"on\" or \"off\"");
    return value;
}

const toml::table* TomlReader::subtable(std::string_view key) const
{
    if (!has(key)) return nullptr;
    const toml::table* table = table_.get(key)->as_table();
    if (table == nullptr) wrong_kind(key, "a table");
    return table;
}

std::vector<const toml::table*> TomlReader::tables(std::string_view key) const
{
    std::vector<const toml::table*> out;
    if (!has(key)) return out;
    const toml::array* array = table_.get(key)->as_array();
    if (array == nullptr) wrong_kind(key, "an array of tables");
    for (const toml::node& node : *array) {
        if (!node.is_table()) wrong_kind(key, "an array of tables");
        out.push_back(node.as_table());
    }
    return out;
}

std::string TomlReader::required_text(std::string_view key) const
{
    require(key);
    return *text(key);
}

float TomlReader::required_number(std::string_view key, Range range) const
{
    require(key);
    return *number(key, range);
}

vec3 TomlReader::required_vector(std::string_view key, Range range) const
{
    require(key);
    return *vector(key, range);
}

} // namespace atrium
