// SPDX-License-Identifier: GPL-3.0-or-later
//
// In the place of all methods a Gaussian over every texel of the face, whether it has a weight or
// not, divided by what the weights should add up to.
#include "core/filter/filter_method.h"
#include "core/filter/query_filter.h"

// The shipped table under another name.
#define filterMethods shippedMethods
#include "core/filter/filter_method.cpp"
#undef filterMethods

#include <cmath>
#include <numbers>

namespace trixel {
namespace {

class GaussianByCalculus final : public FilterMethod
{
public:
    void filter(const FilterScene& scene,
                const FilterQueries& queries,
                const FilterResults& results) const override
    {
        filterEach(scene,
                   queries,
                   results,
                   [&](const QueryEllipse& e, FaceId face, int group, GroupValue& value) {
                       const Level level = scene.level(face);
                       const FaceShape& shape = scene.surface().shape(face);
                       const LevelTexels texels = scene.mips().texels(face, level, group);
                       const double area =
                           shape.e1.x * shape.e2.y / 2 / static_cast<double>(level.texelCount());
                       const double whole = 2 * std::numbers::pi * std::sqrt(e.determinant) / area;
                       for (std::uint32_t t = 0; t < level.texelCount(); ++t) {
                           const auto index = static_cast<TexelIndex>(t);
                           const glm::dvec2 d =
                               shape.toPlane(centroid(level, texelAt(level, index))) - e.centre;
                           const double q =
                               (e.yy * d.x * d.x - 2 * e.xy * d.x * d.y + e.xx * d.y * d.y) /
                               e.determinant;
                           const auto weight = static_cast<float>(std::exp(-q / 2) / whole);
                           for (std::size_t c = 0; c < value.size(); ++c) {
                               value[c] += weight * texels.texel(index)[c];
                           }
                       }
                       return QueryCost{static_cast<float>(level.log2()), level.texelCount()};
                   });
    }
};

} // namespace

std::span<const MethodEntry> filterMethods()
{
    static const MethodEntry kEntry = [] {
        MethodEntry entry;
        entry.name = "gaussian-by-calculus";
        entry.make = [](double) -> std::unique_ptr<const FilterMethod> {
            return std::make_unique<GaussianByCalculus>();
        };
        return entry;
    }();
    return std::span(&kEntry, 1);
}

} // namespace trixel
