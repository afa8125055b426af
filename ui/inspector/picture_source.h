// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSize>
#include <QString>

class QPainter;

namespace trixel::ui {

/// Something that a picture for a paper or a ticket can be made of. A panel that draws itself
/// implements it beside QWidget, or one of the widgets in it does; of a panel that does not, the
/// picture is its widgets as they are.
class PictureSource
{
public:
    virtual ~PictureSource() = default;

    /// For the name of a file, as "layout".
    virtual QString pictureName() const = 0;
    /// In units of the screen, 1/96 inch; empty when there is nothing to show.
    virtual QSize pictureSize() const = 0;
    /// Whether it is drawn by lines, areas and letters, so that it is as sharp at any size.
    virtual bool isVectorPicture() const = 0;
    /// Draws background, content and legend into (0, 0, size). The painter may draw onto paper:
    /// nothing is cached in pixels of the screen.
    virtual void paintPicture(QPainter& painter, QSize size) = 0;
};

} // namespace trixel::ui
