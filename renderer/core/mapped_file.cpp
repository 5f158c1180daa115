#include "renderer/core/mapped_file.hpp"

#include "renderer/core/error.hpp"

#include <cerrno>
#include <string>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

namespace atrium {
namespace {

[[noreturn]] void fail(const std::filesystem::path& file, const std::string& why, const std::string& next)
{
    throw Error(ExitCode::input, fmt::format("cannot read \"{}\"", file.string()), file.string(), why, next);
}

[[noreturn]] void fail(const std::filesystem::path& file, int error)
{
    fail(file, std::generic_category().message(error),
         error == ENOENT ? "mend the path" : "check the file and its permissions");
}

} // namespace

MappedFile::MappedFile(const std::filesystem::path& file)
{
    // Without O_NONBLOCK, opening a named pipe would wait for a writer.
    const int fd = ::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (fd < 0) fail(file, errno);

    struct stat status {};
    if (::fstat(fd, &status) != 0) {
        const int error = errno;
        ::close(fd);
        fail(file, error);
    }
    if (!S_ISREG(status.st_mode)) {
        ::close(fd);
        fail(file, S_ISDIR(status.st_mode) ? "it is a folder" : "it is not a regular file", "name a file");
    }
    size_ = static_cast<std::size_t>(status.st_size);
    void* data = size_ == 0 ? nullptr : ::mmap(nullptr, size_, PROT_READ, MAP_PRIVATE, fd, 0);
    const int error = errno;
    ::close(fd);
    if (data == MAP_FAILED) {
        size_ = 0;
        fail(file, error);
    }
    data_ = static_cast<const std::byte*>(data);
}

MappedFile::~MappedFile()
{
    if (data_ != nullptr) ::munmap(const_cast<std::byte*>(data_), size_);
}

MappedFile::MappedFile(MappedFile&& other) noexcept
    : data_(std::exchange(other.data_, nullptr)), size_(std::exchange(other.size_, 0))
{}

MappedFile& MappedFile::operator=(MappedFile&& other) noexcept
{
    std::swap(data_, other.data_);
    std::swap(size_, other.size_);
    return *this;
}

} // namespace atrium
