#pragma once
// The folder of bakes made of OBJ files: each a file .atrium, and beside it the record .json of what it was made from.

#include "renderer/core/input_record.hpp"

#include <cstdint>
#include <filesystem>
#include <string>

namespace atrium::app {

/// $XDG_CACHE_HOME/atrium, or ~/.cache/atrium; empty when neither variable is set.
[[nodiscard]] std::filesystem::path cache_folder();

/// What the bakes may take together, in bytes: 4 GiB, or $ATRIUM_CACHE_MIB.
[[nodiscard]] std::uint64_t bake_cache_limit();

/// One bake's two files. `key` says everything that it depends on but its inputs.
struct CachedBake {
    CachedBake(const std::filesystem::path& obj, const std::string& key);
    std::filesystem::path bake, record;

    /// Whether the bake is there and whole, of this record, and all its inputs are as they were; `inputs` gets the
    /// record. Says in a line why it is not, where there is more to say than that there is none.
    [[nodiscard]] bool is_current(InputRecord& inputs) const;
    /// Puts it last in the order in which bakes are removed.
    void mark_used() const;
};

/// Removes the bakes that were not used for the longest time until the rest takes at most `limit` bytes; never `kept`.
/// What a stopped program left behind goes after a day.
void trim_bakes(const std::filesystem::path& folder, std::uint64_t limit, const CachedBake& kept);

} // namespace atrium::app
