// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "ui/import/preview_work.h"

#include <memory>

class QRadioButton;

namespace trixel::ui {

class Viewport;

/// Chooses what the view shows while an image is brought in: the texels as they are, or as they
/// would be.
class ImportLook : public QWidget
{
    Q_OBJECT

public:
    /// \param viewport  outlives this
    explicit ImportLook(Viewport& viewport, QWidget* parent = nullptr);

    /// \param picture  null where there is none
    void setPicture(std::shared_ptr<const PreviewPicture> picture);
    /// Shows nothing while off, whatever is chosen.
    void setOn(bool on);

private:
    QRadioButton* addChoice(const QString& text, const QString& name, const QString& toolTip);
    void show();

    Viewport& m_viewport;
    std::shared_ptr<const PreviewPicture> m_picture;
    QRadioButton* m_before;
    QRadioButton* m_after;
    bool m_isOn = false;
    bool m_isShown = false; ///< the view shows the picture's texels
};

} // namespace trixel::ui
