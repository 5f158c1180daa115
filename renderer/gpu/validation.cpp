#include "renderer/gpu/validation.hpp"

#include "renderer/core/log.hpp"

namespace atrium::gpu {

void ValidationLog::add(std::string message)
{
    log_warning(message);
    const std::lock_guard lock(mutex_);
    messages_.push_back(std::move(message));
}

std::size_t ValidationLog::count() const
{
    const std::lock_guard lock(mutex_);
    return messages_.size();
}

std::vector<std::string> ValidationLog::messages() const
{
    const std::lock_guard lock(mutex_);
    return messages_;
}

} // namespace atrium::gpu
