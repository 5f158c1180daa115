#pragma once
// The cache of bakes of OBJ files: for each a file .atrium and, next to it, a record .json of its inputs.

#include "renderer/core/input_record.hpp"

#include <cstdint>
#include <filesystem>
#include <string>

namespace atrium::app {

/// $XDG_CACHE_HOME/atrium, or ~/.cache/atrium; empty when neither variable is set.
[[nodiscard]] std::filesystem::path cache_folder();

/// Largest size of the cache in bytes: 4 GiB, or $ATRIUM_CACHE_MIB.
[[nodiscard]] std::uint64_t bake_cache_limit();

/// One bake's two files. `key` contains everything that the bake depends on, except its inputs.
struct CachedBake {
    CachedBake(const std::filesystem::path& obj, const std::string& key);
    std::filesystem::path bake, record;

    /// Whether the bake exists, is undamaged, matches its record, and no input has changed; `inputs` gets the record.
    /// If the bake exists but cannot be used, logs the reason in one line.
    [[nodiscard]] bool is_current(InputRecord& inputs) const;
    /// Marks it as used now: it becomes the last one to be removed.
    void mark_used() const;
};

/// Removes the least recently used bakes until the rest takes at most `limit` bytes; never removes `kept`. Temporary
/// files of stopped programs are removed after a day.
void trim_bakes(const std::filesystem::path& folder, std::uint64_t limit, const CachedBake& kept);

} // namespace atrium::app
