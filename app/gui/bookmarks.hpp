#pragma once
// Cameras by name, as the user keeps them.

#include "renderer/scene/camera.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace atrium::gui {

using NamedCamera = std::pair<std::string, Camera>;

/// No name stands twice. Both functions answer what is wrong with a name, and then change nothing.
using Bookmarks = std::vector<NamedCamera>;

/// An empty name gets a free one.
[[nodiscard]] std::optional<std::string> add_bookmark(Bookmarks& bookmarks, std::string name, const Camera& camera);
[[nodiscard]] std::optional<std::string> rename_bookmark(Bookmarks& bookmarks, std::size_t index,
                                                         const std::string& name);

} // namespace atrium::gui
