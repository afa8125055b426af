// SPDX-License-Identifier: GPL-3.0-or-later
//
// Footprints from the derivatives of the screen position, as renderers have them.
#pragma once

#include "core/footprint/footprint.h"

namespace trixel {

/// How the screen position (a,b), in pixels, changes with (u,v): the columns of the matrix F that
/// maps (du,dv) to (da,db).
struct ScreenDerivatives
{
    glm::dvec2 perU{0}; ///< (da/du, db/du)
    glm::dvec2 perV{0}; ///< (da/dv, db/dv)
};

/// The textbook's inverse Jacobian: du/da = db/dv / det, and so on. Not finite where det is 0 and
/// without digits near it: kept to be compared with, not to be used.
Footprint inverseJacobian(const ScreenDerivatives& derivatives);

/// The footprint of a pixel without inverting: with the singular values σ1 >= σ2 of F the lengths
/// are minor = 1/max(σ1, 1/maxLength) and major = 1/max(σ2, 1/maxLength), σ2 = |det|/σ1, along the
/// directions of FᵀF. Finite for every input and equal to the textbook's where that needs no limit.
/// Anisotropy is not limited here, filters do that. A derivative that is not finite gives the
/// widest footprint.
/// \param maxLength  in uv
Footprint footprintOf(const ScreenDerivatives& derivatives, double maxLength = 64.0);

} // namespace trixel
