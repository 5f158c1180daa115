#pragma once
// What a program says while it works. Results go to stdout, everything said here to stderr.

#include <string_view>

namespace atrium {

enum class LogLevel { quiet, normal, verbose };

void set_log_level(LogLevel level);
[[nodiscard]] LogLevel log_level();

void log_info(std::string_view line);    ///< unless --quiet
void log_verbose(std::string_view line); ///< with --verbose
void log_warning(std::string_view line); ///< always

} // namespace atrium
