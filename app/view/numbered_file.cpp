#include "app/view/numbered_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace atrium::app {

std::string unused_name(std::initializer_list<const char*> endings)
{
    for (int i = 0;; ++i) {
        std::string name = fmt::format("atrium.{:04}", i);
        const auto taken = [&](const char* ending) { return std::filesystem::exists(name + ending); };
        if (std::none_of(endings.begin(), endings.end(), taken)) return name;
    }
}

} // namespace atrium::app
