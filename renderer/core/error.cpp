#include "renderer/core/error.hpp"

#include <utility>

namespace atrium {

Error::Error(ExitCode code, const std::string& what, std::string where, std::string why, std::string next)
    : std::runtime_error(what), code_(code), where_(std::move(where)), why_(std::move(why)), next_(std::move(next))
{}

std::string Error::text() const
{
    std::string out = what();
    if (!where_.empty()) out += "\n  where: " + where_;
    if (!why_.empty()) out += "\n  why:   " + why_;
    if (!next_.empty()) out += "\n  next:  " + next_;
    return out;
}

} // namespace atrium
