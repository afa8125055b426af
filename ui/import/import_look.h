// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "ui/import/distortion_work.h"
#include "ui/import/preview_work.h"

#include <memory>

class QBoxLayout;
class QComboBox;
class QRadioButton;

namespace trixel::ui {

class DistortionView;
class ViewSettings;
class Viewport;

/// Chooses what the view shows while an image is brought in: the texels as they are, as they would
/// be, or how the mapping distorts the image.
class ImportLook : public QWidget
{
    Q_OBJECT

public:
    /// They outlive this.
    ImportLook(Viewport& viewport, ViewSettings& settings, QWidget* parent = nullptr);

    /// \param picture  null where there is none
    void setPicture(std::shared_ptr<const PreviewPicture> picture);
    /// What to show the distortion of; nothing where there is no mapping.
    void setInput(std::optional<ImportInput> input);
    const DistortionView& distortion() const { return *m_distortion; }
    /// Shows nothing while off, whatever is chosen.
    void setOn(bool on);

private:
    QRadioButton*
    addChoice(QBoxLayout& row, const QString& text, const QString& name, const QString& toolTip);
    void show();
    void showDistortion();
    DistortionMeasure measure() const;

    Viewport& m_viewport;
    ViewSettings& m_settings;
    DistortionView* m_distortion;
    std::optional<ImportInput> m_input;
    std::shared_ptr<const PreviewPicture> m_picture;
    QRadioButton* m_before;
    QRadioButton* m_after;
    QRadioButton* m_distorted;
    QComboBox* m_measure;
    bool m_isOn = false;
    bool m_isShown = false; ///< the view shows the picture's texels
};

} // namespace trixel::ui
