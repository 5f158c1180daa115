#pragma once
// The dialog that asks for another scene.

#include "app/gui/scene_listing.hpp"

#include <filesystem>
#include <optional>
#include <span>
#include <string>

namespace atrium::gui {

class OpenDialog {
public:
    void show() { wanted_ = true; }
    /// Since the last frame: it has the keyboard then.
    [[nodiscard]] bool is_open() const { return open_; }
    /// Draws it where it is open, over everything: a path to type, which Tab completes, and under it the scenes of
    /// `recent` (newest first) and what the typed folder holds. Returns the file that was typed or chosen.
    [[nodiscard]] std::optional<std::filesystem::path> draw(std::span<const std::filesystem::path> recent, float scale);

private:
    /// True when Enter was pressed.
    [[nodiscard]] bool draw_field();
    [[nodiscard]] std::optional<std::filesystem::path> draw_lists(std::span<const std::filesystem::path> recent);
    /// Goes on with another text, the cursor behind it.
    void go_on_with(const std::string& text);

    bool wanted_ = false; ///< from the next frame on
    bool open_ = false;
    bool takes_keys_ = false;    ///< the field is to have the keyboard
    bool cursor_to_end_ = false; ///< of the field, once it has it
    std::string typed_;
    SceneListing listing_; ///< of typed_
};

} // namespace atrium::gui
