#pragma once
// OBJ files given as SCENE: baked once, kept in the cache until a file that the bake was made from changes.

#include "app/bake_cache.hpp"
#include "app/child_process.hpp"
#include "app/scratch_folder.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace atrium::app {

/// The bake of an OBJ, and the assetconv beside this program that makes it where the cache has none. It is stopped when
/// the object goes.
class ObjBake {
public:
    /// What assetconv says: goes to stderr, or is kept for progress() and errors.
    enum class Output { shown, kept };

    /// Warnings of the bake are always printed to stderr, also for a cached bake. Throws Error.
    ObjBake(const std::filesystem::path& obj, double scale, const std::string& up, Output output);

    /// Whether the bake is there. Throws Error where it could not be made.
    [[nodiscard]] bool done();
    /// Waits until it is there. Throws the same.
    void wait();
    /// The last line that assetconv said.
    [[nodiscard]] std::string progress() const;
    [[nodiscard]] const std::filesystem::path& bake() const { return cached_.bake; }
    /// Every file that the bake was made from; empty until there is a bake.
    [[nodiscard]] std::vector<std::filesystem::path> inputs() const { return inputs_.files(); }

private:
    [[nodiscard]] std::filesystem::path said_file() const;
    void finish(int code);
    void check(int code) const;
    std::filesystem::path obj_;
    CachedBake cached_;
    InputRecord inputs_;
    bool finished_ = false;
    std::optional<ScratchFolder> scratch_; ///< where the output is kept
    std::optional<ChildProcess> child_;
};

} // namespace atrium::app
