#pragma once
// The scene file beside the OBJ: cameras, lights and settings.

#include <string>

namespace atrium::courtyard {

[[nodiscard]] std::string scene_text();

} // namespace atrium::courtyard
