// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/card_actions.h"

#include <QAction>
#include <QActionGroup>
#include <QMenu>

#include "ui/window/actions.h"
#include "ui/window/mnemonics.h"

namespace trixel::ui {

namespace {

constexpr int kBudgets[] = {64, 128, 256, 512, 1024, 2048, 4096}; // MiB

} // namespace

CardActions::CardActions(ViewSettings& settings, QWidget& window)
    : QObject(&window)
    , m_settings(settings)
{
    makeBudgets(window);
    makePainting(window);
    connect(&settings, &ViewSettings::viewChanged, this, &CardActions::follow);
    follow();
}

void CardActions::makeBudgets(QWidget& window)
{
    auto* group = new QActionGroup(this);
    Mnemonics taken;
    const QString text = tr("Texels on Card: %1 MiB");
    for (const int budget : kBudgets) {
        QAction* action = ActionMaker(window).toggle(
            withMnemonic(text.arg(budget), taken, text.indexOf('%')),
            tr("Let texels take at most %1 MiB of the graphics card; what does not fit is shown "
               "coarser")
                .arg(budget));
        group->addAction(action);
        m_budgets.emplace_back(action, budget);
        connect(action, &QAction::triggered, this, [this, budget] {
            ViewOptions view = m_settings.view();
            view.cardBudget = budget;
            m_settings.setView(view);
        });
    }
}

void CardActions::makePainting(QWidget& window)
{
    const ActionMaker make(window);
    m_painting = {
        make.toggle(tr("Paint on Card: &Never"), tr("Show every stroke when the texels have it")),
        make.toggle(tr("Paint on Card: Where &Faster"),
                    tr("Show large dabs by the graphics card before the texels have "
                       "them, where it was measured to be faster")),
        make.toggle(tr("Paint on Card: &Always"),
                    tr("Show every stroke by the graphics card before the texels have "
                       "it"))};
    auto* group = new QActionGroup(this);
    for (std::size_t k = 0; k < m_painting.size(); ++k) {
        group->addAction(m_painting[k]);
        connect(m_painting[k], &QAction::triggered, this, [this, k] {
            ViewOptions view = m_settings.view();
            view.paintOnCard = static_cast<render::PaintOnCard>(k);
            m_settings.setView(view);
        });
    }
}

void CardActions::follow()
{
    const ViewOptions& view = m_settings.view();
    for (const auto& [action, budget] : m_budgets) {
        action->setChecked(view.cardBudget == budget);
    }
    m_painting[static_cast<std::size_t>(view.paintOnCard)]->setChecked(true);
}

void CardActions::fillMenu(QMenu& menu)
{
    QMenu* card = menu.addMenu(tr("Gr&aphics Card"));
    card->setToolTipsVisible(true);
    for (const auto& [action, budget] : m_budgets) {
        card->addAction(action);
    }
    card->addSeparator();
    for (QAction* action : m_painting) {
        card->addAction(action);
    }
}

} // namespace trixel::ui
