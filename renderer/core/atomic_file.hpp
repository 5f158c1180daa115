#pragma once
// Output files appear whole or not at all: written to a temporary beside, then renamed.

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <span>
#include <string_view>

namespace atrium {

/// Write, then commit(). Destroyed without commit(), or when the program is stopped by a signal, it leaves no file.
/// Every call throws Error(environment) with the system's reason when the disk is full or the path not writable.
class AtomicFile {
public:
    explicit AtomicFile(std::filesystem::path target);
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;

    void write(std::span<const std::byte> bytes);
    void write(std::string_view text);
    void write_at(std::uint64_t offset, std::span<const std::byte> bytes); ///< grows the file as needed
    void commit();

    /// The temporary's path, for libraries that want to open the file themselves.
    [[nodiscard]] const std::filesystem::path& temporary() const { return temporary_; }

private:
    std::filesystem::path target_, temporary_;
    int fd_ = -1;
};

/// The whole of a small text file at once.
void write_text_file(const std::filesystem::path& target, std::string_view text);

/// Removes the temporaries of all open AtomicFiles; async-signal-safe, for signal handlers only.
void discard_open_atomic_files() noexcept;

} // namespace atrium
