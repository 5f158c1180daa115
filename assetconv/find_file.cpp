#include "assetconv/find_file.hpp"

#include "assetconv/text_lines.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <system_error>

namespace atrium {
namespace fs = std::filesystem;
namespace {

constexpr std::array image_endings{".png", ".tga", ".jpg", ".jpeg", ".dds"};

/// Names longer than this or deeper than this are no file names but noise.
constexpr std::size_t longest_name = 1024;
constexpr std::size_t most_words = 16;

bool is_file(const fs::path& path)
{
    std::error_code ignored;
    return fs::is_regular_file(path, ignored);
}

std::optional<fs::path> find_without_case(const fs::path& folder, const fs::path& relative, InputRecord& inputs)
{
    fs::path at = folder;
    for (const fs::path& part : relative) {
        std::error_code ignored;
        const fs::path exact = at / part;
        if (fs::exists(exact, ignored)) {
            at = exact;
            continue;
        }
        const std::vector<std::string> entries = entries_like(at, part.string());
        inputs.add_search(at, part.string(), entries);
        if (entries.empty()) return std::nullopt;
        at /= entries.front(); // the first in byte order of several
    }
    return is_file(at) ? std::optional(at) : std::nullopt;
}

/// "C:/x/y.png" and "/x/y.png" say nothing on this machine but their last part.
fs::path relative_part(std::string_view name)
{
    std::string text(name);
    std::replace(text.begin(), text.end(), '\\', '/');
    const bool drive = text.size() > 2 && text[1] == ':' && text[2] == '/';
    const fs::path path(text);
    return (drive || path.is_absolute() ? path.filename() : path).lexically_normal();
}

} // namespace

std::vector<fs::path> folders_of(const fs::path& file)
{
    constexpr int most_links = 40; // as many as Linux follows
    std::vector<fs::path> folders;
    const auto add = [&](const fs::path& folder) {
        if (std::find(folders.begin(), folders.end(), folder) == folders.end()) folders.push_back(folder);
    };
    fs::path at = file;
    std::error_code failed;
    for (int i = 0; i < most_links; ++i) {
        add(at.parent_path());
        if (!fs::is_symlink(at, failed)) break;
        const fs::path next = fs::read_symlink(at, failed);
        if (failed) break;
        at = at.parent_path() / next; // an absolute link replaces the folder
    }
    return folders;
}

std::optional<fs::path> find_file(const std::vector<fs::path>& folders, std::string_view name, bool any_image_ending,
                                  InputRecord& inputs, std::vector<fs::path>* tried)
{
    if (name.empty() || name.size() > longest_name || name.find('\0') != std::string_view::npos) return std::nullopt;
    const fs::path relative = relative_part(name);
    std::vector<fs::path> candidates{relative};
    if (relative.has_parent_path()) candidates.push_back(relative.filename());
    if (any_image_ending) {
        const std::size_t plain = candidates.size();
        for (std::size_t i = 0; i < plain; ++i) {
            for (const char* ending : image_endings)
                candidates.push_back(fs::path(candidates[i]).replace_extension(ending));
        }
    }
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        if (candidates[i].empty()) continue;
        for (const fs::path& folder : folders) {
            if (auto found = find_without_case(folder, candidates[i], inputs)) return found;
            if (tried != nullptr && i < 2 && (i == 0 || relative.has_parent_path()))
                tried->push_back(folder / candidates[i]);
        }
    }
    return std::nullopt;
}

std::vector<fs::path> find_libraries(const std::vector<fs::path>& folders, std::string_view names,
                                     std::vector<std::string>& missing, InputRecord& inputs)
{
    std::vector<fs::path> found;
    std::string_view rest = trimmed(names);
    while (!rest.empty()) {
        std::vector<std::string_view> ends; // the text up to each word's end
        std::string_view after = rest;
        while (!after.empty() && ends.size() < most_words) {
            const std::string_view word = take_word(after);
            ends.push_back(rest.substr(0, static_cast<std::size_t>(word.data() + word.size() - rest.data())));
        }
        std::size_t taken = ends.front().size();
        bool any = false;
        for (auto end = ends.rbegin(); end != ends.rend() && !any; ++end) {
            if (const auto file = find_file(folders, *end, false, inputs)) {
                found.push_back(*file);
                taken = end->size();
                any = true;
            }
        }
        if (!any) missing.emplace_back(ends.front());
        rest = trimmed(rest.substr(taken));
    }
    if (found.empty() && !missing.empty()) missing = {std::string(trimmed(names))}; // likelier one name with blanks
    return found;
}

} // namespace atrium
