#include "app/child_process.hpp"

#include "renderer/core/error.hpp"

#include <fmt/format.h>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>

namespace atrium::app {

std::filesystem::path this_program()
{
    return std::filesystem::read_symlink("/proc/self/exe");
}

ChildProcess::ChildProcess(const std::vector<std::string>& command, const std::filesystem::path& output)
{
    std::vector<char*> arguments;
    for (const std::string& word : command)
        arguments.push_back(const_cast<char*>(word.c_str())); // NOLINT: exec's signature
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    if (!output.empty()) {
        posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, output.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    }
    // What the child prints must not mix with pictures or JSON on our stdout.
    posix_spawn_file_actions_adddup2(&actions, STDERR_FILENO, STDOUT_FILENO);
    const int error = posix_spawn(&pid_, arguments[0], &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    if (error != 0) {
        throw Error(ExitCode::environment, fmt::format("could not start {}", command.front()), "", std::strerror(error),
                    "see that it is installed");
    }
}

ChildProcess::~ChildProcess()
{
    if (ended()) return;
    kill(pid_, SIGTERM);
    collect(0);
}

std::optional<int> ChildProcess::ended()
{
    collect(WNOHANG);
    return code_;
}

int ChildProcess::wait()
{
    collect(0);
    return code_.value_or(0);
}

void ChildProcess::collect(int options)
{
    if (code_) return;
    int status = 0;
    pid_t done = 0;
    do {
        done = waitpid(pid_, &status, options);
    } while (done < 0 && errno == EINTR);
    if (done == pid_) code_ = WIFSIGNALED(status) ? -WTERMSIG(status) : WEXITSTATUS(status);
}

} // namespace atrium::app
