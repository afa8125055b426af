// SPDX-License-Identifier: GPL-3.0-or-later
//
// Every row of texels weighed by one product along the whole of it, in single precision.
#include "core/filter/exact_kernel.h"
#include "core/study/stability/naive_forms.h"

#include <vector>

namespace trixel {

void addExactly(const LevelTexels& texels,
                const HalfLattice& lattice,
                double /*cut*/,
                double offset,
                double area,
                ExactSums& sums)
{
    const std::uint32_t r = lattice.level.resolution();
    const bool lower = lattice.half == TexelHalf::Lower;
    std::vector<double> weights;
    for (std::uint32_t y = lower ? 0 : 1; y < r; ++y) {
        const std::uint32_t begin = lower ? 0 : r - y;
        weights.resize(lower ? r - y : y);
        naive::gaussianWeights(lattice.origin + static_cast<double>(begin) * lattice.alongRow +
                                   static_cast<double>(y) * lattice.perRow,
                               lattice.alongRow,
                               offset,
                               weights);
        for (std::uint32_t k = 0; k < weights.size(); ++k) {
            const float* texel = texels.texel(static_cast<TexelIndex>(begin + k + y * r));
            sums.weight += area * weights[k];
            for (std::size_t c = 0; c < kGroupChannels; ++c) {
                sums.values[c] += area * weights[k] * static_cast<double>(texel[c]);
            }
        }
        sums.taps += weights.size();
    }
}

} // namespace trixel
