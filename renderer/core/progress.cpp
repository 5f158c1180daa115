#include "renderer/core/progress.hpp"

#include "renderer/core/log.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <mutex>
#include <utility>

#include <fmt/format.h>
#include <unistd.h>

namespace atrium {
namespace {

using Clock = std::chrono::steady_clock;
constexpr auto bar_interval = std::chrono::milliseconds(50); // smooth to the eye
constexpr auto line_interval = std::chrono::seconds(2);      // a log file stays short
constexpr std::size_t bar_width = 30, detail_width = 36;     // a longer detail before is wiped out

} // namespace

struct Progress::State {
    std::string title, detail;
    std::size_t total = 0, done = 0;
    bool shown = false, terminal = false;
    Clock::time_point last = Clock::now();
    std::mutex mutex;

    void print(bool last_time) const
    {
        if (!terminal) {
            fmt::print(stderr, "{}: {} of {}{}{}\n", title, done, total, detail.empty() ? "" : ", ", detail);
            return;
        }
        const std::size_t filled = total == 0 ? bar_width : bar_width * done / total;
        fmt::print(stderr, "\r{} [{:#<{}}{:.<{}}] {}/{} {:<{}}{}", title, "", filled, "", bar_width - filled, done,
                   total, detail, detail_width, last_time ? "\n" : "");
        std::fflush(stderr);
    }
};

Progress::Progress(std::string title, std::size_t total) : state_(std::make_unique<State>())
{
    state_->title = std::move(title);
    state_->total = total;
    state_->shown = log_level() != LogLevel::quiet && total > 0;
    state_->terminal = ::isatty(STDERR_FILENO) != 0;
    if (state_->shown && state_->terminal) state_->print(false);
}

Progress::~Progress()
{
    if (state_->shown) state_->print(true);
}

void Progress::advance(std::size_t steps, std::string detail)
{
    const std::lock_guard lock(state_->mutex);
    state_->detail = std::move(detail);
    state_->done = std::min(state_->total, state_->done + steps);
    if (!state_->shown || state_->done == state_->total) return; // the destructor prints the end
    const auto now = Clock::now();
    if (now - state_->last < (state_->terminal ? Clock::duration(bar_interval) : Clock::duration(line_interval)))
        return;
    state_->last = now;
    state_->print(false);
}

std::string time_left(double ms_each, std::size_t steps)
{
    const auto seconds = static_cast<long long>(std::ceil(ms_each * static_cast<double>(steps) / 1000));
    const std::string minutes = seconds >= 60 ? fmt::format("{} min ", seconds / 60) : "";
    return fmt::format("{:.0f} ms each, {}{} s left", ms_each, minutes, seconds % 60);
}

} // namespace atrium
