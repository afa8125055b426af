// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/filtering_actions.h"

#include <QAction>
#include <QActionGroup>
#include <QMenu>

#include "render/filtering_study.h"
#include "ui/viewport/filtering_words.h"
#include "ui/window/actions.h"
#include "ui/window/mnemonics.h"

namespace trixel::ui {

FilteringActions::FilteringActions(ViewSettings& settings, QWidget& window)
    : QObject(&window)
    , m_settings(settings)
    , m_ownMenu(new QMenu(tr("Te&xels Drawn As"), &window))
    , m_otherMenu(new QMenu(tr("Texels of B Drawn As"), &window))
{
    m_ownMenu->setToolTipsVisible(true);
    m_otherMenu->setToolTipsVisible(true);
    m_own = makeWays(window, *m_ownMenu, QStringLiteral("%1"), &FilteringActions::chooseOwn);
    m_other = makeWays(window, *m_otherMenu, tr("B: %1"), &FilteringActions::chooseOther);
    m_toggle = ActionMaker(window)(tr("Crisp or S&eamless Texels"),
                                   tr("Go between texels with their edges and seamless ones"),
                                   {Qt::SHIFT | Qt::Key_V});
    connect(m_toggle, &QAction::triggered, this, &FilteringActions::toggle);
    m_ownMenu->addSeparator();
    m_ownMenu->addAction(m_toggle);
    connect(&settings, &ViewSettings::viewChanged, this, &FilteringActions::follow);
    connect(&settings, &ViewSettings::comparisonChanged, this, &FilteringActions::follow);
    follow();
}

FilteringActions::Ways
FilteringActions::makeWays(QWidget& window,
                           QMenu& menu,
                           const QString& pattern,
                           void (FilteringActions::*choose)(render::Filtering))
{
    Ways ways;
    Mnemonics taken;
    auto* group = new QActionGroup(this);
    for (const render::Filtering filtering : render::kFilterings) {
        const QString text = pattern.arg(filteringTitle(filtering));
        QAction* action =
            ActionMaker(window).toggle(withMnemonic(text, taken), filteringAbout(filtering));
        group->addAction(action);
        menu.addAction(action);
        ways.emplace_back(action, filtering);
        connect(action, &QAction::triggered, this, [this, choose, filtering] {
            (this->*choose)(filtering);
        });
    }
    return ways;
}

void FilteringActions::chooseOwn(render::Filtering filtering)
{
    ViewOptions view = m_settings.view();
    view.filtering = filtering;
    m_settings.setView(view);
}

void FilteringActions::chooseOther(render::Filtering filtering)
{
    Comparison comparison = m_settings.comparison();
    comparison.filtering = filtering;
    m_settings.setComparison(comparison);
}

void FilteringActions::toggle()
{
    chooseOwn(m_settings.view().filtering == render::Filtering::Seamless
                  ? render::Filtering::Texels
                  : render::Filtering::Seamless);
}

void FilteringActions::follow()
{
    for (const auto& [action, filtering] : m_own) {
        action->setChecked(m_settings.view().filtering == filtering);
    }
    for (const auto& [action, filtering] : m_other) {
        action->setChecked(m_settings.comparison().filtering == filtering);
        action->setEnabled(m_settings.comparison().by == ComparedBy::Filtering);
    }
}

void FilteringActions::fillMenu(QMenu& menu)
{
    menu.addMenu(m_ownMenu);
}

} // namespace trixel::ui
