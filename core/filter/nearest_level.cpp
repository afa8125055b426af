// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filter/footprint_level.h"
#include "core/filter/methods.h"
#include "core/filter/query_filter.h"
#include "core/filter/rectilinear_rows.h"

namespace trixel {
namespace {

QueryCost nearestLevelAnswer(const FilterScene& scene,
                             const QueryEllipse& ellipse,
                             FaceId face,
                             int group,
                             GroupValue& value)
{
    const Level level = nearestLevel(scene, face, roundLevel(ellipse));
    std::copy_n(texelUnder(scene, {face, ellipse.uv}, level, group), kGroupChannels, value.begin());
    return {static_cast<float>(level.log2()), 1};
}

} // namespace

MethodEntry nearestLevelMethod()
{
    MethodEntry entry;
    entry.name = "nearest-level";
    entry.title = "Nearest level";
    entry.about = "The texel under the centre, on the mip level nearest to the footprint's width.";
    entry.claims = {.rotationFree = Claim::Yes};
    entry.make = [](double) { return perQueryMethod(nearestLevelAnswer); };
    return entry;
}

} // namespace trixel
