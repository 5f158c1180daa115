#include "assetconv/text_lines.hpp"

#include <algorithm>

namespace atrium {
namespace {

constexpr std::string_view blanks = " \t\v\f\r";
constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

} // namespace

TextLines::TextLines(std::span<const std::byte> bytes)
    : rest_(reinterpret_cast<const char*>(bytes.data()), bytes.size())
{
    if (rest_.starts_with(byte_order_mark)) rest_.remove_prefix(byte_order_mark.size());
}

std::string_view TextLines::physical_line()
{
    const std::size_t end = rest_.find_first_of("\r\n");
    const std::string_view line = rest_.substr(0, end);
    if (end == std::string_view::npos) {
        rest_ = {};
    } else {
        const bool crlf = rest_[end] == '\r' && end + 1 < rest_.size() && rest_[end + 1] == '\n';
        rest_.remove_prefix(end + (crlf ? 2 : 1));
    }
    ++consumed_;
    return line;
}

bool TextLines::next()
{
    while (!rest_.empty()) {
        std::string_view line = physical_line();
        number_ = consumed_;
        if (line.ends_with('\\') && !rest_.empty()) {
            joined_.clear();
            while (line.ends_with('\\') && !rest_.empty()) {
                line.remove_suffix(1);
                joined_.append(line).push_back(' ');
                line = physical_line();
            }
            joined_.append(line);
            line = joined_;
        }
        text_ = trimmed(line);
        if (!text_.empty() && text_.front() != '#') return true;
    }
    return false;
}

std::string_view trimmed(std::string_view text)
{
    const std::size_t first = text.find_first_not_of(blanks);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::string_view take_word(std::string_view& text)
{
    text = trimmed(text);
    const std::size_t end = std::min(text.find_first_of(blanks), text.size());
    const std::string_view word = text.substr(0, end);
    text = trimmed(text.substr(end));
    return word;
}

std::string lower_case(std::string_view text)
{
    std::string lower(text);
    for (char& c : lower) {
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    }
    return lower;
}

} // namespace atrium
