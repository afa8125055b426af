// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>

#include "core/texture/mip_comparison.h"
#include "render/look.h"
#include "ui/inspector/mip_cells.h"

#include <array>

namespace trixel::ui {

/// Which of a face's two reductions is shown, or what lies between them.
enum class MipContent { Right, Box, Difference };

/// The drawn levels of one face, kept until something about them changes.
class MipPictures
{
public:
    /// What the pictures depend on besides the texels; another empties them.
    struct Style
    {
        MipContent content = MipContent::Right;
        render::Look look;
        double pixelRatio = 1;

        bool operator==(const Style&) const = default;
    };

    void forget();
    void setStyle(const Style& style);

    /// The cell's picture, one of its size; null before it is made.
    const QImage* picture(const MipCell& cell) const;
    void make(const MipCell& cell, const MipComparison& levels);

private:
    Style m_style;
    std::array<QImage, Level::kMax + 1> m_images;
};

} // namespace trixel::ui
