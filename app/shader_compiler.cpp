#include "app/shader_compiler.hpp"

#include "app/child_process.hpp"
#include "app/scratch_folder.hpp"
#include "renderer/core/error.hpp"
#include "shaders/sources.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

namespace atrium::app {
namespace {

/// From "ERROR: FILE:LINE: message" on the first such line of what the compiler printed.
Error first_mistake(const std::string& printed, const std::filesystem::path& folder, const std::string& shader)
{
    constexpr std::string_view mark = "ERROR: ";
    std::string where = shader, why = "the compiler has ended without a word";
    if (const std::size_t at = printed.find(mark); at != std::string::npos) {
        std::string line = printed.substr(at + mark.size());
        line.erase(std::min(line.find('\n'), line.size()));
        const std::size_t colon = line.find(": ");
        why = colon == std::string::npos ? line : line.substr(colon + 2);
        if (colon != std::string::npos) where = line.substr(0, colon);
        const std::string prefix = (folder / "").string();
        if (where.starts_with(prefix)) where.erase(0, prefix.size());
    }
    return {ExitCode::input, fmt::format("{} does not compile", where.substr(0, where.find(':'))), where, why,
            "mend it; until then the shader from before is used"};
}

} // namespace

std::vector<std::uint32_t> compile_shader(const std::filesystem::path& folder, const std::string& name)
{
    const ScratchFolder scratch;
    const std::filesystem::path code_file = scratch.path() / "code", printed_file = scratch.path() / "printed";
    std::vector<std::string> command(shaders::compiler().begin(), shaders::compiler().end());
    for (std::string word : {"-I" + folder.string(), std::string("-o"), code_file.string(), (folder / name).string()})
        command.push_back(std::move(word));
    const int code = ChildProcess(command, printed_file).wait();
    const std::string bytes = read_text(code_file);
    if (code != 0 || bytes.empty()) throw first_mistake(read_text(printed_file), folder, name);
    std::vector<std::uint32_t> out(bytes.size() / sizeof(std::uint32_t));
    std::memcpy(out.data(), bytes.data(), out.size() * sizeof(std::uint32_t));
    return out;
}

} // namespace atrium::app
