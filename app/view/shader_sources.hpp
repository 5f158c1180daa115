#pragma once
// The files that shaders are made of, and which shaders a changed file is part of.

#include <chrono>
#include <filesystem>
#include <map>
#include <set>
#include <string>

namespace atrium::app {

class ShaderSources {
public:
    /// What is newer than `known` counts as changed.
    ShaderSources(std::filesystem::path folder, std::filesystem::file_time_type known);

    /// Embedded shaders, by their path in the folder, whose source or an include of it was written since the last call.
    /// Looks at the time of each file.
    [[nodiscard]] std::set<std::string> changed();
    /// All embedded shaders that the folder has.
    [[nodiscard]] std::set<std::string> all() const;

private:
    [[nodiscard]] std::set<std::string> with_includers(std::set<std::string> files) const;
    std::filesystem::path folder_;
    std::filesystem::file_time_type known_;
    std::map<std::string, std::filesystem::file_time_type> times_; ///< by path in the folder
};

} // namespace atrium::app
