#pragma once
// Memory that a piece of code takes, counted by this test program's own operator new.

#include <cstddef>
#include <functional>

namespace atrium::bake_rig {

/// The most bytes that were allocated at once while `act` ran, above what was there before.
std::size_t peak_memory_of(const std::function<void()>& act);

} // namespace atrium::bake_rig
