#pragma once
// Files that OBJ and MTL name, looked for with the forgiveness that names written on other systems need.

#include "renderer/core/input_record.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace atrium {

/// Folders in which names in `file` are searched: the folder of its path, then, if that is a symbolic link, the folders
/// of the files it leads to, up to the folder of the real file.
[[nodiscard]] std::vector<std::filesystem::path> folders_of(const std::filesystem::path& file);

/// Searches `name` (with / between folders; `..` allowed, an absolute path counts as its last part) in `folders`, in
/// their order: as written, then without regard to case, then only its last part, then that with other image extensions
/// (png tga jpg jpeg dds) if `any_image_ending`. Regular files only. Every path tried is added to `tried`; `inputs`
/// gets the searches whose result would change if files appear in these folders or are removed.
[[nodiscard]] std::optional<std::filesystem::path> find_file(const std::vector<std::filesystem::path>& folders,
                                                             std::string_view name, bool any_image_ending,
                                                             InputRecord& inputs,
                                                             std::vector<std::filesystem::path>* tried = nullptr);

/// The files of one mtllib line, whose names may hold blanks: the longest run of words that names a file counts as one.
/// Names of missing files are returned in `missing`.
[[nodiscard]] std::vector<std::filesystem::path> find_libraries(const std::vector<std::filesystem::path>& folders,
                                                                std::string_view names,
                                                                std::vector<std::string>& missing, InputRecord& inputs);

} // namespace atrium
