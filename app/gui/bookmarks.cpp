#include "app/gui/bookmarks.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace atrium::gui {
namespace {

bool has(const Bookmarks& bookmarks, const std::string& name)
{
    return std::any_of(bookmarks.begin(), bookmarks.end(), [&](const NamedCamera& b) { return b.first == name; });
}

} // namespace

std::optional<std::string> add_bookmark(Bookmarks& bookmarks, std::string name, const Camera& camera)
{
    for (std::size_t i = bookmarks.size(); name.empty(); ++i) {
        const std::string free = fmt::format("camera{}", i);
        if (!has(bookmarks, free)) name = free;
    }
    if (has(bookmarks, name)) return fmt::format("another bookmark is called {}", name);
    bookmarks.emplace_back(std::move(name), camera);
    return std::nullopt;
}

std::optional<std::string> rename_bookmark(Bookmarks& bookmarks, std::size_t index, const std::string& name)
{
    if (name.empty()) return "a bookmark needs a name";
    if (name != bookmarks.at(index).first && has(bookmarks, name))
        return fmt::format("another bookmark is called {}", name);
    bookmarks[index].first = name;
    return std::nullopt;
}

} // namespace atrium::gui
