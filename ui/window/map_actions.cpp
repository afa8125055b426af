// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/map_actions.h"

#include <QAction>
#include <QActionGroup>
#include <QMenu>

#include "ui/viewport/method_title.h"
#include "ui/window/actions.h"
#include "ui/window/mnemonics.h"

namespace trixel::ui {

MapActions::MapActions(ViewSettings& settings, QWidget& window)
    : QObject(&window)
    , m_settings(settings)
{
    makeMaps(window);
    makeToggle(window);
    makeMethods(window);
    connect(&settings, &ViewSettings::viewChanged, this, &MapActions::follow);
    connect(&settings, &ViewSettings::methodChanged, this, &MapActions::follow);
    follow();
}

void MapActions::makeMaps(QWidget& window)
{
    struct Choice
    {
        ViewMapKind map;
        QString text;
        QString toolTip;
        int key;
    };
    const Choice choices[] = {
        {ViewMapKind::None, tr("&None"), tr("Show the surface as it is"), Qt::Key_1},
        {ViewMapKind::Filtered,
         tr("&Filtered"),
         tr("Show every pixel as the chosen filter method computes it"),
         Qt::Key_2},
        {ViewMapKind::Condition,
         tr("&Condition"),
         tr("Show how elongated each pixel's footprint is on the surface"),
         Qt::Key_3},
        {ViewMapKind::Error,
         tr("&Error"),
         tr("Show how far the chosen filter method is from the exact answer"),
         Qt::Key_4},
        {ViewMapKind::Fit,
         tr("F&it to Scene"),
         tr("Show the error that the planned fit leaves on each face"),
         Qt::Key_5},
        {ViewMapKind::Level, tr("&Level"), tr("Show the level of each face"), Qt::Key_6},
        {ViewMapKind::Density,
         tr("&Density"),
         tr("Show how many texels each face has along a unit of length"),
         Qt::Key_7},
        {ViewMapKind::Difference,
         tr("Diffe&rence from File"),
         tr("Show how far each face is from that of the file compared with"),
         0}, // all digits are taken
    };
    auto* group = new QActionGroup(this);
    for (const Choice& choice : choices) {
        QAction* action = ActionMaker(window).toggle(
            choice.text,
            choice.toolTip,
            choice.key != 0 ? QKeySequence(Qt::CTRL | choice.key) : QKeySequence());
        group->addAction(action);
        m_maps.emplace_back(action, choice.map);
        connect(action, &QAction::triggered, this, [this, map = choice.map] {
            ViewOptions view = m_settings.view();
            view.map = map;
            m_settings.setView(view);
        });
    }
}

/// Between the two that are looked at in turn most often.
void MapActions::makeToggle(QWidget& window)
{
    m_toggle =
        ActionMaker(window).toggle(tr("Nearest &or Filtered"),
                                   tr("Go between the texels as they are and the filtered picture"),
                                   {Qt::Key_V});
    m_toggle->setIconText(tr("Filtered"));
    connect(m_toggle, &QAction::triggered, this, [this] {
        ViewOptions view = m_settings.view();
        const bool isFiltered = view.map == ViewMapKind::Filtered;
        view.map = isFiltered ? ViewMapKind::None : ViewMapKind::Filtered;
        m_settings.setView(view);
    });
}

void MapActions::makeMethods(QWidget& window)
{
    auto* group = new QActionGroup(this);
    Mnemonics taken;
    for (const MethodEntry& entry : filterMethods()) {
        QAction* action = ActionMaker(window).toggle(withMnemonic(fromView(entry.title), taken),
                                                     fromView(entry.about));
        group->addAction(action);
        m_methods.emplace_back(action, std::string(entry.name));
        connect(action, &QAction::triggered, this, [this, name = std::string(entry.name)] {
            m_settings.setMethod({name, std::nullopt});
        });
    }
}

void MapActions::follow()
{
    m_toggle->setChecked(m_settings.view().map == ViewMapKind::Filtered);
    for (const auto& [action, map] : m_maps) {
        action->setChecked(m_settings.view().map == map);
    }
    for (const auto& [action, name] : m_methods) {
        action->setChecked(m_settings.method().name == name);
    }
}

void MapActions::fillMenu(QMenu& menu)
{
    QMenu* maps = menu.addMenu(tr("&Map"));
    for (const auto& [action, map] : m_maps) {
        maps->addAction(action);
    }
    maps->addSeparator();
    maps->addAction(m_toggle);
    m_methodMenu = menu.addMenu(tr("Filte&r Method"));
    for (const auto& [action, name] : m_methods) {
        m_methodMenu->addAction(action);
    }
}

} // namespace trixel::ui
