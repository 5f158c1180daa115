#pragma once
// Runs the program `atrium` as users do.

#include "app/child_process.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace atrium::test {

struct Outcome {
    int code = 0;
    std::string output; ///< stdout and stderr
};

inline std::string quoted(const std::string& word)
{
    return fmt::format("'{}'", word);
}

/// `environment`: assignments as a shell takes them in front of a command.
inline Outcome atrium(const std::vector<std::string>& arguments, const std::string& environment = "")
{
    std::string command = environment + " " + quoted((app::this_program().parent_path() / "atrium").string());
    for (const std::string& word : arguments) command += fmt::format(" {}", quoted(word));
    Outcome outcome;
    FILE* pipe = popen((command + " 2>&1").c_str(), "r"); // NOLINT: the words are the test's own
    std::array<char, 4096> buffer{};
    while (const std::size_t n = fread(buffer.data(), 1, buffer.size(), pipe)) outcome.output.append(buffer.data(), n);
    const int status = pclose(pipe);
    outcome.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    return outcome;
}

inline std::string text_of(const std::filesystem::path& file)
{
    std::ifstream in(file);
    std::ostringstream out;
    out << in.rdbuf();
    return out.str();
}

} // namespace atrium::test
