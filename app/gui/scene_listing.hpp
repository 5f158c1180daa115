#pragma once
// What a path that is being typed may go on with: folders, and files that can be opened as scenes.

#include <filesystem>
#include <string>
#include <vector>

namespace atrium::gui {

struct SceneListing {
    std::filesystem::path folder;   ///< that was looked into
    std::vector<std::string> lines; ///< names in it that begin as typed: folders first, which end in '/'
    std::string completed;          ///< the typed text, with what all lines have in common
};

/// Reads a folder from the disk. A leading "~/" is the user's; relative paths count from where the program was started.
/// Hidden files are listed once their dot is typed. No line where the folder cannot be read.
[[nodiscard]] SceneListing list_scenes(const std::string& typed);

/// The typed text as a path, with the user's folder in place of a leading "~/".
[[nodiscard]] std::filesystem::path typed_path(const std::string& typed);

/// The typed text with its last name, which may be half typed, replaced by a line of its listing.
[[nodiscard]] std::string with_line(const std::string& typed, const std::string& line);

} // namespace atrium::gui
