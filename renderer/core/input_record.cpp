#include "renderer/core/input_record.hpp"

#include "renderer/core/error.hpp"
#include "renderer/core/hash.hpp"
#include "renderer/core/mapped_file.hpp"

#include <algorithm>
#include <charconv>
#include <map>
#include <optional>
#include <system_error>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <sys/stat.h>

namespace atrium {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr int record_version = 1;

std::string lower_case(std::string_view text)
{
    std::string lower(text);
    for (char& c : lower) {
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    }
    return lower;
}

std::vector<std::string> entries_of(const fs::path& folder)
{
    std::vector<std::string> names;
    std::error_code ignored; // a folder that does not exist has no entries
    for (fs::directory_iterator at(folder.empty() ? fs::path(".") : folder, ignored), end; at != end;
         at.increment(ignored)) {
        names.push_back(at->path().filename().string());
    }
    std::sort(names.begin(), names.end());
    return names;
}

std::vector<std::string> pick_like(const std::vector<std::string>& entries, std::string_view name)
{
    const std::string wanted = lower_case(name);
    std::vector<std::string> found;
    for (const std::string& entry : entries) {
        if (lower_case(entry) == wanted) found.push_back(entry);
    }
    return found;
}

std::optional<std::uint64_t> hash_of(const fs::path& file)
{
    try {
        return hash64(MappedFile(file).bytes());
    } catch (const Error&) { // the reader of the file reports it
        return std::nullopt;
    }
}

std::int64_t nanoseconds(const timespec& time)
{
    return std::int64_t{time.tv_sec} * 1'000'000'000 + time.tv_nsec;
}

/// File names are bytes; JSON strings are UTF-8.
std::string escaped(const std::string& bytes)
{
    std::string out;
    for (const char c : bytes) {
        const auto code = static_cast<unsigned char>(c);
        if (code <= 0x20 || code >= 0x7f || c == '%')
            out += fmt::format("%{:02x}", code);
        else
            out += c;
    }
    return out;
}

std::string unescaped(const std::string& text)
{
    std::string out;
    for (std::size_t i = 0; i < text.size(); ++i) {
        unsigned code = 0;
        if (text[i] == '%' && i + 2 < text.size() &&
            std::from_chars(&text[i + 1], &text[i + 1] + 2, code, 16).ptr == &text[i + 1] + 2) {
            out += static_cast<char>(code);
            i += 2;
        } else {
            out += text[i];
        }
    }
    return out;
}

} // namespace

std::vector<std::string> entries_like(const fs::path& folder, std::string_view name)
{
    return pick_like(entries_of(folder), name);
}

bool InputRecord::look(const fs::path& file, State& state)
{
    struct stat status {};
    if (::stat(file.c_str(), &status) != 0) return false;
    state = {status.st_dev, status.st_ino, static_cast<std::uint64_t>(status.st_size), nanoseconds(status.st_mtim),
             nanoseconds(status.st_ctim)};
    return true;
}

void InputRecord::add_file(const fs::path& file)
{
    std::error_code failed;
    File entry;
    entry.path = fs::absolute(file, failed); // not normalised: ".." after a link leads elsewhere
    if (!kept_ || failed || !look(entry.path, entry.state)) return;
    const auto same = [&](const File& f) { return f.path == entry.path; };
    if (std::any_of(files_.begin(), files_.end(), same)) return;
    const auto hash = hash_of(entry.path);
    if (!hash) return;
    entry.hash = *hash;
    files_.push_back(std::move(entry));
}

void InputRecord::add_search(const fs::path& folder, std::string_view name, const std::vector<std::string>& found)
{
    std::error_code failed;
    const Search search{fs::absolute(folder.empty() ? fs::path(".") : folder, failed), std::string(name), found};
    if (!kept_ || failed || std::find(searches_.begin(), searches_.end(), search) != searches_.end()) return;
    searches_.push_back(search);
}

std::vector<fs::path> InputRecord::files() const
{
    std::vector<fs::path> out;
    for (const File& file : files_) out.push_back(file.path);
    return out;
}

std::string InputRecord::change() const
{
    for (const File& file : files_) {
        State now;
        if (!look(file.path, now)) return fmt::format("{} is gone", file.path.string());
        if (now == file.state) continue;
        if (now.size != file.state.size || hash_of(file.path) != file.hash)
            return fmt::format("{} has changed", file.path.string());
    }
    std::map<fs::path, std::vector<std::string>> entries; // each folder is listed once
    for (const Search& search : searches_) {
        const auto [at, is_new] = entries.try_emplace(search.folder);
        if (is_new) at->second = entries_of(search.folder);
        if (pick_like(at->second, search.name) != search.found)
            return fmt::format("{} was added or removed", (search.folder / search.name).string());
    }
    return "";
}

std::string InputRecord::to_json() const
{
    Json files = Json::array(), searches = Json::array();
    for (const File& f : files_) {
        files.push_back({{"path", escaped(f.path.string())},
                         {"device", f.state.device},
                         {"inode", f.state.inode},
                         {"size", f.state.size},
                         {"modified", f.state.modified},
                         {"changed", f.state.changed},
                         {"hash", f.hash}});
    }
    for (const Search& s : searches_) {
        Json found = Json::array();
        for (const std::string& entry : s.found) found.push_back(escaped(entry));
        searches.push_back(
            {{"folder", escaped(s.folder.string())}, {"name", escaped(s.name)}, {"found", std::move(found)}});
    }
    const Json out{{"version", record_version},
                   {"result", result},
                   {"files", std::move(files)},
                   {"searches", std::move(searches)},
                   {"notes", notes}};
    return out.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

InputRecord InputRecord::from_json(std::string_view text, const std::string& name)
{
    InputRecord out;
    try {
        const Json json = Json::parse(text);
        if (json.at("version").get<int>() != record_version)
            throw Error(ExitCode::input, "a record of inputs of another version", name, "", "make its result again");
        out.result = json.at("result").get<std::uint64_t>();
        for (const Json& f : json.at("files")) {
            const State state{f.at("device").get<std::uint64_t>(), f.at("inode").get<std::uint64_t>(),
                              f.at("size").get<std::uint64_t>(), f.at("modified").get<std::int64_t>(),
                              f.at("changed").get<std::int64_t>()};
            out.files_.push_back(
                {unescaped(f.at("path").get<std::string>()), state, f.at("hash").get<std::uint64_t>()});
        }
        for (const Json& s : json.at("searches")) {
            Search search{unescaped(s.at("folder").get<std::string>()), unescaped(s.at("name").get<std::string>()), {}};
            for (const Json& entry : s.at("found")) search.found.push_back(unescaped(entry.get<std::string>()));
            out.searches_.push_back(std::move(search));
        }
        out.notes = json.at("notes").get<std::vector<std::string>>();
    } catch (const Json::exception& e) {
        throw Error(ExitCode::input, "a damaged record of inputs", name, e.what(), "make its result again");
    }
    return out;
}

} // namespace atrium
