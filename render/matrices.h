// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMatrix4x4>

#include <glm/gtc/type_ptr.hpp>
#include <glm/mat4x4.hpp>

namespace trixel::render {

/// The same matrix as Qt has it.
inline QMatrix4x4 toQt(const glm::mat4& matrix)
{
    return QMatrix4x4(glm::value_ptr(matrix)).transposed(); // Qt reads rows
}

} // namespace trixel::render
