#pragma once
// Shaders that are edited while the window is open: compiled beside it, put into the engine when they are good.

#include "app/view/shader_sources.hpp"
#include "renderer/engine.hpp"

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <future>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace atrium::app {

class ShaderReload {
public:
    /// Of the sources in the folder; of none where it is empty.
    ShaderReload(Engine& engine, const std::filesystem::path& folder);

    /// Looks for changed files, at most twice a second, and puts in what has been compiled since. To be called between
    /// frames. Returns whether the next picture or problem() may be another.
    bool update();
    /// Compiles every shader again, whatever the files' times say.
    void compile_all();
    /// Whether something is being compiled.
    [[nodiscard]] bool busy() const { return job_.valid(); }
    /// What is wrong with the sources as they are; empty when all of them are in use.
    [[nodiscard]] const std::string& problem() const { return problem_; }

private:
    struct Compiled {
        std::string shader, error; ///< either an error or code
        std::vector<std::uint32_t> code;
    };
    void look();
    void start();
    /// Returns whether the engine draws with it from now on.
    bool take(Compiled compiled);
    void tell();

    Engine& engine_;
    std::filesystem::path folder_;
    ShaderSources sources_;
    std::chrono::steady_clock::time_point looked_;
    std::set<std::string> waiting_;                            ///< to be compiled
    std::future<std::vector<Compiled>> job_;                   ///< those that are
    std::map<std::string, std::vector<std::uint32_t>> in_use_; ///< of shaders that have been replaced
    std::map<std::string, std::string> errors_;                ///< by shader
    std::string problem_;
};

} // namespace atrium::app
