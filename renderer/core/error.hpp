#pragma once
// Errors that reach the user: one message of four parts and the exit code it ends the program with.

#include <stdexcept>
#include <string>

namespace atrium {

enum class ExitCode : int {
    done = 0,
    check_failed = 1, ///< a check or comparison was not met
    usage = 2,        ///< wrong use of the command line, an unknown setting, AOV or light included
    input = 3,        ///< a bad or missing input file, an unknown key in one included
    environment = 4,  ///< no suitable device, a missing component, an exhausted resource, an unwritable output
    internal = 5,     ///< a defect of ours, or a validation message
};

/// A failure told in four parts. `what` is one line without a full stop; the others may be empty when there is
/// nothing to say, `next` hardly ever is.
class Error : public std::runtime_error {
public:
    Error(ExitCode code, const std::string& what, std::string where, std::string why, std::string next);

    /// The message as it is printed after "atrium: ", without a trailing newline.
    [[nodiscard]] std::string text() const;
    [[nodiscard]] ExitCode code() const { return code_; }
    [[nodiscard]] const std::string& where() const { return where_; }
    [[nodiscard]] const std::string& why() const { return why_; }
    [[nodiscard]] const std::string& next() const { return next_; }

private:
    ExitCode code_;
    std::string where_, why_, next_;
};

} // namespace atrium
