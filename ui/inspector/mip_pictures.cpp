// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inspector/mip_pictures.h"

#include "ui/inspector/difference_colors.h"
#include "ui/inspector/face_painter.h"

#include <cmath>

namespace trixel::ui {

namespace {

QSize sizeOf(const MipCell& cell, double pixelRatio)
{
    return {static_cast<int>(std::ceil(cell.picture.width() * pixelRatio)),
            static_cast<int>(std::ceil(cell.picture.height() * pixelRatio))};
}

/// Of more texels than pixels their means are drawn: giving colours to all would take longer than
/// the window may be held up.
FaceTexels
asFineAsSeen(const TexelFormat& format, const FaceLayout& layout, const FaceTexels& texels)
{
    const Level seen = levelToDraw(layout, texels.level());
    return reduced(format, texels, texels.level().log2() - seen.log2());
}

std::size_t slot(Level level)
{
    return static_cast<std::size_t>(level.log2());
}

} // namespace

void MipPictures::forget()
{
    m_images.fill(QImage());
}

void MipPictures::setStyle(const Style& style)
{
    if (!(m_style == style)) {
        m_style = style;
        forget();
    }
}

const QImage* MipPictures::picture(const MipCell& cell) const
{
    const QImage& image = m_images[slot(cell.level)];
    return image.size() == sizeOf(cell, m_style.pixelRatio) ? &image : nullptr;
}

void MipPictures::make(const MipCell& cell, const MipComparison& levels)
{
    QImage image(sizeOf(cell, m_style.pixelRatio), QImage::Format_ARGB32_Premultiplied);
    image.fill(Qt::transparent);
    // From the widget's coordinates to the picture's pixels.
    const double scale = m_style.pixelRatio;
    const PlaneMap map{
        glm::dvec2(-cell.picture.left(), -cell.picture.top()) * scale, {scale, 0}, {0, scale}};
    const FaceLayout layout = cell.layout.moved(map);
    const auto paint =
        [&](const TexelFormat& format, const render::Look& look, const FaceTexels& texels) {
            ShadedTexels shades(format, look, texels.level());
            paintTexels(image, image.rect(), layout, texels, shades);
        };
    if (m_style.content == MipContent::Difference) {
        const FaceTexels colors =
            differenceTexels(levels, cell.level, m_style.look.channel, levels.worstDifference());
        paint(kDifferenceFormat, {}, asFineAsSeen(kDifferenceFormat, layout, colors));
    } else {
        const ReductionRule rule =
            m_style.content == MipContent::Box ? ReductionRule::Box : ReductionRule::Triangles;
        paint(levels.format(),
              m_style.look,
              asFineAsSeen(levels.format(), layout, levels.drawn(cell.level, rule)));
    }
    image.setDevicePixelRatio(scale);
    m_images[slot(cell.level)] = std::move(image);
}

} // namespace trixel::ui
