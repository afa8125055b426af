// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/frame_hud.h"

#include <QFontDatabase>
#include <QLocale>
#include <QPainter>

#include "ui/viewport/filtering_words.h"

#include <algorithm>

namespace trixel::ui {

namespace {

constexpr int kMargin = 8;
constexpr int kPadding = 8;
constexpr int kGap = 16; // between a name and its figure
constexpr int kTurnMs = 250;

QString milliseconds(double ms)
{
    return FrameHud::tr("%1 ms").arg(ms, 0, 'f', ms < 10 ? 2 : 1);
}

QString count(std::uint64_t number)
{
    return QLocale().toString(static_cast<qulonglong>(number));
}

QString bytes(std::uint64_t number)
{
    return QLocale().formattedDataSize(static_cast<qint64>(number), 1);
}

} // namespace

FrameHud::FrameHud(QWidget* view)
    : QWidget(view)
{
    setAccessibleName(tr("Figures of the frame"));
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
    m_turn.setSingleShot(true);
    m_turn.setInterval(kTurnMs);
    connect(&m_turn, &QTimer::timeout, this, [this] { write(m_latest); });
    hide();
}

void FrameHud::take(const render::FrameFigures& figures)
{
    m_latest = figures;
    m_longest = std::max(m_longest, figures.processorMs);
    if (isHidden() || m_turn.isActive()) {
        return;
    }
    // The first frame after a pause is written at once, the card's time of it when it is known.
    m_turn.start();
    if (m_lines.empty()) {
        write(figures);
    }
}

void FrameHud::write(const render::FrameFigures& figures)
{
    std::vector<Line> lines;
    lines.emplace_back(tr("CPU"), milliseconds(m_longest));
    lines.emplace_back(tr("GPU"),
                       figures.cardMs ? milliseconds(*figures.cardMs) : tr("no clock yet"));
    lines.emplace_back(tr("Filtering"), filteringTitle(figures.filtering));
    lines.emplace_back(tr("Level"),
                       figures.levelsDropped == 0 ? tr("full")
                                                  : tr("%1 coarser").arg(figures.levelsDropped));
    lines.emplace_back(tr("Faces"), count(figures.faces));
    if (figures.triangles != figures.faces) {
        lines.emplace_back(tr("Triangles"), count(figures.triangles));
    }
    if (figures.surfaceError) {
        lines.emplace_back(tr("Off by"), tr("%1 px").arg(*figures.surfaceError, 0, 'f', 2));
    }
    lines.emplace_back(tr("Texels"), count(figures.texels));
    lines.emplace_back(
        tr("On the card"),
        figures.budgetBytes == 0
            ? bytes(figures.residentBytes)
            : tr("%1 of %2").arg(bytes(figures.residentBytes), bytes(figures.budgetBytes)));
    m_longest = 0;
    if (lines == m_lines) {
        return;
    }
    m_lines = std::move(lines);
    place();
    update();
}

QSize FrameHud::sizeHint() const
{
    const QFontMetrics metrics = fontMetrics();
    int names = 0;
    int figures = 0;
    for (const auto& [name, figure] : m_lines) {
        names = std::max(names, metrics.horizontalAdvance(name));
        figures = std::max(figures, metrics.horizontalAdvance(figure));
    }
    return {names + kGap + figures + 2 * kPadding,
            static_cast<int>(m_lines.size()) * metrics.lineSpacing() + 2 * kPadding};
}

void FrameHud::place()
{
    // Never narrower than before: figures that come and go would make it jump.
    resize(sizeHint().expandedTo({m_lines.empty() ? 0 : width(), 0}));
    move(parentWidget()->width() - width() - kMargin,
         parentWidget()->height() - height() - kMargin);
}

void FrameHud::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.fillRect(rect(), QColor(22, 22, 24, 205)); // readable over any texels, in either theme
    const QFontMetrics metrics = fontMetrics();
    int y = kPadding + metrics.ascent();
    for (const auto& [name, figure] : m_lines) {
        painter.setPen(QColor(0x9c9ca0));
        painter.drawText(kPadding, y, name);
        painter.setPen(QColor(0xe4e4e6));
        painter.drawText(width() - kPadding - metrics.horizontalAdvance(figure), y, figure);
        y += metrics.lineSpacing();
    }
}

} // namespace trixel::ui
