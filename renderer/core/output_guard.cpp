#include "renderer/core/output_guard.hpp"

#include "renderer/core/error.hpp"

#include <system_error>

#include <fmt/format.h>

namespace atrium {

namespace fs = std::filesystem;

bool is_same_file(const fs::path& a, const fs::path& b)
{
    if (a.empty() || b.empty()) return false;
    std::error_code failed;
    const bool same = fs::equivalent(a, b, failed); // device and inode; fails where one does not exist
    if (!failed) return same;
    std::error_code no_a, no_b;
    const fs::path whole_a = fs::weakly_canonical(fs::absolute(a, no_a), no_a);
    const fs::path whole_b = fs::weakly_canonical(fs::absolute(b, no_b), no_b);
    return !no_a && !no_b && whole_a == whole_b;
}

void refuse_overwriting(std::span<const OutputFile> outputs, std::span<const fs::path> inputs)
{
    for (const OutputFile& output : outputs) {
        if (output.file.empty() || output.file == "-") continue;
        for (const fs::path& input : inputs) {
            if (!is_same_file(output.file, input)) continue;
            throw Error(ExitCode::usage, fmt::format("the output would replace an input: \"{}\"", output.file.string()),
                        fmt::format("{} {}", output.option, output.file.string()),
                        fmt::format("it is the same file as \"{}\", which is read", input.string()),
                        "give the output another name; nothing was written");
        }
    }
}

} // namespace atrium
