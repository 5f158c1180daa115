#include "app/view/shader_reload.hpp"

#include "app/child_process.hpp"
#include "app/shader_compiler.hpp"
#include "renderer/core/error.hpp"
#include "renderer/core/jobs.hpp"
#include "renderer/core/log.hpp"
#include "shaders/embedded.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace atrium::app {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

} // namespace

ShaderReload::ShaderReload(Engine& engine, const std::filesystem::path& folder)
    : engine_(engine), folder_(folder), sources_(folder, std::filesystem::last_write_time(this_program()))
{}

bool ShaderReload::update()
{
    if (folder_.empty()) return false;
    look();
    if (!job_.valid()) start();
    if (!job_.valid() || job_.wait_for(0s) != std::future_status::ready) return false;
    std::vector<Compiled> done = job_.get();
    const auto taken = std::count_if(done.begin(), done.end(), [&](Compiled& c) { return take(std::move(c)); });
    log_info(fmt::format("{} shader(s) compiled, {} exchanged", done.size(), taken));
    tell();
    return true;
}

void ShaderReload::compile_all()
{
    waiting_.merge(sources_.all());
}

void ShaderReload::look()
{
    constexpr auto pause = 500ms;
    if (Clock::now() - looked_ < pause) return;
    looked_ = Clock::now();
    waiting_.merge(sources_.changed());
}

void ShaderReload::start()
{
    if (waiting_.empty()) return;
    std::vector<Compiled> jobs;
    for (const std::string& shader : std::exchange(waiting_, {})) jobs.push_back({shader, {}, {}});
    job_ = std::async(std::launch::async, [folder = folder_, jobs = std::move(jobs)]() mutable {
        parallel_for(jobs.size(), [&](std::size_t i) {
            try {
                jobs[i].code = compile_shader(folder, jobs[i].shader);
            } catch (const Error& error) {
                jobs[i].error = error.text();
            }
        });
        return std::move(jobs);
    });
}

bool ShaderReload::take(Compiled compiled)
{
    errors_.erase(compiled.shader);
    if (compiled.error.empty()) {
        const auto known = in_use_.find(compiled.shader);
        const std::span<const std::uint32_t> before =
            known == in_use_.end() ? shaders::find(compiled.shader) : std::span<const std::uint32_t>(known->second);
        if (std::equal(before.begin(), before.end(), compiled.code.begin(), compiled.code.end())) return false;
        try {
            engine_.replace_shader(compiled.shader, compiled.code);
            in_use_[compiled.shader] = std::move(compiled.code);
            return true;
        } catch (const Error& error) {
            compiled.error = error.text();
        }
    }
    errors_[compiled.shader] = std::move(compiled.error);
    return false;
}

void ShaderReload::tell()
{
    // A mistake in an include is the same in all that have it.
    std::set<std::string> texts;
    for (const auto& [shader, text] : errors_) texts.insert(text);
    std::string all;
    for (const std::string& text : texts) all += (all.empty() ? "" : "\n") + text;
    if (all == problem_) return;
    problem_ = all;
    if (problem_.empty())
        log_info("all shaders compile again");
    else
        log_warning(problem_);
}

} // namespace atrium::app
