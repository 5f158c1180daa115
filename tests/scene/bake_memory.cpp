#include "tests/scene/bake_memory.hpp"

#include <malloc.h>

#include <atomic>
#include <cstdlib>
#include <new>

namespace {

std::atomic<std::size_t> g_live{0}, g_peak{0};

void* counted(std::size_t size)
{
    void* p = std::malloc(size > 0 ? size : 1);
    if (p == nullptr) throw std::bad_alloc();
    const std::size_t live = g_live += malloc_usable_size(p);
    std::size_t peak = g_peak;
    while (live > peak && !g_peak.compare_exchange_weak(peak, live)) {
    }
    return p;
}

void discounted(void* p)
{
    if (p == nullptr) return;
    g_live -= malloc_usable_size(p);
    std::free(p);
}

} // namespace

void* operator new(std::size_t size)
{
    return counted(size);
}
void* operator new[](std::size_t size)
{
    return counted(size);
}
void operator delete(void* p) noexcept
{
    discounted(p);
}
void operator delete[](void* p) noexcept
{
    discounted(p);
}
void operator delete(void* p, std::size_t) noexcept
{
    discounted(p);
}
void operator delete[](void* p, std::size_t) noexcept
{
    discounted(p);
}

namespace atrium::bake_rig {

std::size_t peak_memory_of(const std::function<void()>& act)
{
    const std::size_t before = g_live;
    g_peak = before;
    act();
    return g_peak - before;
}

} // namespace atrium::bake_rig
