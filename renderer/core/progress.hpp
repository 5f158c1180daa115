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

    /// `detail` is shown behind the count.
    void advance(std::size_t steps = 1, std::string detail = "");

private:
    struct State;
    std::unique_ptr<State> state_;
};

/// "240 ms each, 1 min 5 s left", for so many more steps.
[[nodiscard]] std::string time_left(double ms_each, std::size_t steps);

} // namespace atrium
