// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/brush_actions.h"

#include <QMenu>

#include "ui/docks/brush_colors.h"
#include "ui/docks/brush_panel.h"
#include "ui/viewport/view_settings.h"
#include "ui/window/actions.h"

#include <algorithm>

namespace trixel::ui {

namespace {

constexpr float kRadiusStep = 1.15F;
constexpr float kHardnessStep = 0.1F;
constexpr float kOpacityStep = 0.1F;

} // namespace

BrushActions::BrushActions(ViewSettings& settings,
                           BrushColors& colors,
                           BrushPanel& panel,
                           QWidget& window)
    : QObject(&window)
    , m_settings(settings)
    , m_window(window)
{
    ActionMaker make(window);
    QAction* choose = make(tr("&Colour…"), tr("Choose the colour to paint with"));
    QAction* swap = make(tr("&Swap Colours"), tr("Paint with the other colour"), {Qt::Key_X});
    QAction* reset =
        make(tr("&Default Colours"), tr("Paint with black, swap with white"), {Qt::Key_D});
    connect(choose, &QAction::triggered, &panel, &BrushPanel::chooseColor);
    connect(swap, &QAction::triggered, &colors, &BrushColors::swap);
    connect(reset, &QAction::triggered, &colors, &BrushColors::reset);
    m_colorActions = {choose, swap, reset};
    makeSizes();
    makeOpacities();
}

void BrushActions::makeSizes()
{
    ActionMaker make(m_window);
    const auto add = [&](const QString& text, const QString& toolTip, const QKeySequence& keys) {
        m_sizeActions += make(text, toolTip, keys);
        return m_sizeActions.constLast();
    };
    connect(add(tr("&Larger"), tr("Make the brush larger"), {Qt::Key_BracketRight}),
            &QAction::triggered,
            this,
            [this] { scaleRadius(kRadiusStep); });
    connect(add(tr("S&maller"), tr("Make the brush smaller"), {Qt::Key_BracketLeft}),
            &QAction::triggered,
            this,
            [this] { scaleRadius(1.0F / kRadiusStep); });
    // On most keyboards Shift+] types a brace.
    QAction* harder = add(tr("&Harder"), tr("Make the brush's edge harder"), {});
    harder->setShortcuts({QKeySequence(Qt::SHIFT | Qt::Key_BracketRight),
                          QKeySequence(Qt::SHIFT | Qt::Key_BraceRight)});
    QAction* softer = add(tr("So&fter"), tr("Make the brush's edge softer"), {});
    softer->setShortcuts({QKeySequence(Qt::SHIFT | Qt::Key_BracketLeft),
                          QKeySequence(Qt::SHIFT | Qt::Key_BraceLeft)});
    connect(harder, &QAction::triggered, this, [this] { addHardness(kHardnessStep); });
    connect(softer, &QAction::triggered, this, [this] { addHardness(-kHardnessStep); });
}

void BrushActions::makeOpacities()
{
    ActionMaker make(m_window);
    for (int digit = 1; digit <= 10; ++digit) {
        QAction* action = make(tr("Opacity %1 %").arg(10 * digit),
                               tr("Let a stroke cover at most %1 %").arg(10 * digit),
                               QKeySequence(Qt::Key_0 + digit % 10));
        connect(action, &QAction::triggered, this, [this, digit] {
            Brush brush = m_settings.brush();
            brush.opacity = kOpacityStep * static_cast<float>(digit);
            m_settings.setBrush(brush);
        });
        m_opacityActions += action;
    }
}

void BrushActions::fillMenu(QMenu& menu)
{
    menu.addActions(m_colorActions);
    menu.addSeparator();
    menu.addActions(m_sizeActions);
    menu.addSeparator();
    menu.addMenu(tr("&Opacity"))->addActions(m_opacityActions);
}

void BrushActions::scaleRadius(float factor)
{
    Brush brush = m_settings.brush();
    brush.radius = std::clamp(brush.radius * factor,
                              m_surfaceSize * BrushPanel::kLeastRadius,
                              m_surfaceSize * BrushPanel::kMostRadius);
    m_settings.setBrush(brush);
}

void BrushActions::addHardness(float step)
{
    Brush brush = m_settings.brush();
    brush.hardness = std::clamp(brush.hardness + step, 0.0F, 1.0F);
    m_settings.setBrush(brush);
}

} // namespace trixel::ui
