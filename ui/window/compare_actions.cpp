// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/compare_actions.h"

#include <QActionGroup>
#include <QMenu>

#include "core/study/views/view_map.h"
#include "ui/viewport/method_title.h"
#include "ui/viewport/split_bar.h"
#include "ui/viewport/viewport.h"
#include "ui/window/actions.h"
#include "ui/window/filtering_actions.h"
#include "ui/window/map_actions.h"
#include "ui/window/mnemonics.h"

#include <algorithm>
#include <utility>

namespace trixel::ui {

CompareActions::CompareActions(ViewSettings& settings,
                               MapActions& maps,
                               FilteringActions& filterings,
                               Viewport& viewport,
                               QWidget& window)
    : QObject(&window)
    , m_settings(settings)
    , m_maps(maps)
    , m_filterings(filterings)
    , m_viewport(viewport)
    , m_methodMenu(new QMenu(tr("Filter Method of &B"), &window))
    , m_levelMenu(new QMenu(tr("Levels of B"), &window))
    , m_beforeMenu(new QMenu(tr("Texels of B"), &window))
{
    makeWays(window);
    makeMethods(window);
    makeLevels(window);
    connect(&settings, &ViewSettings::comparisonChanged, this, &CompareActions::follow);
    follow();
}

void CompareActions::makeWays(QWidget& window)
{
    struct Way
    {
        ComparedBy by;
        QString text;
        QString toolTip;
        QKeySequence keys;
    };
    const Way ways[] = {
        {ComparedBy::Method,
         tr("Two &Filters"),
         tr("Split the view: A filtered by the chosen method, B by another"),
         Qt::CTRL | Qt::Key_8},
        {ComparedBy::Level,
         tr("Two &Levels"),
         tr("Split the view: A as it is, B some levels coarser"),
         Qt::CTRL | Qt::Key_9},
        {ComparedBy::Before,
         tr("Before &and After"),
         tr("Split the view: A as the texels are, B as they were opened or remembered"),
         Qt::CTRL | Qt::Key_0},
        {ComparedBy::Filtering,
         tr("Two Ways of &Drawing"),
         tr("Split the view: A and B as the graphics card filters the same texels in two ways"),
         Qt::CTRL | Qt::SHIFT | Qt::Key_8},
    };
    for (const Way& way : ways) {
        QAction* action = ActionMaker(window).toggle(way.text, way.toolTip, way.keys);
        m_ways.emplace_back(action, way.by);
        connect(action, &QAction::triggered, this, [this, by = way.by](bool on) {
            compare(on ? by : ComparedBy::Nothing);
        });
    }
    m_remember = ActionMaker(window)(tr("&Remember Texels as Before"),
                                     tr("What Before and After compares with from now on"));
    connect(m_remember, &QAction::triggered, this, [this] {
        m_viewport.rememberBefore();
        emit remembered();
    });
    m_beforeMenu->addAction(m_remember);
}

void CompareActions::makeMethods(QWidget& window)
{
    auto* group = new QActionGroup(this);
    Mnemonics taken;
    for (const MethodEntry& entry : filterMethods()) {
        const QString title = fromView(entry.title);
        QAction* action = ActionMaker(window).toggle(withMnemonic(tr("B: %1").arg(title), taken),
                                                     fromView(entry.about));
        group->addAction(action);
        m_methodMenu->addAction(action);
        m_methods.emplace_back(action, std::string(entry.name));
        connect(action, &QAction::triggered, this, [this, name = std::string(entry.name)] {
            Comparison comparison = m_settings.comparison();
            comparison.method = {name, std::nullopt};
            m_settings.setComparison(comparison);
        });
    }
    m_swap = ActionMaker(window)(tr("&Swap A and B"),
                                 tr("Give A the filter method of B, and B that of A"));
    connect(m_swap, &QAction::triggered, this, &CompareActions::swapMethods);
}

void CompareActions::makeLevels(QWidget& window)
{
    ActionMaker make(window);
    m_coarser = make(tr("B a Level &Coarser"),
                     tr("Show B one level coarser"),
                     QKeySequence(Qt::SHIFT | Qt::Key_PageDown));
    m_finer = make(tr("B a Level F&iner"),
                   tr("Show B one level finer"),
                   QKeySequence(Qt::SHIFT | Qt::Key_PageUp));
    connect(m_coarser, &QAction::triggered, this, [this] { dropLevels(1); });
    connect(m_finer, &QAction::triggered, this, [this] { dropLevels(-1); });
    m_levelMenu->addAction(m_coarser);
    m_levelMenu->addAction(m_finer);
}

void CompareActions::fillMenu(QMenu& menu)
{
    QMenu* compare = menu.addMenu(tr("&Split to Compare"));
    for (const auto& [action, by] : m_ways) {
        compare->addAction(action);
    }
    compare->addSeparator();
    compare->addMenu(m_methodMenu);
    compare->addAction(m_swap);
    compare->addAction(m_coarser);
    compare->addAction(m_finer);
    compare->addAction(m_remember);
    compare->addMenu(m_filterings.otherMenu());
}

void CompareActions::compare(ComparedBy by)
{
    Comparison comparison = m_settings.comparison();
    ViewOptions view = m_settings.view();
    const bool hadFilters = comparison.by == ComparedBy::Method;
    comparison.by = by;
    // Two filters are two filtered pictures; levels and texels are seen without one.
    if (by == ComparedBy::Method) {
        view.map = ViewMapKind::Filtered;
        if (comparison.method == m_settings.method()) {
            const bool isExact = comparison.method.name == kExactMethod;
            comparison.method = {std::string(isExact ? "point" : kExactMethod), std::nullopt};
        }
    } else if (by != ComparedBy::Nothing || hadFilters) {
        view.map = ViewMapKind::None;
    }
    if (by == ComparedBy::Filtering && comparison.filtering == view.filtering) {
        comparison.filtering = view.filtering == render::Filtering::Seamless
                                   ? render::Filtering::Texels
                                   : render::Filtering::Seamless;
    }
    m_settings.setComparison(comparison);
    m_settings.setView(view);
}

void CompareActions::swapMethods()
{
    Comparison comparison = m_settings.comparison();
    const MethodChoice left = m_settings.method();
    m_settings.setMethod(std::exchange(comparison.method, left));
    m_settings.setComparison(comparison);
}

void CompareActions::dropLevels(int more)
{
    Comparison comparison = m_settings.comparison();
    comparison.levelsDropped = std::clamp(comparison.levelsDropped + more, 1, Level::kMax);
    m_settings.setComparison(comparison);
}

void CompareActions::follow()
{
    const Comparison& comparison = m_settings.comparison();
    for (const auto& [action, by] : m_ways) {
        action->setChecked(comparison.by == by);
    }
    for (const auto& [action, name] : m_methods) {
        action->setChecked(comparison.method.name == name);
    }
    m_swap->setEnabled(comparison.by == ComparedBy::Method);
    m_coarser->setEnabled(comparison.by == ComparedBy::Level);
    m_finer->setEnabled(comparison.by == ComparedBy::Level && comparison.levelsDropped > 1);
    m_remember->setEnabled(comparison.by == ComparedBy::Before);
    const auto menus = [&]() -> std::pair<QMenu*, QMenu*> {
        switch (comparison.by) {
        case ComparedBy::Method:
            return {m_maps.methodMenu(), m_methodMenu};
        case ComparedBy::Level:
            return {nullptr, m_levelMenu};
        case ComparedBy::Filtering:
            return {m_filterings.ownMenu(), m_filterings.otherMenu()};
        case ComparedBy::Before:
        case ComparedBy::Nothing:
            break;
        }
        return {nullptr, m_beforeMenu};
    }();
    m_viewport.splitBar().setMenus(menus.first, menus.second);
}

} // namespace trixel::ui
