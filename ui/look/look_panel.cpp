// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/look/look_panel.h"

#include <QCheckBox>
#include <QFormLayout>
#include <QLabel>
#include <QLocale>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/docks/value_row.h"
#include "ui/document/document.h"
#include "ui/document/inspection.h"
#include "ui/look/channel_row.h"
#include "ui/look/histogram_view.h"
#include "ui/look/look_commands.h"
#include "ui/look/look_words.h"
#include "ui/look/mark_table.h"
#include "ui/look/value_spin.h"
#include "ui/viewport/view_settings.h"

#include <algorithm>
#include <cmath>

namespace trixel::ui {

namespace {

constexpr int kProgressSteps = 100;
constexpr double kOutliers = 0.001; // of the values, at either end

bool isInteger(TexelType type)
{
    return type == TexelType::UInt8 || type == TexelType::UInt16;
}

QPushButton* smallButton(const QString& text, const QString& name, const QString& toolTip)
{
    auto* button = new QPushButton(text);
    button->setAccessibleName(name);
    button->setToolTip(toolTip);
    button->setMinimumWidth(20);
    return button;
}

} // namespace

LookPanel::LookPanel(const Document& document,
                     ViewSettings& settings,
                     Inspection& inspection,
                     QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_settings(settings)
    , m_survey(new ValueSurvey(document, settings, this))
    , m_channels(new ChannelRow(document, settings))
    , m_marks(new MarkTable(document, settings, *m_survey, inspection))
{
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 8, 8, 8);
    layout->setSpacing(6);
    layout->addWidget(m_channels);
    layout->addWidget(makeExposure());
    layout->addWidget(makeValues(), 1);
    layout->addWidget(makeRange());
    layout->addWidget(makeSwitches());
    layout->addWidget(m_marks);
    m_reset = new QPushButton(tr("Reset A&ll"));
    m_reset->setAccessibleName(tr("Reset the look"));
    m_reset->setToolTip(tr("Show values as they are again (Ctrl+Home)"));
    layout->addWidget(m_reset, 0, Qt::AlignLeft);
    connect(m_reset, &QPushButton::clicked, this, [this] { m_settings.setLook({}); });
    connect(&settings, &ViewSettings::lookChanged, this, &LookPanel::showLook);
    connect(m_survey, &ValueSurvey::changed, this, &LookPanel::showSurvey);
    connect(m_survey, &ValueSurvey::progressed, this, &LookPanel::showProgress);
    connect(&document, &Document::opened, this, &LookPanel::showLook);
    showLook();
}

QWidget* LookPanel::makeExposure()
{
    auto* box = new QWidget;
    auto* row = new QHBoxLayout(box);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(6);
    m_exposure = new ValueRow(
        Scale::Linear,
        double{-kMostStops},
        double{kMostStops},
        {tr("Exposure"),
         tr("Stops: each doubles what values count before the range (Ctrl+Up and Ctrl+Down)"),
         {}});
    auto* label = new QLabel(tr("&Exposure"));
    label->setBuddy(m_exposure->buddy());
    auto* zero = new QToolButton;
    zero->setText("0");
    zero->setAccessibleName(tr("No exposure"));
    zero->setToolTip(tr("Set the exposure to 0 stops"));
    row->addWidget(label);
    row->addWidget(m_exposure, 1);
    row->addWidget(zero);
    const auto set = [this](double stops) {
        render::Look look = m_settings.look();
        look.exposure = static_cast<float>(stops);
        m_settings.setLook(look);
    };
    connect(m_exposure, &ValueRow::edited, this, set);
    connect(zero, &QToolButton::clicked, this, [set] { set(0); });
    return box;
}

QWidget* LookPanel::makeValues()
{
    auto* box = new QWidget;
    auto* column = new QVBoxLayout(box);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(3);
    auto* head = new QHBoxLayout;
    m_summary = new QLabel;
    m_summary->setToolTip(tr("Least and greatest value of the texels, of what the look shows"));
    m_summary->setMinimumWidth(40);
    m_summary->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    m_progress = new QProgressBar;
    m_progress->setRange(0, kProgressSteps);
    m_progress->setFixedWidth(70);
    m_progress->setTextVisible(false);
    m_progress->setMaximumHeight(10);
    m_progress->setAccessibleName(tr("Counting values"));
    m_progress->setToolTip(tr("How far the counting of values is"));
    m_progress->hide();
    auto* logarithmic = new QToolButton;
    logarithmic->setText(tr("Log"));
    logarithmic->setCheckable(true);
    logarithmic->setChecked(true);
    logarithmic->setStyleSheet("QToolButton:checked { background: palette(highlight); "
                               "color: palette(highlighted-text); border-radius: 3px; }");
    logarithmic->setAccessibleName(tr("Logarithmic heights"));
    logarithmic->setToolTip(tr("Draw the logarithm of how often a value occurs, so that rare "
                               "values show"));
    head->addWidget(m_summary, 1);
    head->addWidget(m_progress);
    head->addWidget(logarithmic);
    m_histogram = new HistogramView;
    column->addLayout(head);
    column->addWidget(m_histogram, 1);
    connect(logarithmic, &QToolButton::toggled, m_histogram, &HistogramView::setLogarithmic);
    connect(m_histogram, &HistogramView::rangeEdited, this, [this](float black, float white) {
        m_settings.setLook(ranged(m_settings.look(), black, white));
    });
    return box;
}

QWidget* LookPanel::makeRange()
{
    auto* box = new QWidget;
    auto* column = new QVBoxLayout(box);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(4);
    const auto field = [&](const QString& name, const QString& toolTip) {
        auto* spin = new ValueSpin;
        spin->setAccessibleName(name);
        spin->setToolTip(toolTip);
        return spin;
    };
    m_black = field(tr("Value shown black"), tr("The stored value that is shown black"));
    m_white = field(tr("Value shown white"), tr("The stored value that is shown white"));
    auto* ends = new QHBoxLayout;
    ends->setSpacing(6);
    auto* black = new QLabel(tr("&Black"));
    black->setBuddy(m_black);
    auto* white = new QLabel(tr("&White"));
    white->setBuddy(m_white);
    ends->addWidget(black);
    ends->addWidget(m_black, 1);
    ends->addSpacing(4);
    ends->addWidget(white);
    ends->addWidget(m_white, 1);
    column->addLayout(ends);

    QPushButton* all = smallButton(
        tr("&Fit"), tr("Fit the range"), tr("From the least value to the greatest (R)"));
    QPushButton* most = smallButton(tr("Fit 99.8 %"),
                                    tr("Fit the range without outliers"),
                                    tr("From the value that 0.1 % of all are below to the one that "
                                       "0.1 % are above (Shift+R)"));
    QPushButton* unit =
        smallButton(tr("0 to 1"), tr("Range from 0 to 1"), tr("Black at 0 and white at 1"));
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(6);
    buttons->addWidget(all);
    buttons->addWidget(most);
    buttons->addWidget(unit);
    buttons->addStretch(1);
    column->addLayout(buttons);
    connect(m_black, &QDoubleSpinBox::valueChanged, this, [this](double value) {
        setRange(value, double{m_settings.look().whiteValue()});
    });
    connect(m_white, &QDoubleSpinBox::valueChanged, this, [this](double value) {
        setRange(double{m_settings.look().blackValue()}, value);
    });
    connect(all, &QPushButton::clicked, this, [this] { fitRange(false); });
    connect(most, &QPushButton::clicked, this, [this] { fitRange(true); });
    connect(unit, &QPushButton::clicked, this, [this] { setRange(0, 1); });
    return box;
}

QCheckBox*
LookPanel::makeSwitch(const QString& text, const QString& toolTip, bool render::Look::*member)
{
    auto* box = new QCheckBox(text);
    box->setToolTip(toolTip);
    box->setAccessibleName(QString(text).remove('&'));
    connect(box, &QCheckBox::toggled, this, [this, member](bool on) {
        render::Look look = m_settings.look();
        look.*member = on;
        m_settings.setLook(look);
    });
    return box;
}

QWidget* LookPanel::makeSwitches()
{
    auto* box = new QWidget;
    auto* column = new QVBoxLayout(box);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(4);
    m_falseColor = makeSwitch(tr("False &colour"),
                              tr("Show the number in colours from dark blue to light yellow, which "
                                 "every kind of eye tells apart; of colours the luminance (J)"),
                              &render::Look::falseColor);
    m_opaque = makeSwitch(tr("Without &opacity"),
                          tr("Show colours as if everything were opaque"),
                          &render::Look::opaque);
    m_showMarks = makeSwitch(tr("&Mark values that no colour shows"),
                             tr("Fill texels with such values by a colour and a pattern (N)"),
                             &render::Look::marks);
    auto* row = new QHBoxLayout;
    row->addWidget(m_falseColor);
    row->addWidget(m_opaque);
    row->addStretch(1);
    column->addLayout(row);
    column->addWidget(m_showMarks);
    return box;
}

void LookPanel::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    setSeen(true);
}

void LookPanel::hideEvent(QHideEvent* event)
{
    QWidget::hideEvent(event);
    setSeen(false);
}

void LookPanel::setSeen(bool seen)
{
    m_isSeen = seen;
    m_survey->setWanted(seen || m_fit != Fit::None);
    showSurvey();
}

void LookPanel::setRange(double black, double white)
{
    m_settings.setLook(
        ranged(m_settings.look(), static_cast<float>(black), static_cast<float>(white)));
    showLook(); // a range of no width is taken back
}

void LookPanel::showLook()
{
    const render::Look& look = m_settings.look();
    m_exposure->setValue(double{look.exposure});
    const double black = double{look.blackValue()};
    const double white = double{look.whiteValue()};
    for (const auto& [field, value] : {std::pair(m_black, black), std::pair(m_white, white)}) {
        const QSignalBlocker quiet(field);
        field->setValue(value);
        field->setSingleStep(std::abs(white - black) / 50);
    }
    for (const auto& [box, on] : {std::pair(m_falseColor, look.falseColor),
                                  std::pair(m_opaque, look.opaque),
                                  std::pair(m_showMarks, look.marks)}) {
        const QSignalBlocker quiet(box);
        box->setChecked(on);
    }
    m_opaque->setVisible(m_document.isOpen() && m_document.texels().format().alpha);
    m_histogram->setLook(look);
    m_reset->setEnabled(look != render::Look());
    showSurvey();
}

QString LookPanel::summary() const
{
    if (!m_document.isOpen()) {
        return tr("Open a mesh to see its values");
    }
    const TexelFormat& format = m_document.texels().format();
    float least = std::numeric_limits<float>::infinity();
    float greatest = -least;
    for (const TexelNumber& number : numbersShown(format, m_settings.look())) {
        const auto histogram = m_survey->histogram(number);
        if (histogram && histogram->summary().finite() > 0) {
            least = std::min(least, histogram->summary().least);
            greatest = std::max(greatest, histogram->summary().greatest);
        }
    }
    const QString name = shownName(format, m_settings.look());
    return least <= greatest
               ? tr("%1: %2 to %3").arg(name, valueText(double{least}), valueText(double{greatest}))
               : name;
}

/// What the counting came to; costs nothing while the panel is out of sight.
void LookPanel::showSurvey()
{
    showProgress();
    if (m_fit != Fit::None && m_survey->isCurrent()) {
        fit();
    }
    if (!m_isSeen) {
        return;
    }
    std::vector<HistogramView::Curve> curves;
    if (m_document.isOpen()) {
        const TexelFormat& format = m_document.texels().format();
        for (const TexelNumber& number : numbersShown(format, m_settings.look())) {
            if (auto histogram = m_survey->histogram(number)) {
                curves.push_back({numberName(format, number),
                                  number.weights ? QColor(0xc8, 0xc8, 0xcc)
                                                 : channelColor(format, number.channel),
                                  std::move(histogram)});
            }
        }
        m_histogram->setCurves(std::move(curves), isInteger(format.type));
    } else {
        m_histogram->setCurves({}, true);
    }
    m_summary->setText(summary());
    m_marks->showCounts();
}

void LookPanel::showProgress()
{
    const double fraction = m_survey->fraction();
    m_progress->setVisible(fraction < 1 && fraction > 0);
    m_progress->setValue(static_cast<int>(fraction * kProgressSteps));
}

void LookPanel::fitRange(bool withoutOutliers)
{
    m_fit = withoutOutliers ? Fit::WithoutOutliers : Fit::All;
    m_survey->setWanted(true);
    if (m_survey->isCurrent()) {
        fit();
    }
}

void LookPanel::fit()
{
    const TexelFormat& format = m_document.texels().format();
    double black = std::numeric_limits<double>::infinity();
    double white = -black;
    for (const TexelNumber& number : numbersShown(format, m_settings.look())) {
        const auto histogram = m_survey->histogram(number);
        if (!histogram) {
            return; // comes with the next answer
        }
        const bool isOpacity = m_settings.look().channel != number.channel && !number.weights &&
                               format.alpha == number.channel;
        const double outside = m_fit == Fit::WithoutOutliers ? kOutliers : 0;
        const auto low = histogram->quantile(outside);
        const auto high = histogram->quantile(1 - outside);
        if (low && high && !isOpacity) { // which the range is not for
            black = std::min(black, double{*low});
            white = std::max(white, double{*high});
        }
    }
    m_fit = Fit::None;
    m_survey->setWanted(m_isSeen);
    if (black < white) {
        setRange(black, white);
    } else if (black == white) { // all alike: shown as the middle
        const double around = std::max(std::abs(black) * 0.01, 1e-3);
        setRange(black - around, white + around);
    }
}

} // namespace trixel::ui
