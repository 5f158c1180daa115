#pragma once
// Progress of a long task: a bar on a terminal, plain lines otherwise, nothing with --quiet.

#include <cstddef>
#include <memory>
#include <string>

namespace atrium {

/// Thread-safe. The line is finished by the destructor.
class Progress {
public:
    Progress(std::string title, std::size_t total);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    void advance(std::size_t steps = 1);

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace atrium
