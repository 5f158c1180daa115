#include "assetconv/mtl.hpp"

#include "assetconv/obj.hpp"
#include "assetconv/text_lines.hpp"
#include "renderer/core/error.hpp"
#include "renderer/core/mapped_file.hpp"

#include <tiny_obj_loader.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <sstream>
#include <unordered_map>

namespace atrium {
namespace {

/// The case that tinyobjloader wants for keywords whose value it reads; MTL keywords know no case.
const std::map<std::string_view, std::string_view> value_keywords{
    {"ka", "Ka"}, {"kd", "Kd"}, {"ks", "Ks"}, {"ke", "Ke"},       {"tf", "Tf"}, {"kt", "Tf"}, {"ns", "Ns"},
    {"ni", "Ni"}, {"d", "d"},   {"tr", "Tr"}, {"illum", "illum"}, {"pr", "Pr"}, {"pm", "Pm"}};

const std::map<std::string_view, MapKind> map_keywords{
    {"map_kd", MapKind::diffuse},        {"map_ka", MapKind::ambient},   {"map_ks", MapKind::specular},
    {"map_ns", MapKind::shininess},      {"map_d", MapKind::alpha},      {"map_ke", MapKind::emission},
    {"map_pr", MapKind::roughness},      {"map_pm", MapKind::metallic},  {"norm", MapKind::normal},
    {"map_norm", MapKind::normal},       {"map_bump", MapKind::bump},    {"bump", MapKind::bump},
    {"map_disp", MapKind::displacement}, {"disp", MapKind::displacement}};

const std::set<std::string_view> ignored_keywords{
    "refl",   "map_refl", "decal",   "map_decal", "map_aat", "sharpness", "ps",         "pc",     "pcr",
    "map_ps", "map_pc",   "map_pcr", "aniso",     "anisor",  "map_aniso", "map_anisor", "map_tr", "map_tf"};

bool is_number(std::string_view word)
{
    const std::string text(word);
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    return !text.empty() && *end == '\0' && std::isfinite(static_cast<float>(value));
}

/// Value lines of one material, in tinyobjloader's form; the last of each keyword wins.
using ValueLines = std::map<std::string_view, std::string>;

class MtlReader {
public:
    MtlReader(const std::filesystem::path& file, std::vector<MtlMaterial>& materials, Warnings& warnings)
        : file_(file), materials_(materials), warnings_(warnings)
    {
        for (std::size_t i = 0; i < materials.size(); ++i) index_.emplace(materials[i].name, i);
    }

    void run()
    {
        const MappedFile mapped(file_);
        TextLines lines(mapped.bytes());
        while (lines.next()) {
            line_ = lines.number();
            read_line(lines.text());
        }
        finish();
    }

private:
    void read_line(std::string_view rest)
    {
        const std::string_view written = take_word(rest);
        const std::string keyword = lower_case(written);
        if (keyword == "newmtl") return begin(rest);
        if (!open_) return; // before the first newmtl nothing has an owner
        if (const auto value = value_keywords.find(keyword); value != value_keywords.end()) {
            read_value(value->second, rest);
        } else if (const auto map = map_keywords.find(keyword); map != map_keywords.end()) {
            read_map(map->second, written, rest);
        } else {
            warnings_.add(ignored_keywords.contains(keyword) ? "mtl-ignored-keyword" : "mtl-unknown-keyword",
                          here(written.substr(0, 32)));
        }
    }

    void begin(std::string_view name)
    {
        finish();
        open_ = true;
        material_ = {};
        values_.clear();
        material_.name = std::string(name);
        material_.where = place(file_, line_);
        material_.file = file_;
    }

    /// Checks the numbers and spells them out for tinyobjloader: it would read anything as 0.
    void read_value(std::string_view keyword, std::string_view rest)
    {
        const bool colour = keyword[0] == 'K' || keyword == "Tf";
        std::vector<std::string_view> words;
        while (!rest.empty() && rest.front() != '#') words.push_back(take_word(rest));
        if (keyword == "d" && !words.empty() && words[0] == "-halo") words.erase(words.begin());
        words.resize(std::min<std::size_t>(words.size(), colour ? 3 : 1));
        if (words.empty() || !std::all_of(words.begin(), words.end(), is_number))
            return warnings_.add("mtl-bad-value", here(keyword));
        while (colour && words.size() < 3) words.push_back(words[0]); // one value is a grey
        std::string line(keyword);
        for (const std::string_view word : words) line.append(" ").append(word);
        values_[keyword] = line;
    }

    void read_map(MapKind kind, std::string_view keyword, std::string_view rest)
    {
        std::optional<MapReference> map = parse_map(rest);
        if (!map) return warnings_.add("mtl-bad-value", here(keyword));
        map->where = here(keyword);
        material_.maps[static_cast<std::size_t>(kind)] = std::move(map);
    }

    void finish()
    {
        if (!open_) return;
        read_values();
        const auto [at, added] = index_.try_emplace(material_.name, materials_.size());
        if (added) {
            materials_.push_back(std::move(material_));
        } else {
            warnings_.add("material-duplicate", material_.where + ", \"" + material_.name + "\"");
            materials_[at->second] = std::move(material_);
        }
        open_ = false;
    }

    /// Lets tinyobjloader read the values of one material.
    void read_values()
    {
        std::string text = "newmtl m\n";
        for (const auto& [keyword, line] : values_) text += line + "\n";
        std::istringstream stream(text);
        std::map<std::string, int> index;
        std::vector<tinyobj::material_t> read;
        std::string warning, error;
        tinyobj::LoadMtl(&index, &read, &stream, &warning, &error);
        const tinyobj::material_t& m = read.at(0);
        const auto given = [&](std::string_view keyword) { return values_.contains(keyword); };
        const auto colour = [&](std::string_view keyword, const float* c, std::optional<vec3>& out) {
            if (given(keyword)) out = vec3(c[0], c[1], c[2]);
        };
        const auto scalar = [&](std::string_view keyword, float value, std::optional<float>& out) {
            if (given(keyword)) out = value;
        };
        colour("Kd", m.diffuse, material_.kd);
        colour("Ka", m.ambient, material_.ka);
        colour("Ks", m.specular, material_.ks);
        colour("Ke", m.emission, material_.ke);
        colour("Tf", m.transmittance, material_.tf);
        scalar("Ns", m.shininess, material_.ns);
        scalar("Ni", m.ior, material_.ni);
        scalar("d", m.dissolve, material_.d);
        if (!given("d")) scalar("Tr", 1 - m.dissolve, material_.tr); // tinyobjloader keeps 1 - Tr, and d wins
        scalar("Pr", m.roughness, material_.pr);
        scalar("Pm", m.metallic, material_.pm);
        if (given("illum")) material_.illum = m.illum;
    }

    [[nodiscard]] std::string here(std::string_view keyword) const
    {
        return place(file_, line_) + ", " + std::string(keyword) + " of material \"" + material_.name + "\"";
    }

    std::filesystem::path file_;
    std::vector<MtlMaterial>& materials_;
    Warnings& warnings_;
    std::unordered_map<std::string, std::size_t> index_; ///< of names in materials_
    MtlMaterial material_;
    ValueLines values_;
    std::uint32_t line_ = 0;
    bool open_ = false;
};

/// Up to `most` numbers; stops at the first word that is not wholly one ("2.png" is a file).
std::vector<float> take_numbers(std::string_view& rest, std::size_t most)
{
    std::vector<float> numbers;
    while (numbers.size() < most) {
        std::string_view after = rest;
        const std::string_view word = take_word(after);
        if (!is_number(word)) break;
        numbers.push_back(std::strtof(std::string(word).c_str(), nullptr));
        rest = after;
    }
    return numbers;
}

vec2 first_two(const std::vector<float>& numbers, const vec2& otherwise)
{
    return {numbers.empty() ? otherwise.x : numbers[0], numbers.size() < 2 ? otherwise.y : numbers[1]};
}

/// Reads one option whose name is already taken; false when it is no option at all.
bool read_option(std::string_view name, std::string_view& rest, MapReference& map)
{
    const auto one = [&](float otherwise) {
        const std::vector<float> n = take_numbers(rest, 1);
        return n.empty() ? otherwise : n[0];
    };
    if (name == "-s")
        map.scale = first_two(take_numbers(rest, 3), vec2(1));
    else if (name == "-o")
        map.offset = first_two(take_numbers(rest, 3), vec2(0));
    else if (name == "-t")
        take_numbers(rest, 3);
    else if (name == "-bm")
        map.bump = one(1);
    else if (name == "-boost" || name == "-texres")
        one(0);
    else if (name == "-mm") {
        const vec2 mm = first_two(take_numbers(rest, 2), vec2(0, 1));
        map.base = mm.x;
        map.gain = mm.y;
    } else if (name == "-clamp")
        map.clamp = lower_case(take_word(rest)) == "on";
    else if (name == "-imfchan") {
        const std::string_view word = take_word(rest);
        map.channel = word.empty() ? '\0' : word[0];
    } else if (name == "-blendu" || name == "-blendv" || name == "-cc" || name == "-type" || name == "-colorspace") {
        (void)take_word(rest);
    } else
        return false;
    return true;
}

} // namespace

std::optional<MapReference> parse_map(std::string_view text)
{
    MapReference map;
    std::string_view rest = trimmed(text);
    while (rest.starts_with('-')) {
        std::string_view after = rest;
        const std::string name = lower_case(take_word(after));
        if (!read_option(name, after, map)) break; // a file name that begins with a minus
        rest = after;
    }
    if (rest.size() >= 2 && rest.front() == '"' && rest.back() == '"') rest = trimmed(rest.substr(1, rest.size() - 2));
    if (rest.empty()) return std::nullopt;
    map.file = std::string(rest);
    std::replace(map.file.begin(), map.file.end(), '\\', '/');
    return map;
}

void read_mtl(const std::filesystem::path& file, std::vector<MtlMaterial>& materials, Warnings& warnings)
{
    MtlReader(file, materials, warnings).run();
}

} // namespace atrium
