#include "assetconv/courtyard/obj_text.hpp"

#include <fmt/format.h>

#include <iterator>

namespace atrium::courtyard {

std::string obj_text(const Model& model)
{
    std::string text = "# Courtyard of Atrium, made by code. Metres, Y up.\nmtllib courtyard.mtl\n";
    auto out = std::back_inserter(text);
    std::size_t first = 1; // OBJ counts from 1
    for (const Part& part : model.parts()) {
        fmt::format_to(out, "g {}\nusemtl {}\n", part.group, part.material);
        for (const Corner& c : part.corners) {
            fmt::format_to(out, "v {:.5f} {:.5f} {:.5f}\n", c.position.x, c.position.y, c.position.z);
        }
        for (const Corner& c : part.corners) {
            fmt::format_to(out, "vt {:.5f} {:.5f}\n", c.uv.x, c.uv.y);
        }
        for (const Corner& c : part.corners) {
            fmt::format_to(out, "vn {:.4f} {:.4f} {:.4f}\n", c.normal.x, c.normal.y, c.normal.z);
        }
        for (std::size_t i = 0; i < part.indices.size(); i += 3) {
            const std::size_t a = first + part.indices[i], b = first + part.indices[i + 1],
                              c = first + part.indices[i + 2];
            fmt::format_to(out, "f {0}/{0}/{0} {1}/{1}/{1} {2}/{2}/{2}\n", a, b, c);
        }
        first += part.corners.size();
    }
    return text;
}

} // namespace atrium::courtyard
