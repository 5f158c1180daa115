#include "app/view/shader_sources.hpp"

#include "shaders/embedded.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <system_error>
#include <utility>
#include <vector>

namespace atrium::app {
namespace {

namespace fs = std::filesystem;

bool is_source(const fs::path& file)
{
    constexpr std::array endings{".vert", ".frag", ".comp", ".glsl", ".h"};
    return std::find(endings.begin(), endings.end(), file.extension()) != endings.end();
}

/// What stands between the quotes of #include lines.
std::vector<std::string> includes_of(const fs::path& file)
{
    std::vector<std::string> out;
    std::ifstream in(file);
    for (std::string line; std::getline(in, line);) {
        if (line.find("#include") == std::string::npos) continue;
        const std::size_t first = line.find('"'), last = line.rfind('"');
        if (first < last) out.push_back(line.substr(first + 1, last - first - 1));
    }
    return out;
}

} // namespace

ShaderSources::ShaderSources(fs::path folder, fs::file_time_type known) : folder_(std::move(folder)), known_(known) {}

std::set<std::string> ShaderSources::changed()
{
    std::set<std::string> written;
    std::error_code error; // files come and go while editors save
    for (fs::recursive_directory_iterator it(folder_, error), end; it != end && !error; it.increment(error)) {
        if (!is_source(it->path())) continue;
        std::error_code gone;
        const fs::file_time_type time = it->last_write_time(gone);
        if (gone) continue;
        const std::string name = it->path().lexically_relative(folder_).string();
        fs::file_time_type& before = times_.try_emplace(name, known_).first->second;
        // Another time, not a later one: a file may be put back. On the first look only what is newer counts.
        if (before == known_ ? time > known_ : time != before) written.insert(name);
        before = time;
    }
    return written.empty() ? written : with_includers(std::move(written));
}

std::set<std::string> ShaderSources::all() const
{
    std::set<std::string> out;
    for (const auto& [name, time] : times_)
        if (!shaders::find(name).empty()) out.insert(name);
    return out;
}

std::set<std::string> ShaderSources::with_includers(std::set<std::string> files) const
{
    std::map<std::string, std::vector<std::string>> includes;
    for (const auto& [name, time] : times_) includes[name] = includes_of(folder_ / name);
    // Where the compiler seeks an include is its own affair: any file that ends with the name may be meant.
    const auto may_mean = [&](const std::string& include) {
        return std::any_of(files.begin(), files.end(), [&](const std::string& f) { return f.ends_with(include); });
    };
    for (std::size_t before = 0; before != files.size();) {
        before = files.size();
        for (const auto& [name, list] : includes)
            if (std::any_of(list.begin(), list.end(), may_mean)) files.insert(name);
    }
    std::erase_if(files, [](const std::string& name) { return shaders::find(name).empty(); });
    return files;
}

} // namespace atrium::app
