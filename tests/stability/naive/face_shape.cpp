// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/stability/naive_forms.h"

namespace trixel {

FaceShape faceShapeOf(const std::array<glm::vec3, 3>& corners)
{
    return naive::faceShapeOf(corners);
}

} // namespace trixel
