#pragma once
// Images of the interface (shared::ui_…) as handles of ImGui's, which are pointers of which null means none.

#include <cstdint>

#include <imgui/imgui.h>

namespace atrium::gui {

[[nodiscard]] inline ImTextureID ui_image(std::uint32_t image)
{
    // clang-tidy 14 dies of std::bit_cast to a pointer.
    // NOLINTNEXTLINE(performance-no-int-to-ptr)
    return reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(image) + 1);
}

[[nodiscard]] inline std::uint32_t image_of(ImTextureID id)
{
    return static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(id) - 1);
}

} // namespace atrium::gui
