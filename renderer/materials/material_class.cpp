#include "renderer/materials/material_class.hpp"

#include <stdexcept>

namespace atrium {

int draw_rank(MaterialClass cls)
{
    for (std::size_t i = 0; i < material_classes.size(); ++i) {
        if (material_classes[i].cls == cls) return static_cast<int>(i);
    }
    throw std::logic_error("a material class is missing from the table");
}

const MaterialClassInfo& class_info(MaterialClass cls)
{
    return material_classes[static_cast<std::size_t>(draw_rank(cls))];
}

std::string class_fragment(const std::string& pass, const MaterialClassInfo& info)
{
    return pass + "_" + info.surface + ".frag";
}

} // namespace atrium
