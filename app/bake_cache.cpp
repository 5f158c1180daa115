#include "app/bake_cache.hpp"

#include "app/scratch_folder.hpp"
#include "renderer/core/error.hpp"
#include "renderer/core/hash.hpp"
#include "renderer/core/log.hpp"
#include "renderer/scene/bake_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cstdlib>
#include <map>
#include <span>
#include <string_view>
#include <system_error>
#include <vector>

namespace atrium::app {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t mebibyte = std::uint64_t{1} << 20;
constexpr std::uint64_t default_limit = 4096 * mebibyte; // three dozen of Sponza

} // namespace

fs::path cache_folder()
{
    if (const char* xdg = std::getenv("XDG_CACHE_HOME"); xdg && *xdg) return fs::path(xdg) / "atrium";
    if (const char* home = std::getenv("HOME"); home && *home) return fs::path(home) / ".cache" / "atrium";
    return {};
}

std::uint64_t bake_cache_limit()
{
    const char* set = std::getenv("ATRIUM_CACHE_MIB");
    if (set == nullptr || *set == '\0') return default_limit;
    const std::string_view text = set;
    std::uint32_t mebibytes = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), mebibytes);
    if (error != std::errc{} || end != text.data() + text.size()) {
        throw Error(ExitCode::usage, fmt::format("bad value \"{}\" of ATRIUM_CACHE_MIB", text), "environment",
                    "it is how many MiB the bakes of OBJ files may take", "give a whole number, or unset it");
    }
    return mebibytes * mebibyte;
}

CachedBake::CachedBake(const fs::path& obj, const std::string& key)
{
    constexpr std::size_t longest_stem = 100; // file systems allow 255 bytes in all
    const std::string name =
        fmt::format("{}-{:016x}", obj.stem().string().substr(0, longest_stem), hash64(std::as_bytes(std::span(key))));
    const fs::path folder = cache_folder() / "bakes";
    bake = folder / (name + ".atrium");
    record = folder / (name + ".json");
}

bool CachedBake::is_current(InputRecord& inputs) const
{
    if (!fs::exists(bake) || !fs::exists(record)) return false;
    try {
        InputRecord found = InputRecord::from_json(read_text(record), record.string());
        if (const std::string change = found.change(); !change.empty()) {
            log_info(fmt::format("{}, so the OBJ is baked again", change));
            return false;
        }
        const BakeFile file(bake);
        if (hash64(std::as_bytes(std::span(file.table()))) != found.result)
            throw Error(ExitCode::input, "the bake does not match its record", bake.string(), "", "");
        check_hashes(file);
        inputs = std::move(found);
        return true;
    } catch (const Error& error) {
        log_warning(
            fmt::format("{} in the cache is damaged ({}), so the OBJ is baked again", bake.string(), error.what()));
        return false;
    }
}

void CachedBake::mark_used() const
{
    std::error_code ignored; // a cache that cannot be written can still be read
    fs::last_write_time(record, fs::file_time_type::clock::now(), ignored);
}

void trim_bakes(const fs::path& folder, std::uint64_t limit, const CachedBake& kept)
{
    struct Entry {
        std::uint64_t size = 0;
        fs::file_time_type used = fs::file_time_type::min();
        std::vector<fs::path> files;
    };
    std::map<std::string, Entry> entries;
    std::uint64_t total = 0;
    std::error_code ignored; // another program may remove the same file
    for (fs::directory_iterator it(folder, ignored), end; it != end; it.increment(ignored)) {
        std::error_code gone;
        const fs::path file = it->path();
        const auto time = it->last_write_time(gone);
        const std::uint64_t size = it->file_size(gone);
        if (gone) continue;
        if (file.filename().string().starts_with(".atrium-")) { // temporary file of AtomicFile
            if (fs::file_time_type::clock::now() - time > std::chrono::hours(24)) fs::remove(file, gone);
            continue;
        }
        if (file.extension() != ".atrium" && file.extension() != ".json") continue;
        Entry& entry = entries[file.stem().string()];
        entry.size += size;
        // The record's time is the time of the last use. A bake without a record was made by an older program.
        if (file.extension() == ".json" || entry.files.empty()) entry.used = time;
        entry.files.push_back(file);
        total += size;
    }
    std::vector<const Entry*> order;
    for (const auto& [stem, entry] : entries) {
        if (stem != kept.bake.stem().string()) order.push_back(&entry);
    }
    std::sort(order.begin(), order.end(), [](const Entry* a, const Entry* b) { return a->used < b->used; });
    for (const Entry* entry : order) {
        if (total <= limit) return;
        for (const fs::path& file : entry->files) fs::remove(file, ignored);
        total -= entry->size;
        log_verbose(fmt::format("removed {} from the cache", entry->files.front().string()));
    }
}

} // namespace atrium::app
