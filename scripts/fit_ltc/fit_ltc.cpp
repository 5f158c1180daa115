// Writes the table of linearly transformed cosines:  fit_ltc > assets/ltc/table.inc

#include "scripts/fit_ltc/fit.hpp"

#include <cstdio>

int main()
{
    using namespace atrium;
    std::puts("// Made by scripts/fit_ltc; struct and axes: shaders/shared/ltc.h. A row of the table is 32 lines.");
    for (unsigned row = 0; row < shared::ltc_size; ++row) {
        for (unsigned column = 0; column < shared::ltc_size; ++column) {
            const shared::LtcEntry e = fit_ltc(ltc_roughness(row), ltc_cosine(column));
            std::printf("{%.6g, %.6g, %.6g, %.6g, %.6g},\n", e.log2_along, e.log2_across, e.skew, e.albedo, e.fresnel);
        }
    }
}
