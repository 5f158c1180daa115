#include "assetconv/courtyard/courtyard.hpp"

#include "assetconv/courtyard/court.hpp"
#include "assetconv/courtyard/materials.hpp"
#include "assetconv/courtyard/obj_text.hpp"
#include "assetconv/courtyard/scene_text.hpp"
#include "assetconv/courtyard/textures/textures.hpp"
#include "renderer/core/atomic_file.hpp"
#include "renderer/core/error.hpp"

#include <fmt/format.h>

#include <system_error>

namespace atrium {

void write_courtyard(const CourtyardOptions& options)
{
    const std::filesystem::path textures = options.folder / "textures";
    std::error_code error;
    std::filesystem::create_directories(textures, error);
    if (error) {
        throw Error(ExitCode::environment, fmt::format("cannot make the folder \"{}\"", textures.string()),
                    textures.string(), error.message(), "name a folder that you may write to");
    }
    courtyard::write_textures(textures, options.seed, options.detail);
    courtyard::Court court;
    court.fine = courtyard::fineness(options.detail);
    court.seed = options.seed;
    courtyard::build_all(court);
    write_text_file(options.folder / "courtyard.obj", courtyard::obj_text(court.model));
    write_text_file(options.folder / "courtyard.mtl", courtyard::mtl_text());
    write_text_file(options.folder / "courtyard.toml", courtyard::scene_text());
}

} // namespace atrium
