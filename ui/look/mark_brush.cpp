// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/look/mark_brush.h"

#include <QImage>

namespace trixel::ui {

QBrush markBrush(render::Mark mark)
{
    constexpr int kTile = 8; // the period of every pattern
    QImage tile(kTile, kTile, QImage::Format_RGB32);
    for (int y = 0; y < kTile; ++y) {
        for (int x = 0; x < kTile; ++x) {
            const render::Rgba color =
                render::hasInk(mark, x, y) ? render::kMarkInk : render::markColor(mark);
            tile.setPixel(x, y, qRgb(color[0], color[1], color[2]));
        }
    }
    QBrush brush;
    brush.setTextureImage(tile);
    return brush;
}

} // namespace trixel::ui
