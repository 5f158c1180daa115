#include "app/json_output.hpp"

#include "renderer/core/atomic_file.hpp"

#include <cstdio>

namespace atrium::app {

void write_json_text(const std::string& target, std::string_view text)
{
    if (target != "-") {
        write_text_file(target, text);
        return;
    }
    std::fwrite(text.data(), 1, text.size(), stdout);
    if (!text.ends_with('\n')) std::fputc('\n', stdout);
}

} // namespace atrium::app
