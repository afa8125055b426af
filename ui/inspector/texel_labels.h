// SPDX-License-Identifier: GPL-3.0-or-later
//
// Numbers printed inside texels, once they are large enough.
#pragma once

#include <QFont>
#include <QRectF>
#include <QStringList>

#include "core/lattice/face_layout.h"
#include "core/texture/face_texels.h"
#include "core/texture/texel_format.h"

#include <cstdint>
#include <functional>
#include <optional>

class QPainter;

namespace trixel::ui {

/// What is printed in a texel.
struct TexelWords
{
    bool values = true;   ///< as they are stored, one a channel
    bool indices = false; ///< its place in the face's storage
    /// The only channel whose value is printed.
    std::optional<std::uint16_t> channel;
};

/// The lines of a texel: its index, then its values; of many channels the first four.
QStringList linesOf(const TexelFormat& format,
                    const FaceTexels& texels,
                    TexelCoord texel,
                    const TexelWords& words);

/// How much larger a block of text could be before it leaves a texel that it is centred in; less
/// than 1 where it does not fit. \param size  of the text, in the outline's units
double roomFor(const TexelOutline& outline, glm::dvec2 centre, QSizeF size);

/// Prints into every texel that is seen in the area; nothing where the longest text does not fit.
/// \param layout  in the painter's units, as the area
/// \param background  the colour that a texel has on the screen: text is dark or light by it
/// \return  whether texts could be read
bool drawTexelLabels(QPainter& painter,
                     const QFont& font,
                     const FaceLayout& layout,
                     const QRectF& area,
                     const TexelFormat& format,
                     const FaceTexels& texels,
                     const TexelWords& words,
                     const std::function<QColor(TexelCoord)>& background);

} // namespace trixel::ui
