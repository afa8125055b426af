// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filter/footprint_level.h"
#include "core/filter/methods.h"
#include "core/filter/query_filter.h"
#include "core/filter/rectilinear_rows.h"

namespace trixel {
namespace {

class RectilinearBilinear final : public FilterMethod
{
public:
    void filter(const FilterScene& scene,
                const FilterQueries& queries,
                const FilterResults& results) const override
    {
        filterEach(scene,
                   queries,
                   results,
                   [&](const QueryEllipse& ellipse, FaceId face, int group, GroupValue& value) {
                       const Level level = nearestLevel(scene, face, roundLevel(ellipse));
                       TexelSum sum;
                       addRectilinearBilinear(scene, {face, ellipse.uv}, level, group, 1, sum);
                       sum.store(value.data());
                       return QueryCost{static_cast<float>(level.log2()), 4};
                   });
    }
};

} // namespace

MethodEntry rectilinearBilinearMethod()
{
    MethodEntry entry;
    entry.name = "rectilinear-bilinear";
    entry.title = "Bilinear in rows";
    entry.about = "Linear along two rows of texels and between them, on the mip level nearest to "
                  "the footprint's width.";
    entry.claims = {.affineKept = Claim::Yes};
    entry.make = [](double) -> std::unique_ptr<const FilterMethod> {
        return std::make_unique<RectilinearBilinear>();
    };
    return entry;
}

} // namespace trixel
