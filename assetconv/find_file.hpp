#pragma once
// Files that OBJ and MTL name, looked for with the forgiveness that names written on other systems need.

#include "renderer/core/input_record.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace atrium {

/// Where names in `file` are looked for: the folder that its path says, then those of the links behind that path, the
/// last of which is the real file's own.
[[nodiscard]] std::vector<std::filesystem::path> folders_of(const std::filesystem::path& file);

/// Looks for `name` (with / between folders; `..` allowed, an absolute path counts as its last part) from `folders`, in
/// their order: as written, then without regard to case, then its last part beside, then that with other image endings
/// (png tga jpg jpeg dds) when `any_image_ending`. Regular files only. Every path tried is put into `tried`; what
/// another file in these folders could change is put into `inputs`.
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
