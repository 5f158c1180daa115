#include "app/view/scene_pictures.hpp"

#include "app/gui/graph_images.hpp"
#include "app/gui/inset_layout.hpp"
#include "renderer/core/error.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace atrium::app {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double moving_goal_ms = 60; ///< a frame while something moves

/// Building, recording, and waiting for the device.
double whole_ms(const FrameResult& frame)
{
    return frame.record_ms + frame.stats.wall_ms - frame.stats.cpu_ms;
}

} // namespace

void MovingScale::measured(float share, double ms)
{
    const double full = ms / std::max(static_cast<double>(share * share), 0.01);
    full_ms_ = full_ms_ == 0 ? full : 0.5 * (full_ms_ + full);
}

float MovingScale::choose(double goal_ms) const
{
    if (full_ms_ <= goal_ms) return 1;
    const double share = std::sqrt(goal_ms / full_ms_);
    return static_cast<float>(std::clamp(std::floor(share * 20) / 20, 0.2, 1.0));
}

void ScenePictures::begin(const FrameRequest& like)
{
    like_ = like;
    shown_camera_ = like.camera;
    moving_scale_ = {};
    invalidate();
}

void ScenePictures::invalidate()
{
    for (Kept& kept : kept_) kept.share = 0;
}

bool ScenePictures::unfinished() const
{
    return kept_[0].share < 1 || (model_.split && kept_[1].share < 1);
}

FrameRequest ScenePictures::wanted_frame(const Settings& settings, uvec2 size) const
{
    FrameRequest wanted = like_;
    wanted.settings = settings;
    wanted.camera = wanted.previous_camera = model_.camera;
    wanted.lights = model_.lights;
    wanted.materials = model_.materials;
    wanted.size = size;
    return wanted;
}

Insets ScenePictures::wanted_insets(const Look& look) const
{
    Insets wanted;
    if (!look.insets) return wanted;
    wanted.size = gui::lay_out_insets(look.pixels, look.scale, model_.pinned.size()).image;
    for (const gui::PinnedBuffer& p : model_.pinned)
        wanted.buffers.push_back({parse_aov(p.name, model_.lights), p.view});
    return wanted;
}

ScenePictures::Source ScenePictures::source_now(const Settings& settings, const Look& look) const
{
    Source now{settings, model_.camera, model_.lights, model_.materials, {}, look.outlined, look.pixels, look.scale};
    if (look.insets) now.insets = model_.pinned;
    return now;
}

bool ScenePictures::is_still(const Source& source, const Settings& settings, const Look& look) const
{
    static const std::vector<gui::PinnedBuffer> none;
    const std::vector<gui::PinnedBuffer>& insets = look.insets ? model_.pinned : none;
    const auto same_inset = [](const gui::PinnedBuffer& a, const gui::PinnedBuffer& b) {
        return a.name == b.name && same_settings(a.view, b.view);
    };
    return source.pixels == look.pixels && source.scale == look.scale && source.outlined == look.outlined &&
           source.camera == model_.camera && same_settings(source.settings, settings) &&
           source.lights == model_.lights && source.materials == model_.materials &&
           std::equal(source.insets.begin(), source.insets.end(), insets.begin(), insets.end(), same_inset);
}

FrameRequest ScenePictures::wanted_picture(uvec2 size) const
{
    return wanted_frame(model_.settings, size);
}

std::optional<std::string> ScenePictures::draw(const Look& look)
{
    model_.drop_lost_buffers();
    const Camera before = std::exchange(shown_camera_, model_.camera);
    std::optional<std::string> refused = draw_side(PictureSlot::main, look, before);
    if (!model_.split) return refused;
    const std::optional<std::string> other = draw_side(PictureSlot::other, look, before);
    return refused ? refused : other;
}

std::optional<std::string> ScenePictures::draw_side(PictureSlot slot, const Look& look, const Camera& before)
{
    const bool main = slot == PictureSlot::main;
    const Settings& settings = main ? model_.settings : model_.split->other;
    Kept& kept = kept_[main ? 0 : 1];
    const bool first = !kept.source;
    const bool same = !first && is_still(*kept.source, settings, look);
    const float chosen = model_.settings.view.moving_scale;
    const double goal_ms = model_.split ? 0.5 * moving_goal_ms : moving_goal_ms;
    const float share = look.moving && !same ? (chosen > 0 ? chosen : moving_scale_.choose(goal_ms)) : 1;
    if (same && kept.share >= share && !look.always) return std::nullopt;

    FrameRequest request = wanted_frame(settings, glm::max(uvec2(share * vec2(look.pixels)), uvec2(16)));
    request.previous_camera = before;
    request.frame_index = kept.frames++;
    request.want_picture = false;
    request.keep_picture = slot;
    request.outlined = look.outlined;
    if (main) request.insets = wanted_insets(look);
    request.keep_buffers = main && share == 1;
    request.want_graph = main;
    request.want_statistics = share == 1;
    request.remember = share < 1; // what stands is drawn as `render` draws it, whatever was before
    kept = {source_now(settings, look), share, kept.frames};
    FrameResult frame;
    try {
        frame = engine_.render(request);
    } catch (const Error& error) { // such as a view that does not exist: what was shown before stays
        if (main && first) throw;
        kept.share = 1;
        return error.text();
    }
    moving_scale_.measured(share, whole_ms(frame));
    if (share == 1) facts_.side_ms[main ? 1 : 0] = whole_ms(frame);
    if (main) tell(std::move(frame), request);
    return std::nullopt;
}

void ScenePictures::tell(FrameResult frame, const FrameRequest& request)
{
    facts_.graph = std::move(frame.graph);
    model_.graph_images = gui::buffers_of(facts_.graph);
    if (request.want_statistics) facts_.triangles = frame.triangles;
    gui::FrameCost cost;
    cost.frame_ms = whole_ms(frame);
    cost.at_ms = std::chrono::duration<double, std::milli>(Clock::now() - started_).count() - cost.frame_ms;
    cost.cpu_ms = frame.record_ms;
    cost.scale = kept_[0].share;
    for (const graph::PassStats& p : frame.stats.passes)
        cost.passes.push_back({p.name, p.gpu_ms, p.draws, p.gpu_start_ms});
    for (const gui::HeapFacts& heap : facts_.heaps) cost.memory_bytes += heap.used;
    facts_.costs.add(std::move(cost));
    facts_.buffers.clear();
    const auto shown = [&](const std::string& name) {
        if (facts_.buffers.size() < frame.buffers.size()) {
            facts_.buffers.push_back({name, frame.buffers[facts_.buffers.size()]});
        }
    };
    if (!request.settings.debug.view.empty()) shown(model_.shown_buffer());
    for (const gui::PinnedBuffer& p : model_.pinned) shown(p.name);
}

} // namespace atrium::app
