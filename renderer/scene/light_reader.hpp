#pragma once
// One light gathered key by key, wherever the keys stand: the command line's SPEC or a table of a scene file.

#include "renderer/scene/light.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace atrium {

class LightReader {
public:
    /// Throws Error(`code`) for an unknown type, naming the nearest.
    LightReader(std::string_view type, ExitCode code, std::string where);
    LightReader(const LightReader&) = delete; // keys_ points into light_
    LightReader& operator=(const LightReader&) = delete;

    [[nodiscard]] const SettingList& keys() const { return keys_; }

    /// Throws for an unknown key, a bad value, a key given before.
    void set(std::string_view key, std::string_view text, std::string_view where);
    /// Throws when the position is missing or the keys do not fit each other.
    [[nodiscard]] Light finish() const;

private:
    ExitCode code_;
    std::string where_;
    Light light_;
    SettingList keys_;
    std::vector<std::string> given_;
};

} // namespace atrium
