#pragma once
// A read-only, private mapping of a whole file.

#include <cstddef>
#include <filesystem>
#include <span>

namespace atrium {

class MappedFile {
public:
    MappedFile() = default;
    /// Throws Error(input) when the file is missing, not a regular file, or unreadable. An empty file maps to an
    /// empty span.
    explicit MappedFile(const std::filesystem::path& file);
    ~MappedFile();
    MappedFile(MappedFile&& other) noexcept;
    MappedFile& operator=(MappedFile&& other) noexcept;

    [[nodiscard]] std::span<const std::byte> bytes() const { return {data_, size_}; }

private:
    const std::byte* data_ = nullptr;
    std::size_t size_ = 0;
};

} // namespace atrium
