// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/footprint_actions.h"

#include <QAction>
#include <QActionGroup>
#include <QDockWidget>

#include "ui/inspector/footprint_panel.h"
#include "ui/inspector/sweep_bar.h"
#include "ui/window/actions.h"

namespace trixel::ui {

FootprintActions::FootprintActions(FootprintPanel& panel, QDockWidget& dock, QWidget& window)
    : QObject(&dock)
    , m_panel(panel)
    , m_dock(dock)
{
    makeSources(window);
    makeToggles(window);
}

void FootprintActions::showPanel()
{
    m_dock.show();
    m_dock.raise();
}

void FootprintActions::makeSources(QWidget& window)
{
    struct Choice
    {
        FootprintSource source;
        QString text;
        QString toolTip;
    };
    const Choice choices[] = {
        {FootprintSource::Screen,
         tr("Footprint from the &Screen"),
         tr("Look into the footprint of the pixel that sees the inspected texel")},
        {FootprintSource::TextureAligned,
         tr("Footprint along the &Texture"),
         tr("Look into a footprint along u and v of the inspected face")},
        {FootprintSource::ByHand,
         tr("Footprint by &Hand"),
         tr("Drag or type W1 and W2 of the footprint")},
        {FootprintSource::Tilted,
         tr("Footprint of a T&ilted View"),
         tr("Look into the footprint of a view that leans over the inspected texel")},
    };
    auto* group = new QActionGroup(this);
    for (const Choice& choice : choices) {
        QAction* action = ActionMaker(window).toggle(choice.text, choice.toolTip);
        group->addAction(action);
        m_actions += action;
        action->setChecked(m_panel.probe().source() == choice.source);
        connect(action, &QAction::triggered, this, [this, source = choice.source] {
            showPanel();
            m_panel.probe().setSource(source);
        });
        connect(&m_panel,
                &FootprintPanel::sourceChanged,
                action,
                [action, source = choice.source](FootprintSource now) {
                    action->setChecked(now == source);
                });
    }
}

void FootprintActions::makeToggles(QWidget& window)
{
    const ActionMaker make(window);
    QAction* freeze = make.toggle(tr("&Freeze Footprint"),
                                  tr("Keep the footprint as it is to compare it with others"));
    connect(freeze, &QAction::triggered, this, [this](bool frozen) {
        showPanel();
        m_panel.setFrozen(frozen);
    });
    connect(&m_panel, &FootprintPanel::frozenChanged, freeze, &QAction::setChecked);
    QAction* play =
        make.toggle(tr("&Play Footprint Sweep"),
                    tr("Tilt the view over the inspected texel from face-on to grazing and back"));
    connect(play, &QAction::triggered, this, [this](bool plays) {
        showPanel();
        m_panel.sweepBar().setPlaying(plays);
    });
    connect(&m_panel, &FootprintPanel::playingChanged, play, &QAction::setChecked);
    QAction* weights =
        make.toggle(tr("&Weights on the Surface"),
                    tr("Outline the texels that the footprint reads, coloured by weight"));
    connect(weights, &QAction::triggered, this, [this](bool shown) {
        showPanel();
        m_panel.setWeightsOnSurface(shown);
    });
    connect(&m_panel, &FootprintPanel::weightsOnSurfaceChanged, weights, &QAction::setChecked);
    m_actions += QList<QAction*>{freeze, play, weights};
}

} // namespace trixel::ui
