#pragma once
// Work spread over the cores. oneTBB does the scheduling; this header keeps it out of everyone's includes.

#include <cstddef>
#include <functional>

namespace atrium {

/// Number of threads that jobs may use; 0 means all cores. Set once, before the first job.
void set_job_threads(int threads);
[[nodiscard]] int job_threads();

/// Calls body(i) for every i in [0, count), in any order, on several threads; returns when all are done.
/// The first exception thrown by a body is thrown here.
void parallel_for(std::size_t count, const std::function<void(std::size_t)>& body);

} // namespace atrium
