// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filter/footprint_level.h"
#include "core/filter/methods.h"
#include "core/filter/query_filter.h"
#include "core/filter/rectilinear_rows.h"

namespace trixel {
namespace {

QueryCost trilinearAnswer(const FilterScene& scene,
                          const QueryEllipse& ellipse,
                          FaceId face,
                          int group,
                          GroupValue& value)
{
    const double level = roundLevel(ellipse);
    TexelSum sum;
    const std::uint32_t taps = addTrilinear(scene, {face, ellipse.uv}, level, group, 1, sum);
    sum.store(value.data());
    return {finerLevel(scene, face, level), taps};
}

} // namespace

MethodEntry trilinearMethod()
{
    MethodEntry entry;
    entry.name = "trilinear";
    entry.title = "Trilinear";
    entry.about = "Bilinear in rows on the two mip levels about the footprint's width, blended.";
    entry.claims = {.affineKept = Claim::Yes, .levelContinuous = Claim::Yes};
    entry.make = [](double) { return perQueryMethod(trilinearAnswer); };
    return entry;
}

} // namespace trixel
