#pragma once
// Names for files that the window writes.

#include <initializer_list>
#include <string>

namespace atrium::app {

/// "atrium.0000", or the first number for which the present folder has no file with any of the endings.
[[nodiscard]] std::string unused_name(std::initializer_list<const char*> endings);

} // namespace atrium::app
