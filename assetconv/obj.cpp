#include "assetconv/obj.hpp"

#include "assetconv/text_lines.hpp"
#include "renderer/core/error.hpp"
#include "renderer/core/mapped_file.hpp"

#include <tiny_obj_loader.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <istream>
#include <limits>
#include <streambuf>
#include <unordered_map>

namespace atrium {
namespace {

/// Squares and products of anything smaller stay finite in 32 bits.
constexpr float largest_number = 1e12f;

constexpr std::array<std::string_view, 24> ignored_statements{
    "l",    "p",    "vp", "cstype", "deg", "bmat", "step",  "curv",     "curv2",    "surf", "parm",       "trim",
    "hole", "scrv", "sp", "end",    "con", "mg",   "bevel", "c_interp", "d_interp", "lod",  "shadow_obj", "vw"};

/// Which data a line holds that tinyobjloader's callbacks cannot tell.
struct LineFacts {
    std::uint32_t number = 0;
    bool bad_number = false; ///< letters where a number should stand (nan, 1.#QNAN): tinyobjloader would read 0 or 1
    bool bad_index = false;  ///< of a face: 0 or far too large
};

bool has_letters(std::string_view numbers)
{
    return std::any_of(numbers.begin(), numbers.end(), [](char c) {
        const bool number = (c >= '0' && c <= '9') || c == '.' || c == '-' || c == '+' || c == 'e' || c == 'E';
        return !number && c != ' ' && c != '\t';
    });
}

/// More digits than any index that a file of 4 GiB can mean: tinyobjloader would wrap it into range.
constexpr std::size_t longest_index = 9;

/// True for an index written as 0 ("/0", " 0"), which the callback cannot tell from none, or with too many digits.
bool has_bad_index(std::string_view corners)
{
    constexpr std::string_view digits = "0123456789";
    std::size_t at = corners.find_first_of(digits);
    while (at != std::string_view::npos) {
        const std::size_t end = std::min(corners.find_first_not_of(digits, at), corners.size());
        const std::string_view index = corners.substr(at, end - at);
        if (index.size() > longest_index || index.find_first_not_of('0') == std::string_view::npos) return true;
        at = corners.find_first_of(digits, end);
    }
    return false;
}

/// Cuts a comment after data. A '#' inside a word is none: some writers put 1.#QNAN for a number.
std::string_view without_comment(std::string_view text)
{
    for (std::size_t i = text.find('#'); i != std::string_view::npos; i = text.find('#', i + 1)) {
        if (i == 0 || text[i - 1] == ' ' || text[i - 1] == '\t') return trimmed(text.substr(0, i));
    }
    return text;
}

/// Hands tinyobjloader one plain line at a time, so that a callback always knows the line it comes from. What
/// tinyobjloader has no callback for (s, mtllib, unknown statements) is taken out here.
class ObjLines : public std::streambuf {
public:
    ObjLines(std::span<const std::byte> bytes, ObjFile& file, Warnings& warnings)
        : lines_(bytes), file_(file), warnings_(warnings)
    {}
    [[nodiscard]] const LineFacts& facts() const { return facts_; }
    [[nodiscard]] std::uint32_t smoothing() const { return smoothing_; }

protected:
    int_type underflow() override
    {
        while (lines_.next()) {
            if (!rewrite(lines_.text())) continue;
            buffer_.push_back('\n');
            setg(buffer_.data(), buffer_.data(), buffer_.data() + buffer_.size());
            return traits_type::to_int_type(buffer_.front());
        }
        return traits_type::eof();
    }

private:
    /// Fills buffer_ with the plain form; false when the line is not for tinyobjloader.
    bool rewrite(std::string_view rest)
    {
        const std::string_view keyword = take_word(rest);
        facts_ = {.number = lines_.number()};
        const bool numbers = keyword == "v" || keyword == "vt" || keyword == "vn";
        if (numbers || keyword == "f" || keyword == "s") rest = without_comment(rest);
        if (numbers)
            facts_.bad_number = has_letters(rest);
        else if (keyword == "f")
            facts_.bad_index = has_bad_index(rest);
        else if (keyword == "s")
            return take_smoothing(rest);
        else if (keyword == "mtllib")
            return take_library(rest);
        else if (keyword != "g" && keyword != "o" && keyword != "usemtl")
            return take_other(keyword);
        buffer_.assign(keyword).push_back(' ');
        buffer_.append(rest);
        std::replace(buffer_.begin(), buffer_.end(), '\0', ' ');
        return true;
    }
    bool take_smoothing(std::string_view rest)
    {
        smoothing_ = 0;
        std::from_chars(rest.data(), rest.data() + rest.size(), smoothing_);
        if (smoothing_ == smoothing_unset) smoothing_ = 0;
        return false;
    }
    bool take_library(std::string_view rest)
    {
        file_.libraries.push_back({std::string(rest), lines_.number()});
        return false;
    }
    bool take_other(std::string_view keyword)
    {
        const bool known =
            std::find(ignored_statements.begin(), ignored_statements.end(), keyword) != ignored_statements.end();
        warnings_.add(known ? "obj-ignored-statement" : "obj-unknown-statement",
                      place(file_.path, lines_.number()) + ", \"" + std::string(keyword.substr(0, 32)) + "\"");
        return false;
    }

    TextLines lines_;
    ObjFile& file_;
    Warnings& warnings_;
    std::string buffer_;
    LineFacts facts_;
    std::uint32_t smoothing_ = smoothing_unset;
};

/// Receives tinyobjloader's callbacks.
class ObjBuilder {
public:
    ObjBuilder(ObjFile& file, const ObjLines& lines, Warnings& warnings)
        : file_(file), lines_(lines), warnings_(warnings)
    {}

    void vertex(const vec3& p)
    {
        const bool good = number_is_good(p.x, p.y, p.z);
        if (!good) warnings_.add("number-bad", here());
        file_.positions.push_back(good ? p : vec3(std::numeric_limits<float>::quiet_NaN()));
    }
    void normal(const vec3& n)
    {
        file_.normals.push_back(number_is_good(n.x, n.y, n.z) ? n : vec3(0)); // zero: one is computed later
    }
    void uv(const vec2& t)
    {
        const bool good = number_is_good(t.x, t.y, 0);
        if (!good) warnings_.add("uv-bad", here());
        file_.uvs.push_back(good ? t : vec2(0));
    }
    void face(const tinyobj::index_t* raw, int count);
    void material(const char* name) { material_ = find_or_add_material(trimmed(name)); }
    void group(const std::string& name)
    {
        if (name.empty())
            group_ = add_group(object_); // every unnamed group is one of its own
        else
            group_ = find_or_add_group(name);
    }
    void object(const char* name)
    {
        object_ = std::string(trimmed(name));
        group_ = find_or_add_group("");
    }

private:
    using Index = std::unordered_map<std::string, std::int32_t>;

    [[nodiscard]] std::string here() const { return place(file_.path, lines_.facts().number); }
    [[nodiscard]] bool number_is_good(float x, float y, float z) const
    {
        const auto fits = [](float f) { return std::abs(f) < largest_number; }; // false for NaN as well
        return !lines_.facts().bad_number && fits(x) && fits(y) && fits(z);
    }
    std::int32_t find_or_add_material(std::string_view name)
    {
        const auto next = static_cast<std::int32_t>(file_.materials.size());
        const auto [at, added] = material_index_.try_emplace(std::string(name), next);
        if (added) file_.materials.push_back({at->first, lines_.facts().number});
        return at->second;
    }
    /// A group is known by its own name and its object's: two objects may have groups of one name.
    std::int32_t find_or_add_group(const std::string& name)
    {
        const auto next = static_cast<std::int32_t>(file_.groups.size());
        const auto [at, added] = group_index_.try_emplace(object_ + '\n' + name, next);
        return added ? add_group(name.empty() ? object_ : name) : at->second;
    }
    std::int32_t add_group(const std::string& name)
    {
        file_.groups.push_back({name, lines_.facts().number});
        return static_cast<std::int32_t>(file_.groups.size()) - 1;
    }

    ObjFile& file_;
    const ObjLines& lines_;
    Warnings& warnings_;
    Index group_index_, material_index_;
    std::string object_;
    std::int32_t group_ = -1, material_ = -1; ///< -1: no statement yet
};

/// 1-based or negative (relative) to 0-based; -1 for none. False when out of range.
bool resolve(int raw, std::size_t count, bool may_be_absent, std::int32_t& index)
{
    if (raw == 0) {
        index = -1;
        return may_be_absent;
    }
    const std::int64_t i = raw > 0 ? std::int64_t{raw} - 1 : static_cast<std::int64_t>(count) + raw;
    index = static_cast<std::int32_t>(i);
    return i >= 0 && i < static_cast<std::int64_t>(count);
}

void ObjBuilder::face(const tinyobj::index_t* raw, int count)
{
    if (count < 3) return warnings_.add("face-too-few-corners", here());
    if (lines_.facts().bad_index) return warnings_.add("face-bad-index", here());
    const std::size_t first = file_.corners.size();
    for (int i = 0; i < count; ++i) {
        ObjCorner c;
        const bool good = resolve(raw[i].vertex_index, file_.positions.size(), false, c.position) &&
                          resolve(raw[i].texcoord_index, file_.uvs.size(), true, c.uv) &&
                          resolve(raw[i].normal_index, file_.normals.size(), true, c.normal);
        if (!good || std::isnan(file_.positions[static_cast<std::size_t>(c.position)].x)) {
            file_.corners.resize(first);
            if (!good) warnings_.add("face-bad-index", here());
            return;
        }
        file_.corners.push_back(c);
    }
    if (group_ < 0) group("");
    file_.faces.push_back({.first_corner = static_cast<std::uint32_t>(first),
                           .corner_count = static_cast<std::uint32_t>(count),
                           .group = static_cast<std::uint32_t>(group_),
                           .material = material_,
                           .smoothing = lines_.smoothing(),
                           .line = lines_.facts().number});
}

tinyobj::callback_t callbacks()
{
    static constexpr auto of = [](void* user) { return static_cast<ObjBuilder*>(user); };
    tinyobj::callback_t c;
    c.vertex_cb = [](void* user, float x, float y, float z, float) { of(user)->vertex({x, y, z}); };
    c.normal_cb = [](void* user, float x, float y, float z) { of(user)->normal({x, y, z}); };
    c.texcoord_cb = [](void* user, float u, float v, float) { of(user)->uv({u, v}); };
    c.index_cb = [](void* user, tinyobj::index_t* raw, int count) { of(user)->face(raw, count); };
    c.usemtl_cb = [](void* user, const char* name, int) { of(user)->material(name); };
    c.object_cb = [](void* user, const char* name) { of(user)->object(name); };
    c.group_cb = [](void* user, const char** names, int count) {
        std::string joined;
        for (int i = 0; i < count; ++i) joined.append(i > 0 ? " " : "").append(names[i]);
        of(user)->group(joined);
    };
    return c;
}

} // namespace

std::string place(const std::filesystem::path& file, std::uint32_t line)
{
    return file.filename().string() + ":" + std::to_string(line);
}

ObjFile read_obj(const std::filesystem::path& file, Warnings& warnings)
{
    const MappedFile mapped(file);
    if (mapped.bytes().size() > std::numeric_limits<std::uint32_t>::max()) {
        throw Error(ExitCode::input, "OBJ file too large", file.string(), "files above 4 GiB are not read",
                    "split it into several files");
    }
    ObjFile obj;
    obj.path = file;
    ObjLines lines(mapped.bytes(), obj, warnings);
    ObjBuilder builder(obj, lines, warnings);
    std::istream stream(&lines);
    stream.exceptions(std::ios::badbit); // lets what our own code throws pass through the stream
    tinyobj::LoadObjWithCallback(stream, callbacks(), &builder, nullptr, nullptr, nullptr);
    return obj;
}

} // namespace atrium
