// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/look/look_overlay.h"

#include <QEvent>
#include <QToolButton>

#include "ui/document/document.h"
#include "ui/look/look_legend.h"
#include "ui/look/look_words.h"
#include "ui/viewport/view_settings.h"
#include "ui/viewport/viewport.h"

#include <algorithm>

namespace trixel::ui {

namespace {

constexpr int kMargin = 8;

// Stands out over any texels and in either theme.
constexpr auto kStyle = "QToolButton { background: #ffcf4d; color: #1b1b1d; border: 1px solid "
                        "#1b1b1d; border-radius: 4px; padding: 3px 8px; }"
                        "QToolButton:hover { background: #ffe08a; }"
                        "QToolButton:pressed { background: #e0b030; }";

bool showsTexels(ViewMapKind map)
{
    return map == ViewMapKind::None || map == ViewMapKind::Filtered;
}

} // namespace

LookOverlay::LookOverlay(const Document& document, ViewSettings& settings, Viewport& viewport)
    : QObject(&viewport)
    , m_document(document)
    , m_settings(settings)
    , m_viewport(viewport)
    , m_chip(new QToolButton(&viewport))
    , m_legend(new LookLegend(&viewport))
{
    m_chip->setObjectName("lookChip");
    m_chip->setStyleSheet(kStyle);
    m_chip->setCursor(Qt::ArrowCursor);
    m_chip->setFocusPolicy(Qt::NoFocus); // the keyboard has Ctrl+Home
    m_chip->setToolTip(tr("Texels are not shown as they are. Click to reset the look (Ctrl+Home)"));
    m_chip->hide();
    viewport.installEventFilter(this);
    connect(m_chip, &QToolButton::clicked, this, [this] { m_settings.setLook({}); });
    connect(&settings, &ViewSettings::lookChanged, this, &LookOverlay::showLook);
    connect(&settings, &ViewSettings::viewChanged, this, &LookOverlay::showLook);
    connect(&document, &Document::opened, this, &LookOverlay::showLook);
    connect(&viewport, &Viewport::hovered, this, &LookOverlay::takeHovered);
    showLook();
}

void LookOverlay::showLook()
{
    const bool isOpen = m_document.isOpen();
    const TexelFormat format = isOpen ? m_document.texels().format() : TexelFormat();
    const render::Look& look = m_settings.look();
    m_words = isOpen ? describe(format, look) : QString();
    m_chip->setAccessibleName(tr("Reset the look: %1").arg(m_words));
    m_chip->setVisible(!m_words.isEmpty());
    m_legend->setLook(format, look);
    m_legend->setVisible(isOpen && m_legend->isWanted() && showsTexels(m_settings.view().map));
    place();
}

void LookOverlay::place()
{
    int top = kMargin;
    if (!m_chip->isHidden()) {
        const QString whole = tr("%1 — reset").arg(m_words);
        const int most = std::max(40, m_viewport.width() - 2 * kMargin);
        m_chip->setText(m_chip->fontMetrics().elidedText(whole, Qt::ElideRight, most - 24));
        m_chip->adjustSize();
        m_chip->move(kMargin, top);
        top += m_chip->height() + kMargin / 2;
    }
    m_legend->place(top);
}

bool LookOverlay::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::Resize) {
        place();
    }
    return QObject::eventFilter(watched, event);
}

/// The number on the scale that the texel under the pointer has.
void LookOverlay::takeHovered(const std::optional<HoveredTexel>& texel)
{
    if (!m_settings.look().falseColor || !texel || !m_document.isOpen()) {
        m_legend->setValue(std::nullopt);
        return;
    }
    const TexelFormat& format = m_document.texels().format();
    if (texel->values.size() != format.channels) {
        return;
    }
    const render::LookRule rule = render::LookRule::of(format, m_settings.look());
    m_legend->setValue(render::numberOf(rule, texel->values));
}

} // namespace trixel::ui
