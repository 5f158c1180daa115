#pragma once
// What a result was made from, so that it is made again exactly when one of its inputs is another: every file that was
// read, and every name that was looked for in a folder.

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace atrium {

/// Entries of a folder that equal `name` but for the case of ASCII letters, in byte order.
[[nodiscard]] std::vector<std::string> entries_like(const std::filesystem::path& folder, std::string_view name);

class InputRecord {
public:
    /// A record that is not `kept` stays empty and costs nothing.
    explicit InputRecord(bool kept = true) : kept_(kept) {}

    /// To be called before the file is read. One that does not exist is left out.
    void add_file(const std::filesystem::path& file);
    /// `found`: what entries_like() gave. Other entries of the folder may come and go.
    void add_search(const std::filesystem::path& folder, std::string_view name, const std::vector<std::string>& found);

    /// Absolute, in the order of adding.
    [[nodiscard]] std::vector<std::filesystem::path> files() const;
    /// The first input that is not as it was, in words; empty when all are. A file counts as it was when its times,
    /// inode and size are those of then, else when its bytes are: so a copy or a `touch` changes nothing.
    [[nodiscard]] std::string change() const;

    std::uint64_t result = 0;       ///< a hash of the result that the record belongs to
    std::vector<std::string> notes; ///< lines to be said whenever the result is used

    /// Paths are written byte for byte, with %XX for what is not printable ASCII.
    [[nodiscard]] std::string to_json() const;
    /// Throws Error(input); `name` is the place for its message.
    [[nodiscard]] static InputRecord from_json(std::string_view text, const std::string& name);

private:
    struct State {
        std::uint64_t device = 0, inode = 0, size = 0;
        std::int64_t modified = 0, changed = 0; ///< ns since 1970; `changed` also tells edits that reset `modified`
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
