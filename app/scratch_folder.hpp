#pragma once
// A place for files that other programs write for this one.

#include <filesystem>
#include <string>

namespace atrium::app {

/// A new folder among the temporary files, which goes with its object.
class ScratchFolder {
public:
    /// Throws Error(environment).
    ScratchFolder();
    ~ScratchFolder();
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

/// The whole of a file; empty where it cannot be read.
[[nodiscard]] std::string read_text(const std::filesystem::path& file);

} // namespace atrium::app
