// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inspector/mip_view.h"

#include <QElapsedTimer>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QPainter>
#include <QToolTip>

#include "ui/inspector/mip_focus.h"
#include "ui/inspector/mip_text.h"
#include "ui/viewport/view_settings.h"

#include <algorithm>
#include <ranges>

namespace trixel::ui {

namespace {

constexpr QSize kWanted(420, 260);
constexpr QSize kSmallest(200, 120);
/// Pictures are made for so long at a time.
constexpr int kBudgetMs = 4;
/// A third line of the labels takes room from small pictures.
constexpr double kHighEnough = 280;

} // namespace

MipView::MipView(MipFocus& focus, const ViewSettings& settings, QWidget* parent)
    : QWidget(parent)
    , m_focus(focus)
    , m_settings(settings)
{
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setAttribute(Qt::WA_OpaquePaintEvent);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setAccessibleName(tr("Levels of the face, side by side"));
    const auto redraw = qOverload<>(&QWidget::update);
    connect(&focus, &MipFocus::faceChanged, this, [this] {
        m_pictures.forget();
        update();
    });
    connect(&focus, &MipFocus::texelChanged, this, redraw);
    connect(&settings, &ViewSettings::lookChanged, this, redraw);
}

void MipView::setOptions(const MipOptions& options)
{
    if (!(m_options == options)) {
        if (!(m_options.arrangement == options.arrangement)) {
            m_pictures.forget();
        }
        m_options = options;
        update();
    }
}

QSize MipView::sizeHint() const
{
    return kWanted;
}

QSize MipView::minimumSizeHint() const
{
    return kSmallest;
}

std::vector<MipCell> MipView::cells() const
{
    return cellsIn(size(), font());
}

std::vector<MipCell> MipView::cellsIn(QSizeF size, const QFont& font) const
{
    if (!m_focus.face()) {
        return {};
    }
    const int lines = size.height() >= kHighEnough ? 3 : 2;
    return placeMips(
        m_focus.base(), size, m_options.arrangement, QFontMetricsF(font).lineSpacing(), lines);
}

MipInk MipView::ink() const
{
    return {palette().color(QPalette::WindowText),
            palette().color(QPalette::PlaceholderText),
            palette().color(QPalette::Mid),
            font()};
}

bool MipView::isComplete() const
{
    const std::vector<MipCell> all = cells();
    return m_focus.levels() != nullptr && std::ranges::all_of(all, [this](const MipCell& cell) {
               return m_pictures.picture(cell) != nullptr;
           });
}

bool MipView::event(QEvent* event)
{
    if (event->type() == QEvent::ToolTip) {
        const auto* help = static_cast<QHelpEvent*>(event);
        QToolTip::showText(help->globalPos(), tipAt(help->pos()), this);
        return true;
    }
    if (event->type() == QEvent::StyleChange || event->type() == QEvent::FontChange) {
        m_pictures.forget();
    }
    return QWidget::event(event);
}

void MipView::paintEvent(QPaintEvent* /*event*/)
{
    QPainter painter(this);
    painter.fillRect(rect(), palette().color(QPalette::Window));
    const std::vector<MipCell> all = cells();
    if (all.empty()) {
        painter.setPen(palette().color(QPalette::PlaceholderText));
        painter.drawText(rect().adjusted(12, 12, -12, -12),
                         Qt::AlignCenter | Qt::TextWordWrap,
                         tr("Point at a face in the view to see all its levels."));
        return;
    }
    m_pictures.setStyle({m_options.content, m_settings.look(), devicePixelRatioF()});
    makePictures(all);
    MipPainter(m_focus, m_options, m_pictures, ink()).paint(painter, all);
    if (hasFocus()) {
        painter.setPen(palette().color(QPalette::Highlight));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
    }
    if (m_focus.levels() != nullptr && !isComplete()) {
        QMetaObject::invokeMethod(this, qOverload<>(&QWidget::update), Qt::QueuedConnection);
    }
}

void MipView::paintOnto(QPainter& painter, QSizeF size, const MipInk& ink, double scale) const
{
    const std::vector<MipCell> all = cellsIn(size, ink.font);
    MipPictures pictures;
    pictures.setStyle({m_options.content, m_settings.look(), scale});
    for (const MipCell& cell : all) {
        if (m_focus.levels() != nullptr) {
            pictures.make(cell, *m_focus.levels());
        }
    }
    MipPainter(m_focus, m_options, pictures, ink).paint(painter, all);
}

void MipView::makePictures(const std::vector<MipCell>& cells)
{
    if (m_focus.levels() == nullptr) {
        return;
    }
    QElapsedTimer timer;
    timer.start();
    for (const MipCell& cell : std::views::reverse(cells)) {
        if (timer.elapsed() >= kBudgetMs) {
            return;
        }
        if (m_pictures.picture(cell) == nullptr) {
            m_pictures.make(cell, *m_focus.levels());
        }
    }
}

std::optional<MipView::Hit> MipView::hitAt(QPointF position) const
{
    const glm::dvec2 point(position.x(), position.y());
    for (const MipCell& cell : cells()) {
        const std::optional<TexelCoord> texel = cell.layout.texelAt(cell.level, point);
        if (!texel) {
            continue;
        }
        // A pixel of the square has no places in it: its texel's middle stands for it.
        const glm::dvec2 uv = cell.layout.texels() == FaceLayout::Texels::Triangles
                                  ? cell.layout.map().inverse().point(point)
                                  : centroid(cell.level, *texel);
        return Hit{cell.level, *texel, glm::vec2(uv)};
    }
    return std::nullopt;
}

void MipView::mouseMoveEvent(QMouseEvent* event)
{
    if (const auto hit = hitAt(event->position())) {
        m_focus.pointAt(hit->level, hit->uv);
    } else {
        m_focus.pointAway();
    }
}

void MipView::mousePressEvent(QMouseEvent* event)
{
    const auto hit = hitAt(event->position());
    if (hit && event->button() == Qt::LeftButton) {
        m_focus.hold(hit->level, hit->uv);
    }
}

void MipView::leaveEvent(QEvent* event)
{
    m_focus.pointAway();
    QWidget::leaveEvent(event);
}

/// \param steps  to coarser levels
void MipView::chooseBeside(int steps)
{
    const int level = std::clamp(m_focus.level().log2() - steps, 0, m_focus.base().log2());
    m_focus.choose(Level(level));
}

void MipView::keyPressEvent(QKeyEvent* event)
{
    if (!m_focus.face()) {
        QWidget::keyPressEvent(event);
        return;
    }
    switch (event->key()) {
    case Qt::Key_Right:
    case Qt::Key_Down:
        chooseBeside(1);
        break;
    case Qt::Key_Left:
    case Qt::Key_Up:
        chooseBeside(-1);
        break;
    case Qt::Key_Home:
        m_focus.choose(m_focus.base());
        break;
    case Qt::Key_End:
        m_focus.choose(Level(0));
        break;
    case Qt::Key_Space:
        m_focus.toggleHold();
        break;
    case Qt::Key_Escape:
        m_focus.letGo();
        break;
    default:
        QWidget::keyPressEvent(event);
    }
}

QString MipView::tipAt(QPointF position) const
{
    const auto hit = hitAt(position);
    if (!hit) {
        return tr("All levels of the face, each with half as many texels a side. Arrow keys choose "
                  "the level whose texel counts, Space holds the texel.");
    }
    const PackedPixel pixel = packedPixel(hit->level, hit->texel);
    const QString texel = tr("%1, texel %2, pixel %3, %4 of the packed square")
                              .arg(levelText(hit->level), texelText(hit->texel))
                              .arg(pixel.x)
                              .arg(pixel.y);
    return hit->level == m_focus.shown()
               ? texel
               : texel + "\n" +
                     tr("The view looks at the texel of its own level (%1) that lies there.")
                         .arg(m_focus.shown().log2());
}

} // namespace trixel::ui
