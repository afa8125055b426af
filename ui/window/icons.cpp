// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/icons.h"

#include <QApplication>
#include <QFile>
#include <QIconEngine>
#include <QPainter>
#include <QPalette>
#include <QPixmap>
#include <QSvgRenderer>

#include "core/base/check.h"

namespace trixel::ui {

namespace {

QByteArray readIcon(const QString& name)
{
    QFile file(":/icons/" + name + ".svg");
    check(file.open(QIODevice::ReadOnly), "the icon is among the resources");
    return file.readAll();
}

/// Renders an SVG whose lines are `currentColor`.
class LineIconEngine final : public QIconEngine
{
public:
    LineIconEngine(QByteArray svg, const QColor& fixed)
        : m_svg(std::move(svg))
        , m_fixed(fixed)
    {
    }

    void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State state) override
    {
        QByteArray svg = m_svg;
        svg.replace("currentColor", colorOf(mode, state).name().toLatin1());
        QSvgRenderer(svg).render(painter, rect);
    }

    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override
    {
        QPixmap image(size);
        image.fill(Qt::transparent);
        QPainter painter(&image);
        paint(&painter, QRect(QPoint(), size), mode, state);
        return image;
    }

    QIconEngine* clone() const override { return new LineIconEngine(*this); }

private:
    QColor colorOf(QIcon::Mode mode, QIcon::State /*state*/) const
    {
        if (m_fixed.isValid()) {
            return m_fixed;
        }
        const QPalette palette = QApplication::palette();
        switch (mode) {
        case QIcon::Disabled:
            return palette.color(QPalette::Disabled, QPalette::ButtonText);
        case QIcon::Selected:
            return palette.color(QPalette::HighlightedText);
        default:
            return palette.color(QPalette::Active, QPalette::ButtonText);
        }
    }

    QByteArray m_svg;
    QColor m_fixed;
};

} // namespace

QIcon icon(const QString& name)
{
    return icon(name, QColor());
}

QIcon icon(const QString& name, const QColor& color)
{
    return QIcon(new LineIconEngine(readIcon(name), color)); // the icon owns its engine
}

} // namespace trixel::ui
