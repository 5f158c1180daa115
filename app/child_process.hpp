#pragma once
// Starting programs.

#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace atrium::app {

/// The file of the running program.
[[nodiscard]] std::filesystem::path this_program();

/// A program that runs beside this one. It is stopped when its object goes.
class ChildProcess {
public:
    /// What it prints goes to our stderr, or into a file. Throws Error(environment) when it cannot be started.
    explicit ChildProcess(const std::vector<std::string>& command, const std::filesystem::path& output = {});
    ~ChildProcess();
    ChildProcess(const ChildProcess&) = delete;
    ChildProcess& operator=(const ChildProcess&) = delete;

    /// Its exit code, or minus the signal that ended it; none while it runs.
    [[nodiscard]] std::optional<int> ended();
    /// The same, once it has ended.
    [[nodiscard]] int wait();

private:
    void collect(int options);
    pid_t pid_ = 0;
    std::optional<int> code_;
};

} // namespace atrium::app
