#pragma once
// The one description of a setting. A technique owns a plain struct with defaults in its fields and a function template
// beside it:
//
//     template <class V> void describe(V& v, AoSettings& s)
//     {
//         v.group("ao", "Ambient occlusion");
//         v("method", s.method, "Which method, or off");
//         v("radius", s.radius, "How far occluders are sought", Range{0.05f, 50.0f}, "m");
//         v("samples", s.samples, "Depth samples", Range{4, 512}, "per pixel", Cpu{8});
//     }
//
// After the help come, in any order and all optional: a Range (each component's, for a vec3), a unit, a CPU device's
// default where it differs, and Keys. Fields are bool, int, float, std::string, vec3, or an enum whose values count
// from 0 and whose names `constexpr auto enum_names(E)` beside it gives as an array of const char* in that order.

#include "renderer/core/error.hpp"
#include "renderer/core/math.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace atrium {

/// Both ends are allowed values.
struct Range {
    float min, max;
};

/// Default on a CPU device.
template <class T>
struct Cpu {
    T value;
};
template <class T>
Cpu(T) -> Cpu<T>;

/// Keys that change it in the window, as docs/window.md names keys; empty: none, unless the user gives one. `more`
/// turns a switch on and off, a choice to its next value or from `first` to `second` and back, and makes a number
/// greater; `less` makes a number less.
struct Keys {
    const char* more = "";
    const char* less = "";
    const char *first = "", *second = "";
};

/// An enum of any type, by index.
struct EnumField {
    void* value = nullptr;
    int (*get)(const void*) = nullptr;
    void (*set)(void*, int) = nullptr;
};

/// One setting, bound to the live field it was described with, which must outlive it.
struct Setting {
    using Value = std::variant<bool, int, float, std::string, vec3>; ///< of an enum the index
    std::string key, group_title, unit, help;
    std::optional<Range> range;
    std::vector<std::string> values; ///< of an enum; of text, those that offer() said
    std::string default_text, cpu_default;
    Value default_value, cpu_value; ///< the same defaults as values
    Keys keys;
    std::variant<bool*, int*, float*, std::string*, vec3*, EnumField> field;

    /// bool, int, float, string, vec3 or enum.
    [[nodiscard]] const char* type() const;
    /// The value as --set takes it; set_text(get()) changes nothing.
    [[nodiscard]] std::string get() const;
    [[nodiscard]] Value value() const;
    /// Whether the field has its default (on a CPU device the CPU default). Compares values, not texts.
    [[nodiscard]] bool is_default(bool is_cpu) const { return value() == (is_cpu ? cpu_value : default_value); }
    /// What is wrong with `text` (and the advice), or nothing, and then the field is changed.
    struct Refusal {
        std::string why, next;
    };
    [[nodiscard]] std::optional<Refusal> set_text(std::string_view text) const;
};

/// The visitor that gathers settings under one roof. Bind it to freshly made structs: their values are the defaults.
/// Two settings of one key, or a default out of its range, are defects of ours: std::logic_error.
class SettingList {
public:
    /// `noun` and `hint` word the messages: unknown <noun> "x" … did you mean "y"? <hint>
    explicit SettingList(std::string noun = "setting", std::string hint = "\"atrium settings\" lists all");

    // For describe().
    /// `prefix` stands before the keys that follow, with a dot; empty: keys stand alone.
    void group(std::string_view prefix, std::string_view title);
    template <class T, class... Extra>
    void operator()(std::string_view name, T& value, std::string_view help, const Extra&... extra);

    // For everyone else.
    [[nodiscard]] const std::vector<Setting>& all() const { return settings_; } ///< in order of description
    [[nodiscard]] const Setting* find(std::string_view key) const;              ///< null when there is none
    [[nodiscard]] std::string nearest(std::string_view key) const;              ///< the valid key closest to `key`

    /// Throws Error(`code`) for an unknown key (naming the nearest), a text that is no such value, a value out of range
    /// (naming the range) or not one of the values (naming the nearest). `where` is the option or file:line.
    void set(std::string_view key, std::string_view text, ExitCode code, std::string_view where) const;
    void apply_cpu_defaults() const;
    /// Says what a user may want to choose from for a setting that is text. Others are taken as before.
    void offer(std::string_view key, std::vector<std::string> values);

    /// Key and text of every setting that differs from its default, in order of description.
    [[nodiscard]] std::vector<std::pair<std::string, std::string>> differing() const;

    /// All with their present values, under [settings], with help, unit and range as comments. A file for --config.
    [[nodiscard]] std::string to_toml() const;
    /// An array of {key,type,unit,range,values,default,cpu_default,help}. Range is [min,max] or null, values an array
    /// or null, defaults are typed (a vec3 is an array of three numbers); cpu_default is always there.
    [[nodiscard]] std::string to_json() const;
    /// A heading and a table for each group.
    [[nodiscard]] std::string to_markdown() const;

private:
    void add(std::string_view name, std::string_view help, Setting setting);

    template <class T>
    static void extend(Setting& setting, const Range& range)
    {
        static_assert(std::is_same_v<T, int> || std::is_same_v<T, float> || std::is_same_v<T, vec3>,
                      "only numbers have a range");
        setting.range = range;
    }
    template <class T>
    static void extend(Setting& setting, std::string_view unit)
    {
        setting.unit = unit;
    }
    template <class T>
    static void extend(Setting& setting, const Keys& keys)
    {
        setting.keys = keys;
    }
    template <class T, class C>
    static void extend(Setting& setting, const Cpu<C>& cpu);

    std::string noun_, hint_, prefix_, title_;
    std::vector<Setting> settings_;
};

namespace detail {

template <class T>
void bind(Setting& setting, T& value)
{
    if constexpr (std::is_enum_v<T>) {
        setting.field = EnumField{&value, [](const void* p) { return static_cast<int>(*static_cast<const T*>(p)); },
                                  [](void* p, int i) { *static_cast<T*>(p) = static_cast<T>(i); }};
    } else {
        setting.field = &value;
    }
}

} // namespace detail

namespace detail {

/// The visitor that collects the addresses of a struct's fields.
struct FieldAddresses {
    std::vector<const void*> fields; ///< in order of description
    void group(std::string_view /*prefix*/, std::string_view /*title*/) {}
    template <class T, class... Extra>
    void operator()(std::string_view /*name*/, T& value, std::string_view /*help*/, const Extra&... /*extra*/)
    {
        fields.push_back(&value);
    }
};

/// The visitor that compares the fields of a struct with those of another one of its type.
struct FieldComparison {
    const std::vector<const void*>& others;
    std::size_t next = 0;
    bool same = true;
    void group(std::string_view /*prefix*/, std::string_view /*title*/) {}
    template <class T, class... Extra>
    void operator()(std::string_view /*name*/, T& value, std::string_view /*help*/, const Extra&... /*extra*/)
    {
        same = same && *static_cast<const T*>(others[next++]) == value;
    }
};

} // namespace detail

/// Whether two structs have equal values in all fields that describe() lists. The window calls it in every frame, so it
/// compares values, not texts.
template <class S>
[[nodiscard]] bool same_settings(const S& a, const S& b)
{
    detail::FieldAddresses of_a;
    describe(of_a, const_cast<S&>(a)); // safe: the visitors only read
    detail::FieldComparison comparison{of_a.fields};
    describe(comparison, const_cast<S&>(b));
    return comparison.same;
}

template <class T, class C>
void SettingList::extend(Setting& setting, const Cpu<C>& cpu)
{
    T value = static_cast<T>(cpu.value);
    Setting other = setting;
    detail::bind(other, value);
    setting.cpu_default = other.get();
}

template <class T, class... Extra>
void SettingList::operator()(std::string_view name, T& value, std::string_view help, const Extra&... extra)
{
    Setting setting;
    if constexpr (std::is_enum_v<T>) {
        for (const char* known : enum_names(T{})) setting.values.emplace_back(known);
    }
    detail::bind(setting, value);
    (extend<T>(setting, extra), ...);
    add(name, help, std::move(setting));
}

} // namespace atrium
