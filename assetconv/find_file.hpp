#pragma once
// Files that OBJ and MTL name, looked for with the forgiveness that names written on other systems need.

#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

namespace atrium {

/// Looks for `name` (with / between folders; `..` allowed, an absolute path counts as its last part) from `folder`:
/// as written, then without regard to case, then its last part beside, then that with other image endings
/// (png tga jpg jpeg dds) when `any_image_ending`. Regular files only. Every path tried is put into `tried`.
[[nodiscard]] std::optional<std::filesystem::path> find_file(const std::filesystem::path& folder, std::string_view name,
                                                             bool any_image_ending,
                                                             std::vector<std::filesystem::path>* tried = nullptr);

/// The files of one mtllib line, whose names may hold blanks: the longest run of words that names a file counts as one.
/// Names of missing files are returned in `missing`.
[[nodiscard]] std::vector<std::filesystem::path>
find_libraries(const std::filesystem::path& folder, std::string_view names, std::vector<std::string>& missing);

} // namespace atrium
