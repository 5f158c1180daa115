#pragma once
// OBJ and MTL files as logical lines. Every quirk of the text itself (line ends, continuations, blanks, byte order
// mark) is dealt with here, so that parsers see one plain form.

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace atrium {

/// Reads bytes line by line: LF, CRLF and CR end a line, a backslash before the end joins the next one, blanks and
/// tabs around the text are trimmed, empty lines and whole-line comments are skipped.
class TextLines {
public:
    explicit TextLines(std::span<const std::byte> bytes);

    /// Advances to the next line with content; false at the end.
    bool next();
    /// The trimmed line; valid until the next call of next().
    [[nodiscard]] std::string_view text() const { return text_; }
    /// Number of its first physical line, from 1.
    [[nodiscard]] std::uint32_t number() const { return number_; }

private:
    std::string_view physical_line();

    std::string_view rest_, text_;
    std::string joined_;
    std::uint32_t number_ = 0, consumed_ = 0;
};

[[nodiscard]] std::string_view trimmed(std::string_view text);
/// Cuts the first blank-separated word off `text` and returns it; `text` keeps the trimmed rest.
[[nodiscard]] std::string_view take_word(std::string_view& text);
[[nodiscard]] std::string lower_case(std::string_view text);

} // namespace atrium
