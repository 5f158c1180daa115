#include "assetconv/warnings.hpp"

#include "renderer/core/error.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

namespace atrium {
namespace {

constexpr std::array kinds{
    WarningKind{"texture-missing", "texture not found, so a neutral value is used",
                "put the file there or mend the MTL", true},
    WarningKind{"texture-unreadable", "texture could not be read, so a neutral value is used",
                "open the file in an image program and save it again", true},
    WarningKind{"mtl-missing", "material library not found, so its materials are unknown",
                "put the file beside the OBJ or mend its mtllib line", true},
    WarningKind{"material-undefined", "material not defined in any MTL, so grey is used",
                "define it in the MTL or mend the usemtl line", true},
    WarningKind{"material-duplicate", "material defined twice, so the last definition is used", "remove one of them",
                false},
    WarningKind{"mtl-unknown-keyword", "unknown MTL keyword, ignored", "mend its spelling if it was meant", false},
    WarningKind{"mtl-ignored-keyword", "MTL keyword without an effect here", "nothing, unless you miss it", false},
    WarningKind{"mtl-bad-value", "MTL value missing or not a number, so the line is ignored", "mend the line", false},
    WarningKind{"mtl-invisible", "material fully transparent without a mask, so it is taken as opaque",
                "write `d 1` into the MTL", false},
    WarningKind{"map-transform", "maps of one material have different -s or -o, so the first one's are used",
                "give all maps of the material the same options", false},
    WarningKind{"bump-colour", "bump map is a coloured picture, so its brightness is taken as height",
                "name a height or normal map", false},
    WarningKind{"face-bad-index", "face names a vertex that does not exist, dropped", "mend or export again", false},
    WarningKind{"face-too-few-corners", "face with fewer than three corners, dropped", "mend or export again", false},
    WarningKind{"face-degenerate", "triangle without area, dropped", "nothing, unless a hole shows", false},
    WarningKind{"face-duplicate", "triangle given twice, the second dropped", "nothing", false},
    WarningKind{"winding-turned", "triangle wound against its normals in a mesh of mixed winding, turned", "nothing",
                false},
    WarningKind{"polygon-not-simple", "polygon crosses itself, so part of it is filled by guess",
                "triangulate it in the modelling program", false},
    WarningKind{"polygon-too-large", "polygon with too many corners, dropped",
                "triangulate it in the modelling program", false},
    WarningKind{"number-bad", "not a finite number, so faces that use it are dropped", "mend or export again", false},
    WarningKind{"uv-bad", "texture coordinate not a finite number, so 0 is used", "mend or export again", false},
    WarningKind{"normal-bad", "normal without a direction, so one is computed", "nothing", false},
    WarningKind{"obj-ignored-statement", "statement without an effect here (lines, points, curves)", "nothing", false},
    WarningKind{"obj-unknown-statement", "unknown OBJ statement, ignored", "mend its spelling if it was meant", false},
};

const WarningKind& find_kind(std::string_view name)
{
    const auto found = std::find_if(kinds.begin(), kinds.end(), [&](const WarningKind& k) { return k.name == name; });
    if (found == kinds.end()) throw std::logic_error("warning of an unlisted kind: " + std::string(name));
    return *found;
}

} // namespace

std::span<const WarningKind> warning_kinds()
{
    return kinds;
}

void Warnings::add(std::string_view kind, const std::string& where, std::uint64_t count)
{
    const WarningKind& k = find_kind(kind);
    if (strict_ && k.strict) throw Error(ExitCode::input, k.meaning, where, "--strict refuses this", k.next);
    const auto known = std::find_if(list_.begin(), list_.end(), [&](const BakeWarning& w) { return w.kind == kind; });
    if (known != list_.end())
        known->count += count;
    else
        list_.push_back({std::string(kind), count, where});
}

void Warnings::merge(const Warnings& other)
{
    for (const BakeWarning& w : other.list_) add(w.kind, w.first, w.count);
}

std::uint64_t Warnings::count(std::string_view kind) const
{
    const auto known = std::find_if(list_.begin(), list_.end(), [&](const BakeWarning& w) { return w.kind == kind; });
    return known == list_.end() ? 0 : known->count;
}

} // namespace atrium
