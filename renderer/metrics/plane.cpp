#include "renderer/metrics/plane.hpp"

#include "renderer/core/jobs.hpp"

#include <algorithm>
#include <numeric>

namespace atrium {

Kernel make_kernel(int radius, const std::function<double(double)>& weight)
{
    Kernel kernel;
    for (int x = -radius; x <= radius; ++x) kernel.push_back(weight(x));
    return kernel;
}

double sum(const Kernel& kernel)
{
    return std::accumulate(kernel.begin(), kernel.end(), 0.0);
}

Kernel normalized(Kernel kernel)
{
    const double total = sum(kernel);
    for (double& weight : kernel) weight /= total;
    return kernel;
}

Plane convolve_rows(const Plane& plane, const Kernel& kernel)
{
    const int radius = static_cast<int>(kernel.size() / 2);
    Plane out(plane.width, plane.height);
    parallel_for(static_cast<std::size_t>(plane.height), [&](std::size_t y) {
        const double* from = plane.row(static_cast<int>(y));
        double* to = out.row(static_cast<int>(y));
        std::vector<double> padded(static_cast<std::size_t>(plane.width) + kernel.size() - 1);
        for (std::size_t i = 0; i < padded.size(); ++i)
            padded[i] = from[std::clamp(static_cast<int>(i) - radius, 0, plane.width - 1)];
        for (int x = 0; x < plane.width; ++x)
            to[x] = std::inner_product(kernel.begin(), kernel.end(), padded.begin() + x, 0.0);
    });
    return out;
}

Plane convolve_columns(const Plane& plane, const Kernel& kernel)
{
    const int radius = static_cast<int>(kernel.size() / 2);
    Plane out(plane.width, plane.height);
    parallel_for(static_cast<std::size_t>(plane.height), [&](std::size_t y) {
        double* to = out.row(static_cast<int>(y));
        for (std::size_t k = 0; k < kernel.size(); ++k) {
            const int row = static_cast<int>(y) + static_cast<int>(k) - radius;
            const double* from = plane.row(std::clamp(row, 0, plane.height - 1));
            for (int x = 0; x < plane.width; ++x) to[x] += kernel[k] * from[x];
        }
    });
    return out;
}

Plane convolve(const Plane& plane, const Kernel& along_rows, const Kernel& along_columns)
{
    return convolve_columns(convolve_rows(plane, along_rows), along_columns);
}

Plane make_plane(int width, int height, const std::function<double(std::size_t)>& function)
{
    Plane out(width, height);
    parallel_for(static_cast<std::size_t>(height), [&](std::size_t y) {
        double* to = out.row(static_cast<int>(y));
        for (int x = 0; x < width; ++x)
            to[x] = function(y * static_cast<std::size_t>(width) + static_cast<std::size_t>(x));
    });
    return out;
}

} // namespace atrium
