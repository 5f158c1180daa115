#pragma once
// No output may replace an input.

#include <filesystem>
#include <span>
#include <string>

namespace atrium {

/// A file that is about to be written, and the option that names it.
struct OutputFile {
    std::string option;
    std::filesystem::path file; ///< empty or "-" (standard output) is no file
};

/// Whether both paths lead to the same file: through symbolic links, hard links, "..", or in another spelling. If one
/// does not exist yet, the paths are compared with links resolved in the parts that exist.
[[nodiscard]] bool is_same_file(const std::filesystem::path& a, const std::filesystem::path& b);

/// Throws Error(usage) when writing one of `outputs` would replace one of `inputs`. To be called before anything is
/// read, with the files that the command line names, and again before anything is written, with all that were read.
void refuse_overwriting(std::span<const OutputFile> outputs, std::span<const std::filesystem::path> inputs);

} // namespace atrium
