// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/footprint_legend.h"

#include "ui/viewport/surface_lines.h"

namespace trixel::ui {

namespace {

constexpr int kMargin = 8;

QString colored(const QString& text, glm::vec4 color)
{
    const QColor own = QColor::fromRgbF(color.r, color.g, color.b);
    return QString("<span style='color:%1'>%2</span>").arg(own.name(), text);
}

} // namespace

FootprintLegend::FootprintLegend(QWidget* view)
    : QLabel(view)
{
    setTextFormat(Qt::RichText);
    tellOfHovered();
    setAccessibleName(tr("What the lines of the footprint are"));
    setAttribute(Qt::WA_TransparentForMouseEvents);
    // Readable over any texels, in either theme.
    QPalette colors;
    colors.setColor(QPalette::WindowText, QColor(0xd8d8d8));
    colors.setColor(QPalette::Window, QColor(22, 22, 24, 205));
    setPalette(colors);
    setAutoFillBackground(true);
    setContentsMargins(6, 3, 6, 3);
    hide();
}

void FootprintLegend::tellOfHovered()
{
    setText(
        tr("%1 and %2 of what is looked at, drawn %3× larger")
            .arg(colored(tr("Pixel"), kParallelogramColor), colored(tr("ellipse"), kEllipseColor))
            .arg(kFootprintMagnification));
}

void FootprintLegend::tellOf(double magnification, bool withFrozen)
{
    QString text = tr("%1 and %2 of the footprint, %3")
                       .arg(colored(tr("W1, W2"), kParallelogramColor),
                            colored(tr("ellipse"), kEllipseColor),
                            magnification == 1.0 ? tr("as large as they are")
                                                 : tr("drawn %1× larger").arg(magnification));
    if (withFrozen) {
        text += tr("; %1").arg(colored(tr("frozen"), kFrozenColor));
    }
    setText(text);
}

void FootprintLegend::place()
{
    adjustSize();
    move(kMargin, parentWidget()->height() - height() - kMargin);
}

} // namespace trixel::ui
