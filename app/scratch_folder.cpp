#include "app/scratch_folder.hpp"

#include "renderer/core/error.hpp"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <system_error>

namespace atrium::app {

ScratchFolder::ScratchFolder()
{
    std::string name = (std::filesystem::temp_directory_path() / "atrium-XXXXXX").string();
    if (!mkdtemp(name.data())) {
        throw Error(ExitCode::environment, "no folder for temporary files", name, std::strerror(errno),
                    "make room there, or set TMPDIR");
    }
    path_ = name;
}

ScratchFolder::~ScratchFolder()
{
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

std::string read_text(const std::filesystem::path& file)
{
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

} // namespace atrium::app
