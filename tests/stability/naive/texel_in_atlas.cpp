// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/stability/naive_forms.h"

namespace trixel {

TexelCoord texelAt(Level level, glm::dvec2 uv)
{
    return naive::texelInAtlas(level, uv);
}

} // namespace trixel
