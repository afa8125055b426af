// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/footprint/footprint.h"

namespace trixel {

/// How a texture's (s,t) change with the (u,v) that a renderer derives by: the columns of their
/// Jacobian, constant over one primitive.
struct TextureDerivatives
{
    glm::dvec2 perU{1, 0}; ///< (ds/du, dt/du)
    glm::dvec2 perV{0, 1}; ///< (ds/dv, dt/dv)
};

/// A footprint in (u,v) as one in (s,t), by the chain rule:
/// W1 = (ds/du du/da + ds/dv dv/da, dt/du du/da + dt/dv dv/da), W2 the same with b. Each sum keeps
/// its digits where its two products almost cancel.
Footprint chained(const Footprint& inUv, const TextureDerivatives& map);

} // namespace trixel
