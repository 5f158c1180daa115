// Which way a normal map's green points.

#include "assetconv/normal_maps.hpp"

#include <algorithm>
#include <cmath>

namespace atrium {
namespace {

/// Slopes steeper than this are noise at the rim of an island or an overhang.
constexpr float least_z = 0.1f;
/// Grid on which slopes are integrated: the large shapes are what colour maps show.
constexpr int grid = 64;
constexpr int relaxations = 400;
constexpr double colour_margin = 0.05;

/// Slopes p = dh/dx, q = dh/dy (y down) if green is up; averaged over cells of a smaller grid.
struct Slopes {
    int width = 0, height = 0;
    std::vector<float> p, q;
    std::vector<bool> valid;

    [[nodiscard]] std::size_t index(int x, int y) const
    {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    }
};

Slopes slopes_of(const NormalField& field, int cell)
{
    Slopes s;
    s.width = std::max(1, field.width / cell);
    s.height = std::max(1, field.height / cell);
    for (int y = 0; y < s.height; ++y) {
        for (int x = 0; x < s.width; ++x) {
            float p = 0, q = 0;
            int count = 0;
            for (int j = y * cell; j < std::min((y + 1) * cell, field.height); ++j) {
                for (int i = x * cell; i < std::min((x + 1) * cell, field.width); ++i) {
                    const std::size_t at = static_cast<std::size_t>(j) * static_cast<std::size_t>(field.width) +
                                           static_cast<std::size_t>(i);
                    const vec3& n = field.normals[at];
                    if (!field.valid[at] || n.z < least_z) continue;
                    p -= n.x / n.z;
                    q += n.y / n.z;
                    ++count;
                }
            }
            const bool enough = 2 * count > cell * cell;
            s.p.push_back(enough ? p / static_cast<float>(count) : 0);
            s.q.push_back(enough ? q / static_cast<float>(count) : 0);
            s.valid.push_back(enough);
        }
    }
    return s;
}

/// Mean squared curl if green is up, and if it is down.
std::array<double, 2> curls(const Slopes& s)
{
    double up = 0, down = 0, count = 0;
    for (int y = 1; y + 1 < s.height; ++y) {
        for (int x = 1; x + 1 < s.width; ++x) {
            const std::size_t l = s.index(x - 1, y), r = s.index(x + 1, y), a = s.index(x, y - 1),
                              b = s.index(x, y + 1);
            if (!s.valid[l] || !s.valid[r] || !s.valid[a] || !s.valid[b]) continue;
            const double dp = s.p[b] - s.p[a], dq = s.q[r] - s.q[l];
            up += (dp - dq) * (dp - dq);
            down += (dp + dq) * (dp + dq);
            count += 1;
        }
    }
    return {up / std::max(count, 1.0), down / std::max(count, 1.0)};
}

/// Least-squares height of one axis' slopes alone (periodic), by Gauss-Seidel on the Poisson equation.
std::vector<double> integrate(const Slopes& s, bool along_x)
{
    const int w = s.width, h = s.height;
    std::vector<double> divergence(s.p.size()), height(s.p.size(), 0.0);
    for (int y = 0; y < h; ++y) {
        for (int x = 0; x < w; ++x) {
            divergence[s.index(x, y)] = along_x ? (s.p[s.index((x + 1) % w, y)] - s.p[s.index((x + w - 1) % w, y)]) / 2
                                                : (s.q[s.index(x, (y + 1) % h)] - s.q[s.index(x, (y + h - 1) % h)]) / 2;
        }
    }
    for (int k = 0; k < relaxations; ++k) {
        for (int y = 0; y < h; ++y) {
            for (int x = 0; x < w; ++x) {
                const double around = height[s.index((x + 1) % w, y)] + height[s.index((x + w - 1) % w, y)] +
                                      height[s.index(x, (y + 1) % h)] + height[s.index(x, (y + h - 1) % h)];
                height[s.index(x, y)] = (around - divergence[s.index(x, y)]) / 4;
            }
        }
    }
    return height;
}

double correlation(const std::vector<double>& a, const std::vector<double>& b, const std::vector<bool>& valid)
{
    double n = 0, sa = 0, sb = 0, saa = 0, sbb = 0, sab = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (!valid[i]) continue;
        n += 1;
        sa += a[i];
        sb += b[i];
        saa += a[i] * a[i];
        sbb += b[i] * b[i];
        sab += a[i] * b[i];
    }
    const double va = n * saa - sa * sa, vb = n * sbb - sb * sb;
    return va > 1e-12 && vb > 1e-12 ? (n * sab - sa * sb) / std::sqrt(va * vb) : 0;
}

} // namespace

std::optional<GreenAxis> green_axis_by_curl(const NormalField& field)
{
    // Texel noise hides the curl of some maps and large shapes that of others: the clearest of four scales decides.
    double clearest = 0;
    GreenAxis axis = GreenAxis::up;
    for (const int cell : {1, 2, 4, 8}) {
        if (std::min(field.width, field.height) / cell < 8) break;
        const auto [up, down] = curls(slopes_of(field, cell));
        const double larger = std::max(up, down);
        const double difference = larger > 1e-9 ? std::abs(up - down) / larger : 0;
        if (difference > clearest) {
            clearest = difference;
            axis = up <= down ? GreenAxis::up : GreenAxis::down;
        }
    }
    return clearest >= green_decision ? std::optional(axis) : std::nullopt;
}

std::optional<GreenAxis> green_axis_by_colour(const NormalField& field, const SourceImage& colour)
{
    const Slopes s = slopes_of(field, std::max(1, std::max(field.width, field.height) / grid));
    std::vector<double> brightness;
    for (int y = 0; y < s.height; ++y) {
        for (int x = 0; x < s.width; ++x) {
            const int left = x * colour.width / s.width, right = std::max(left + 1, (x + 1) * colour.width / s.width);
            const int top = y * colour.height / s.height, low = std::max(top + 1, (y + 1) * colour.height / s.height);
            double sum = 0;
            for (int j = top; j < low; ++j) {
                for (int i = left; i < right; ++i) sum += colour.luminance(i, j);
            }
            brightness.push_back(sum / ((right - left) * (low - top)));
        }
    }
    const std::vector<double> along_x = integrate(s, true), along_y = integrate(s, false);
    std::vector<double> up(along_x), down(along_x);
    for (std::size_t i = 0; i < up.size(); ++i) {
        up[i] += along_y[i];
        down[i] -= along_y[i];
    }
    const double if_up = correlation(up, brightness, s.valid), if_down = correlation(down, brightness, s.valid);
    if (std::abs(if_up - if_down) < colour_margin) return std::nullopt;
    return if_up > if_down ? GreenAxis::up : GreenAxis::down;
}

} // namespace atrium
