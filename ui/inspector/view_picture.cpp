// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inspector/view_picture.h"

#include <QPainter>

#include "ui/viewport/canvas.h"
#include "ui/viewport/viewport.h"

namespace trixel::ui {

QSize ViewPicture::pictureSize() const
{
    return m_view.canDraw() ? m_view.size() : QSize();
}

void ViewPicture::paintPicture(QPainter& painter, QSize size)
{
    const double density = painter.device()->devicePixelRatioF();
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.drawImage(QRect(QPoint(), size), m_view.picture(density));
    for (QWidget* over : m_view.findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly)) {
        if (over->isVisibleTo(&m_view) && qobject_cast<Canvas*>(over) == nullptr) {
            painter.save();
            painter.translate(over->pos());
            over->render(&painter, {}, {}, QWidget::DrawChildren | QWidget::IgnoreMask);
            painter.restore();
        }
    }
}

} // namespace trixel::ui
