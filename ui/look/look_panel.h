// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "render/look.h"
#include "ui/look/value_survey.h"

class QCheckBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QToolButton;

namespace trixel::ui {

class ChannelRow;
class Document;
class HistogramView;
class Inspection;
class MarkTable;
class ValueRow;
class ValueSpin;
class ViewSettings;

/// How texel values become colours, in the view and in every panel that shows texels: channels,
/// exposure, the range over a histogram, false colour, and marks for values that no colour shows.
class LookPanel : public QWidget
{
    Q_OBJECT

public:
    LookPanel(const Document& document,
              ViewSettings& settings,
              Inspection& inspection,
              QWidget* parent = nullptr);

    /// The range from the least to the greatest value shown, or all but the outermost thousandth at
    /// either end. Waits for the counting where there is no current answer yet.
    void fitRange(bool withoutOutliers);

    const ValueSurvey& survey() const { return *m_survey; }
    HistogramView& histogram() { return *m_histogram; }
    MarkTable& marks() { return *m_marks; }

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    enum class Fit { None, All, WithoutOutliers };

    QWidget* makeExposure();
    QWidget* makeValues();
    QWidget* makeRange();
    QWidget* makeSwitches();
    QCheckBox* makeSwitch(const QString& text, const QString& toolTip, bool render::Look::*member);
    void setSeen(bool seen);
    void showLook();
    void showSurvey();
    void showProgress();
    QString summary() const;
    void fit();
    void setRange(double black, double white);

    const Document& m_document;
    ViewSettings& m_settings;
    ValueSurvey* m_survey;
    ChannelRow* m_channels;
    ValueRow* m_exposure = nullptr;
    HistogramView* m_histogram = nullptr;
    QProgressBar* m_progress = nullptr;
    QLabel* m_summary = nullptr;
    ValueSpin* m_black = nullptr;
    ValueSpin* m_white = nullptr;
    QCheckBox* m_falseColor = nullptr;
    QCheckBox* m_opaque = nullptr;
    QCheckBox* m_showMarks = nullptr;
    MarkTable* m_marks;
    QPushButton* m_reset = nullptr;
    Fit m_fit = Fit::None; ///< waits for the counting
    bool m_isSeen = false; ///< no values are counted while nobody sees the panel
};

} // namespace trixel::ui
