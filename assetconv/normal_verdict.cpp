#include "assetconv/normal_verdict.hpp"

#include "renderer/core/jobs.hpp"
#include "renderer/core/log.hpp"

#include <fmt/format.h>

namespace atrium {
namespace {

struct Finding {
    BumpContent content = BumpContent::normals;
    std::optional<GreenAxis> green;
    const char* reason = "";
};

Finding look_at(const NormalQuestion& question, const ImageStore& images)
{
    Finding finding;
    const SourceImage* image = images.find(question.image);
    if (image == nullptr) return finding;
    finding.content = question.surely_normals ? BumpContent::normals : classify_bump(*image);
    if (finding.content != BumpContent::normals) return finding;
    const NormalField field = read_normals(*image);
    finding.green = green_axis_by_curl(field);
    finding.reason = "curl";
    const SourceImage* color = question.color ? images.find(*question.color) : nullptr;
    if (finding.green || color == nullptr) return finding;
    finding.green = green_axis_by_colour(field, *color);
    finding.reason = "colour";
    return finding;
}

} // namespace

NormalVerdicts judge_normal_maps(const std::vector<NormalQuestion>& questions, const ImageStore& images, NormalY option)
{
    std::vector<Finding> findings(questions.size());
    parallel_for(questions.size(), [&](std::size_t i) { findings[i] = look_at(questions[i], images); });
    int balance = 0; // above zero: most are green up
    for (const Finding& f : findings) {
        if (f.content == BumpContent::normals && f.green) balance += *f.green == GreenAxis::up ? 1 : -1;
    }
    NormalVerdicts verdicts;
    for (std::size_t i = 0; i < questions.size(); ++i) {
        const Finding& f = findings[i];
        NormalVerdict verdict{f.content, f.green.value_or(GreenAxis::up), f.reason};
        if (!f.green && balance != 0) {
            verdict.green = balance > 0 ? GreenAxis::up : GreenAxis::down;
            verdict.reason = "majority";
        } else if (!f.green) {
            verdict.reason = "default";
        }
        if (option != NormalY::automatic) {
            verdict.green = option == NormalY::up ? GreenAxis::up : GreenAxis::down;
            verdict.reason = "option";
        }
        if (!verdicts.emplace(questions[i].image, verdict).second) continue;
        const char* content = f.content == BumpContent::normals  ? "normal map"
                              : f.content == BumpContent::height ? "height map"
                                                                 : "picture as height";
        if (f.content == BumpContent::normals) {
            log_verbose(fmt::format("{}: {}, green {} (by {})", questions[i].image.file.filename().string(), content,
                                    verdict.green == GreenAxis::up ? "up" : "down", verdict.reason));
        } else {
            log_verbose(fmt::format("{}: {}", questions[i].image.file.filename().string(), content));
        }
    }
    return verdicts;
}

} // namespace atrium
