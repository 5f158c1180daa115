#pragma once
// The inputs of a result: every file that was read, and every name that was searched in a folder. The result is made
// again exactly when one of them has changed.

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace atrium {

/// Entries of a folder that equal `name` except for the case of ASCII letters, in byte order.
[[nodiscard]] std::vector<std::string> entries_like(const std::filesystem::path& folder, std::string_view name);

class InputRecord {
public:
    /// A record that is not `kept` stays empty and costs nothing.
    explicit InputRecord(bool kept = true) : kept_(kept) {}

    /// To be called before the file is read. One that does not exist is left out.
    void add_file(const std::filesystem::path& file);
    /// `found`: the result of entries_like(). Other entries of the folder may change.
    void add_search(const std::filesystem::path& folder, std::string_view name, const std::vector<std::string>& found);

    /// Absolute, in the order of adding.
    [[nodiscard]] std::vector<std::filesystem::path> files() const;
    /// A message about the first input that has changed; empty if none has. A file is unchanged if its times, inode and
    /// size are the same, or else if its contents are: a copy or a `touch` is no change.
    [[nodiscard]] std::string change() const;

    std::uint64_t result = 0;       ///< a hash of the result that the record belongs to
    std::vector<std::string> notes; ///< lines to print each time the result is used

    /// Paths are written byte for byte, with %XX for what is not printable ASCII.
    [[nodiscard]] std::string to_json() const;
    /// Throws Error(input); `name` is the place for its message.
    [[nodiscard]] static InputRecord from_json(std::string_view text, const std::string& name);

private:
    struct State {
        std::uint64_t device = 0, inode = 0, size = 0;
        std::int64_t modified = 0, changed = 0; ///< ns since 1970; `changed` also detects edits that reset `modified`
        bool operator==(const State&) const = default;
    };
    struct File {
        std::filesystem::path path;
        State state;
        std::uint64_t hash = 0; ///< XXH3-64 of its bytes
    };
    struct Search {
        std::filesystem::path folder;
        std::string name;
        std::vector<std::string> found;
        bool operator==(const Search&) const = default;
    };
    static bool look(const std::filesystem::path& file, State& state);

    bool kept_;
    std::vector<File> files_;
    std::vector<Search> searches_;
};

} // namespace atrium
