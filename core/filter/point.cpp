// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filter/methods.h"
#include "core/filter/query_filter.h"

namespace trixel {
namespace {

QueryCost pointAnswer(const FilterScene& scene,
                      const QueryEllipse& ellipse,
                      FaceId face,
                      int group,
                      GroupValue& value)
{
    const Level level = scene.level(face);
    const TexelIndex index = texelIndex(level, texelAt(level, ellipse.uv));
    const LevelTexels texels = scene.mips().texels(face, level, group);
    std::copy_n(texels.texel(index), kGroupChannels, value.begin());
    return {static_cast<float>(level.log2()), 1};
}

} // namespace

MethodEntry pointMethod()
{
    MethodEntry entry;
    entry.name = "point";
    entry.title = "Point";
    entry.about = "The texel under the centre, whatever the footprint.";
    entry.claims = {.rotationFree = Claim::Yes, .levelContinuous = Claim::Yes};
    entry.make = [](double) { return perQueryMethod(pointAnswer); };
    return entry;
}

} // namespace trixel
