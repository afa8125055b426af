// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/inspector/picture_source.h"

namespace trixel::ui {

class Viewport;

/// The view as shown, with the legends that lie over it.
class ViewPicture final : public PictureSource
{
public:
    explicit ViewPicture(Viewport& view)
        : m_view(view)
    {
    }

    QString pictureName() const override { return "view"; }
    QSize pictureSize() const override;
    bool isVectorPicture() const override { return false; }
    /// The surface is drawn anew for the painter's density, but for a map: that has one colour for
    /// each pixel of the screen.
    void paintPicture(QPainter& painter, QSize size) override;

private:
    Viewport& m_view;
};

} // namespace trixel::ui
