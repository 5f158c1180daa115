#include "renderer/core/log.hpp"

#include <atomic>
#include <cstdio>

namespace atrium {
namespace {

std::atomic<LogLevel> g_level{LogLevel::normal};

void say(std::string_view prefix, std::string_view line)
{
    // One call a line, so that lines of several threads do not mix.
    std::fprintf(stderr, "%.*s%.*s\n", static_cast<int>(prefix.size()), prefix.data(), static_cast<int>(line.size()),
                 line.data());
}

} // namespace

void set_log_level(LogLevel level)
{
    g_level = level;
}
LogLevel log_level()
{
    return g_level;
}

void log_info(std::string_view line)
{
    if (g_level != LogLevel::quiet) say("", line);
}

void log_verbose(std::string_view line)
{
    if (g_level == LogLevel::verbose) say("", line);
}

void log_warning(std::string_view line)
{
    say("warning: ", line);
}

} // namespace atrium
