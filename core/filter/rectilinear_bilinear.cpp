// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filter/footprint_level.h"
#include "core/filter/methods.h"
#include "core/filter/query_filter.h"
#include "core/filter/rectilinear_rows.h"

namespace trixel {
namespace {

QueryCost bilinearAnswer(const FilterScene& scene,
                         const QueryEllipse& ellipse,
                         FaceId face,
                         int group,
                         GroupValue& value)
{
    const Level level = nearestLevel(scene, face, roundLevel(ellipse));
    TexelSum sum;
    addRectilinearBilinear(scene, {face, ellipse.uv}, level, group, 1, sum);
    sum.store(value.data());
    return {static_cast<float>(level.log2()), 4};
}

} // namespace

MethodEntry rectilinearBilinearMethod()
{
    MethodEntry entry;
    entry.name = "rectilinear-bilinear";
    entry.title = "Bilinear in rows";
    entry.about = "Linear along two rows of texels and between them, on the mip level nearest to "
                  "the footprint's width.";
    entry.claims = {.affineKept = Claim::Yes};
    entry.make = [](double) { return perQueryMethod(bilinearAnswer); };
    return entry;
}

} // namespace trixel
