#pragma once
// One channel of an image in 64 bits, and its convolution with separable kernels. 32 bits are too few for the
// differences of sums that SSIM and FLIP take.

#include <cstddef>
#include <functional>
#include <vector>

namespace atrium {

struct Plane {
    int width = 0, height = 0;
    std::vector<double> values; ///< row 0 is the top

    Plane() = default;
    Plane(int w, int h) : width(w), height(h), values(static_cast<std::size_t>(w) * static_cast<std::size_t>(h)) {}
    [[nodiscard]] const double* row(int y) const
    {
        return &values[static_cast<std::size_t>(y) * static_cast<std::size_t>(width)];
    }
    [[nodiscard]] double* row(int y) { return &values[static_cast<std::size_t>(y) * static_cast<std::size_t>(width)]; }
};

/// An odd number of weights; the middle one is that of the pixel itself.
using Kernel = std::vector<double>;

/// Samples of a function at -radius … radius.
[[nodiscard]] Kernel make_kernel(int radius, const std::function<double(double)>& weight);
[[nodiscard]] double sum(const Kernel& kernel);
/// The kernel with its weights multiplied so that they sum to 1.
[[nodiscard]] Kernel normalized(Kernel kernel);

/// The sum of weights times the values around each pixel. Outside, the nearest pixel counts.
[[nodiscard]] Plane convolve_rows(const Plane& plane, const Kernel& kernel);
[[nodiscard]] Plane convolve_columns(const Plane& plane, const Kernel& kernel);
[[nodiscard]] Plane convolve(const Plane& plane, const Kernel& along_rows, const Kernel& along_columns);

/// A plane of the same size whose pixels are `function` of the pixel's index.
[[nodiscard]] Plane make_plane(int width, int height, const std::function<double(std::size_t)>& function);

} // namespace atrium
