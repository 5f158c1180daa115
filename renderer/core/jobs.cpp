#include "renderer/core/jobs.hpp"

#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>

#include <memory>

namespace atrium {
namespace {

std::unique_ptr<tbb::global_control> g_limit; // NOLINT: lives as long as the program

} // namespace

void set_job_threads(int threads)
{
    g_limit.reset();
    if (threads > 0) {
        g_limit = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism,
                                                        static_cast<std::size_t>(threads));
    }
}

int job_threads()
{
    return static_cast<int>(tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
}

void parallel_for(std::size_t count, const std::function<void(std::size_t)>& body)
{
    tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) { body(i); });
}

} // namespace atrium
