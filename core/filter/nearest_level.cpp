// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filter/footprint_level.h"
#include "core/filter/methods.h"
#include "core/filter/query_filter.h"
#include "core/filter/rectilinear_rows.h"

namespace trixel {
namespace {

class NearestLevel final : public FilterMethod
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
                       std::copy_n(texelUnder(scene, {face, ellipse.uv}, level, group),
                                   kGroupChannels,
                                   value.begin());
                       return QueryCost{static_cast<float>(level.log2()), 1};
                   });
    }
};

} // namespace

MethodEntry nearestLevelMethod()
{
    MethodEntry entry;
    entry.name = "nearest-level";
    entry.title = "Nearest level";
    entry.about = "The texel under the centre, on the mip level nearest to the footprint's width.";
    entry.claims = {.rotationFree = Claim::Yes};
    entry.make = [](double) -> std::unique_ptr<const FilterMethod> {
        return std::make_unique<NearestLevel>();
    };
    return entry;
}

} // namespace trixel
