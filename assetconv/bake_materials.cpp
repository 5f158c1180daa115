#include "assetconv/bake_materials.hpp"

#include "assetconv/find_file.hpp"
#include "renderer/core/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>
#include <unordered_map>

namespace atrium {
namespace {

namespace fs = std::filesystem;

std::vector<MtlMaterial> read_libraries(const ObjFile& obj, Warnings& warnings, InputRecord& inputs)
{
    std::vector<MtlMaterial> materials;
    std::vector<fs::path> seen;
    for (const ObjName& library : obj.libraries) {
        std::vector<std::string> missing;
        for (const fs::path& file : find_libraries(folders_of(obj.path), library.name, missing, inputs)) {
            if (std::find(seen.begin(), seen.end(), file) != seen.end()) continue;
            seen.push_back(file);
            inputs.add_file(file);
            read_mtl(file, materials, warnings);
        }
        for (const std::string& name : missing)
            warnings.add("mtl-missing", place(obj.path, library.line) + ", mtllib \"" + name + "\"");
    }
    return materials;
}

/// Maps the OBJ's names to the MTL's materials; appends the default where one is missing. Fills `used`.
void assign(const ObjFile& obj, const std::vector<MtlMaterial>& mtl, MaterialSet& set, std::vector<bool>& used,
            Warnings& warnings)
{
    std::unordered_map<std::string, std::uint32_t> index;
    for (std::uint32_t i = 0; i < mtl.size(); ++i) index.emplace(mtl[i].name, i);
    set.default_material = static_cast<std::uint32_t>(mtl.size());
    for (const ObjName& name : obj.materials) {
        const auto found = index.find(name.name);
        set.material_of.push_back(found == index.end() ? set.default_material : found->second);
    }
    used.assign(mtl.size() + 1, false);
    std::vector<bool> warned(obj.materials.size(), false);
    for (const ObjFace& face : obj.faces) {
        const auto named = static_cast<std::size_t>(std::max(face.material, 0));
        const std::uint32_t material = face.material < 0 ? set.default_material : set.material_of[named];
        used[material] = true;
        if (face.material < 0 || material != set.default_material || warned[named]) continue;
        warned[named] = true;
        const ObjName& name = obj.materials[named];
        warnings.add("material-undefined", place(obj.path, name.line) + ", usemtl \"" + name.name + "\"");
    }
}

/// One spelling for each file. ".." is removed only if the folder before it is not a link, where it would lead
/// elsewhere.
fs::path plain_path(const fs::path& file)
{
    const fs::path normal = file.lexically_normal();
    std::error_code failed;
    return fs::equivalent(file, normal, failed) ? normal : file;
}

MapFiles find_maps(const MtlMaterial& mtl, ImageStore& images, Warnings& warnings, InputRecord& inputs)
{
    MapFiles files;
    for (std::size_t k = 0; k < map_kind_count; ++k) {
        const auto kind = static_cast<MapKind>(k);
        const auto& map = mtl.map(kind);
        if (!map || !is_map_wanted(mtl, kind)) continue;
        std::vector<fs::path> tried;
        const auto file = find_file(folders_of(mtl.file), map->file, true, inputs, &tried);
        if (!file) {
            std::string why = map->where + ": \"" + map->file + "\"";
            for (const fs::path& path : tried) why += (&path == &tried[0] ? ", tried " : " and ") + path.string();
            warnings.add("texture-missing", why);
            continue;
        }
        inputs.add_file(*file);
        files[k] = ImageKey{plain_path(*file), is_color_map(kind)};
        images.want(*files[k], map->where);
    }
    return files;
}

NormalVerdicts judge(const std::vector<MapFiles>& files, const ImageStore& images, NormalY option)
{
    std::vector<NormalQuestion> questions;
    const auto at = [](const MapFiles& f, MapKind kind) { return f[static_cast<std::size_t>(kind)]; };
    for (const MapFiles& f : files) {
        for (const MapKind kind : {MapKind::normal, MapKind::bump, MapKind::displacement}) {
            const auto map = at(f, kind);
            if (!map || images.find(*map) == nullptr) continue;
            questions.push_back({*map, at(f, MapKind::diffuse), kind == MapKind::normal});
            break;
        }
    }
    // The same map once; one that any material calls a normal map first.
    std::stable_sort(questions.begin(), questions.end(), [](const NormalQuestion& a, const NormalQuestion& b) {
        return a.image != b.image ? a.image < b.image : a.surely_normals > b.surely_normals;
    });
    const auto same = [](const NormalQuestion& a, const NormalQuestion& b) { return a.image == b.image; };
    questions.erase(std::unique(questions.begin(), questions.end(), same), questions.end());
    return judge_normal_maps(questions, images, option);
}

} // namespace

MaterialSet read_materials(const ObjFile& obj, const BakeOptions& options, Warnings& warnings, InputRecord& inputs)
{
    MaterialSet set;
    const std::vector<MtlMaterial> mtl = read_libraries(obj, warnings, inputs);
    std::vector<bool> used;
    assign(obj, mtl, set, used, warnings);
    std::vector<MapFiles> files(mtl.size());
    for (std::size_t i = 0; i < mtl.size(); ++i) {
        if (used[i]) files[i] = find_maps(mtl[i], set.images, warnings, inputs);
    }
    set.images.load(warnings);
    const NormalVerdicts verdicts = judge(files, set.images, options.normal_y);
    for (std::size_t i = 0; i < mtl.size(); ++i) {
        set.plans.push_back(plan_material(mtl[i], files[i], set.images, verdicts, warnings));
    }
    if (used.back()) {
        set.plans.emplace_back();
        set.plans.back().material = default_material();
    }
    for (MaterialPlan& plan : set.plans) {
        if (options.two_sided != TwoSided::automatic) plan.material.two_sided = options.two_sided == TwoSided::on;
    }
    return set;
}

} // namespace atrium
