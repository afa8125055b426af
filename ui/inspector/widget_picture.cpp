// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inspector/widget_picture.h"

#include <QPainter>

#include "ui/docks/chart_view.h"

namespace trixel::ui {

namespace {

/// One that lives in a widget.
class Borrowed final : public PictureSource
{
public:
    explicit Borrowed(PictureSource& source)
        : m_source(source)
    {
    }

    QString pictureName() const override { return m_source.pictureName(); }
    QSize pictureSize() const override { return m_source.pictureSize(); }
    bool isVectorPicture() const override { return m_source.isVectorPicture(); }
    void paintPicture(QPainter& painter, QSize size) override
    {
        m_source.paintPicture(painter, size);
    }

private:
    PictureSource& m_source;
};

/// Widgets as the screen shows them.
class Widgets final : public PictureSource
{
public:
    Widgets(QWidget& panel, const QString& name)
        : m_panel(panel)
        , m_name(name)
    {
    }

    QString pictureName() const override { return m_name; }
    QSize pictureSize() const override { return m_panel.size(); }
    bool isVectorPicture() const override { return false; }
    void paintPicture(QPainter& painter, QSize /*size*/) override
    {
        m_panel.render(&painter,
                       {},
                       {},
                       QWidget::DrawWindowBackground | QWidget::DrawChildren | QWidget::IgnoreMask);
    }

private:
    QWidget& m_panel;
    QString m_name;
};

/// A chart as it is exported: on white, with its heading and what is needed to repeat it.
class Chart final : public PictureSource
{
public:
    explicit Chart(const ChartView& view)
        : m_view(view)
    {
    }

    QString pictureName() const override { return "chart"; }
    QSize pictureSize() const override { return {960, 640}; }
    bool isVectorPicture() const override { return true; }
    void paintPicture(QPainter& painter, QSize size) override
    {
        const PlotFonts fonts(m_view.font());
        const PlotLook look{.theme = lightPlotTheme(),
                            .lettering = Lettering::Outlines,
                            .lifted = {},
                            .chosen = {}};
        paintPlot(painter, m_view.plot(), layOut(m_view.plot(), size, fonts, {}), fonts, look);
    }

private:
    const ChartView& m_view;
};

PictureSource* sourceIn(QWidget& panel)
{
    if (auto* source = dynamic_cast<PictureSource*>(&panel)) {
        return source;
    }
    PictureSource* found = nullptr;
    for (QWidget* widget : panel.findChildren<QWidget*>()) {
        auto* source = widget->isVisibleTo(&panel) ? dynamic_cast<PictureSource*>(widget) : nullptr;
        if (source != nullptr && found != nullptr) {
            return nullptr; // of several none is the panel's
        }
        found = source != nullptr ? source : found;
    }
    return found;
}

} // namespace

std::unique_ptr<PictureSource> pictureOf(QWidget& panel, const QString& name)
{
    if (PictureSource* source = sourceIn(panel)) {
        return std::make_unique<Borrowed>(*source);
    }
    const auto* chart = panel.findChild<ChartView*>();
    if (chart != nullptr && !chart->plot().isEmpty()) {
        return std::make_unique<Chart>(*chart);
    }
    return std::make_unique<Widgets>(panel, name);
}

} // namespace trixel::ui
