// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/footprint/chain_rule.h"

#include "core/footprint/svd2.h"

namespace trixel {

namespace {

glm::dvec2 mapped(glm::dvec2 w, const TextureDerivatives& map)
{
    return {differenceOfProducts(map.perU.x, w.x, -map.perV.x, w.y),
            differenceOfProducts(map.perU.y, w.x, -map.perV.y, w.y)};
}

} // namespace

Footprint chained(const Footprint& inUv, const TextureDerivatives& map)
{
    return {mapped(inUv.w1, map), mapped(inUv.w2, map)};
}

} // namespace trixel
