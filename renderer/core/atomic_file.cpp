#include "renderer/core/atomic_file.hpp"

#include "renderer/core/error.hpp"

#include <array>
#include <atomic>
#include <cerrno>
#include <climits>
#include <cstring>
#include <random>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

namespace atrium {
namespace {

// Temporaries that a signal handler has to unlink. Lock-free and fixed in size, because a handler may neither wait nor
// allocate. A slot is free, being filled in (the handler skips it), or armed.
enum SlotState : int { slot_free, slot_filling, slot_armed };
struct Slot {
    std::atomic<int> state{slot_free};
    std::array<char, PATH_MAX> path{};
};
static_assert(std::atomic<int>::is_always_lock_free);
std::array<Slot, 64> g_slots;

/// More files open at once than slots is no failure: only a signal's clean-up would miss the surplus.
void arm(const std::string& path)
{
    if (path.size() >= PATH_MAX) return; // the open that follows fails with the system's reason
    for (Slot& slot : g_slots) {
        int expected = slot_free;
        if (!slot.state.compare_exchange_strong(expected, slot_filling)) continue;
        std::memcpy(slot.path.data(), path.c_str(), path.size() + 1);
        slot.state.store(slot_armed);
        return;
    }
}

void disarm(const std::string& path)
{
    for (Slot& slot : g_slots) {
        if (slot.state.load() == slot_armed && path == slot.path.data()) {
            slot.state.store(slot_free);
            return;
        }
    }
}

std::string advice(int error)
{
    switch (error) {
    case ENOSPC:
    case EDQUOT:
        return "free some space or choose another place";
    case EACCES:
    case EPERM:
    case EROFS:
        return "choose a folder that you may write to";
    case ENOENT:
    case ENOTDIR:
        return "create the folder first, or mend the path";
    case EISDIR:
        return "name a file, not a folder";
    default:
        return "choose another place for the output";
    }
}

[[noreturn]] void fail(const std::filesystem::path& target, int error)
{
    throw Error(ExitCode::environment, fmt::format("cannot write \"{}\"", target.string()), target.string(),
                std::generic_category().message(error), advice(error));
}

void write_all(int fd, const std::filesystem::path& target, const char* data, std::size_t size)
{
    while (size > 0) {
        const ssize_t n = ::write(fd, data, size);
        if (n < 0 && errno == EINTR) continue;
        if (n <= 0) fail(target, n < 0 ? errno : ENOSPC);
        data += n;
        size -= static_cast<std::size_t>(n);
    }
}

/// A device or pipe must not be replaced by a file: its bytes are gathered in a temporary and then sent to it.
bool is_device(const std::filesystem::path& target)
{
    std::error_code ignored;
    const auto status = std::filesystem::status(target, ignored);
    return std::filesystem::exists(status) && !std::filesystem::is_regular_file(status);
}

void send(const std::filesystem::path& from, const std::filesystem::path& device)
{
    const int in = ::open(from.c_str(), O_RDONLY | O_CLOEXEC);
    if (in < 0) fail(device, errno);
    const int out = ::open(device.c_str(), O_WRONLY | O_CLOEXEC);
    const int open_error = errno;
    try {
        if (out < 0) fail(device, open_error);
        std::array<char, 1 << 16> block{};
        for (ssize_t n = 0; (n = ::read(in, block.data(), block.size())) != 0;) {
            if (n < 0) fail(device, errno);
            write_all(out, device, block.data(), static_cast<std::size_t>(n));
        }
    } catch (...) {
        ::close(in);
        if (out >= 0) ::close(out);
        throw;
    }
    ::close(in);
    if (::close(out) != 0) fail(device, errno);
}

std::string random_name()
{
    std::random_device random;
    return fmt::format(".atrium-{:08x}{:08x}", random(), random());
}

} // namespace

AtomicFile::AtomicFile(std::filesystem::path target) : target_(std::move(target))
{
    std::error_code ignored;
    if (target_.empty()) fail(target_, ENOENT);
    if (std::filesystem::is_directory(target_, ignored)) fail(target_, EISDIR);

    std::filesystem::path folder;
    if (is_device(target_)) {
        folder = std::filesystem::temp_directory_path();
    } else {
        // Through a symbolic link to the file it names, as a plain write would go.
        if (std::filesystem::is_symlink(target_, ignored)) target_ = std::filesystem::weakly_canonical(target_);
        // Absolute, so that a change of the working folder cannot lead a clean-up astray.
        folder = std::filesystem::absolute(target_).parent_path();
    }
    do {
        temporary_ = folder / random_name();
        arm(temporary_.string());
        fd_ = ::open(temporary_.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (fd_ < 0) {
            const int error = errno;
            disarm(temporary_.string());
            if (error != EEXIST && error != EINTR) fail(target_, error);
        }
    } while (fd_ < 0);
}

AtomicFile::~AtomicFile()
{
    if (fd_ >= 0) ::close(fd_);
    if (temporary_.empty()) return;
    ::unlink(temporary_.c_str());
    disarm(temporary_.string());
}

void AtomicFile::write(std::span<const std::byte> bytes)
{
    write_all(fd_, target_, reinterpret_cast<const char*>(bytes.data()), bytes.size());
}

void AtomicFile::write(std::string_view text)
{
    write_all(fd_, target_, text.data(), text.size());
}

void AtomicFile::write_at(std::uint64_t offset, std::span<const std::byte> bytes)
{
    while (!bytes.empty()) {
        const ssize_t n = ::pwrite(fd_, bytes.data(), bytes.size(), static_cast<off_t>(offset));
        if (n < 0 && errno == EINTR) continue;
        if (n <= 0) fail(target_, n < 0 ? errno : ENOSPC);
        bytes = bytes.subspan(static_cast<std::size_t>(n));
        offset += static_cast<std::uint64_t>(n);
    }
}

void AtomicFile::commit()
{
    // Some file systems report a full disk only when the file is closed.
    if (::close(std::exchange(fd_, -1)) != 0) fail(target_, errno);
    if (is_device(target_)) {
        send(temporary_, target_);
        ::unlink(temporary_.c_str());
    } else if (::rename(temporary_.c_str(), target_.c_str()) != 0) {
        fail(target_, errno);
    }
    disarm(temporary_.string());
    temporary_.clear();
}

void write_text_file(const std::filesystem::path& target, std::string_view text)
{
    AtomicFile file(target);
    file.write(text);
    file.commit();
}

void discard_open_atomic_files() noexcept
{
    for (Slot& slot : g_slots) {
        if (slot.state.load() == slot_armed) ::unlink(slot.path.data());
    }
}

} // namespace atrium
