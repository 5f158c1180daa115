// The program assetconv: exit codes, stop signals, and what happens when nothing else catches an error.

#include "assetconv/commands.hpp"
#include "renderer/core/atomic_file.hpp"
#include "renderer/core/error.hpp"

#include <csignal>
#include <cstdio>
#include <exception>
#include <new>

namespace {

/// Leaves no half file and ends as the signal would have, so that shells and scripts see what happened.
void stop(int signal)
{
    atrium::discard_open_atomic_files();
    std::signal(signal, SIG_DFL);
    std::raise(signal);
}

int fail(const atrium::Error& error)
{
    std::fprintf(stderr, "assetconv: %s\n", error.text().c_str());
    return static_cast<int>(error.code());
}

} // namespace

int main(int argc, char** argv)
{
    using atrium::Error;
    using atrium::ExitCode;
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, stop);
    try {
        return atrium::run_assetconv({argv + 1, argv + argc});
    } catch (const Error& error) {
        return fail(error);
    } catch (const std::bad_alloc&) {
        return fail(Error(ExitCode::environment, "out of memory", "", "the scene needs more than the machine has",
                          "close other programs, or use --max-texture-size"));
    } catch (const std::exception& error) {
        return fail(Error(ExitCode::internal, error.what(), "", "this is a defect of assetconv",
                          "please report it with the file and the command"));
    }
}
