// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/look_actions.h"

#include <QDoubleSpinBox>
#include <QMenu>
#include <QSignalBlocker>
#include <QToolBar>

#include "ui/document/document.h"
#include "ui/look/channel_row.h"
#include "ui/look/look_commands.h"
#include "ui/look/look_panel.h"
#include "ui/viewport/view_settings.h"
#include "ui/window/actions.h"

#include <utility>

namespace trixel::ui {

LookActions::LookActions(const Document& document,
                         ViewSettings& settings,
                         LookPanel& panel,
                         QWidget& window)
    : QObject(&window)
    , m_document(document)
    , m_settings(settings)
    , m_window(window)
{
    const auto stepChannel = [this](int by) {
        return [this, by](const render::Look& look) {
            return nextChannel(m_document.texels().format(), look, by);
        };
    };
    add(tr("&Next Channel"),
        tr("Show the next channel alone; after the last comes the colour"),
        {Qt::Key_C},
        stepChannel(1));
    add(tr("&Previous Channel"),
        tr("Show the channel before alone"),
        {Qt::SHIFT | Qt::Key_C},
        stepChannel(-1));
    m_actions += nullptr;
    add(tr("&Brighter"),
        tr("Half a stop more exposure"),
        {Qt::CTRL | Qt::Key_Up},
        [](const render::Look& look) { return exposed(look, kStopStep); });
    add(tr("&Darker"),
        tr("Half a stop less exposure"),
        {Qt::CTRL | Qt::Key_Down},
        [](const render::Look& look) { return exposed(look, -kStopStep); });
    m_actions += nullptr;
    const std::pair<bool, QAction*> fits[] = {
        {false,
         ActionMaker(window)(tr("&Fit Range"),
                             tr("Show the least value black and the greatest white"),
                             {Qt::Key_R})},
        {true,
         ActionMaker(window)(tr("Fit Range without &Outliers"),
                             tr("Leave 0.1 % of the values out at either end"),
                             {Qt::SHIFT | Qt::Key_R})},
    };
    for (const auto& [withoutOutliers, action] : fits) {
        m_actions += action;
        connect(action, &QAction::triggered, &panel, [&panel, outliers = withoutOutliers] {
            panel.fitRange(outliers);
        });
    }
    m_actions += nullptr;
    m_falseColor = addToggle(tr("False &Colour"),
                             tr("Show the number in colours that every kind of eye tells apart"),
                             {Qt::Key_J},
                             &render::Look::falseColor);
    m_falseColor->setIconText(tr("False colour"));
    addToggle(tr("&Marks"),
              tr("Mark NaN, infinite, negative and clipped values"),
              {Qt::Key_N},
              &render::Look::marks);
    addToggle(tr("&Without Opacity"),
              tr("Show colours as if everything were opaque"),
              {},
              &render::Look::opaque);
    m_actions += nullptr;
    add(tr("&Reset Look"),
        tr("Show values as they are"),
        {Qt::CTRL | Qt::Key_Home},
        [](const render::Look& /*look*/) { return render::Look(); });
    connect(&settings, &ViewSettings::lookChanged, this, &LookActions::follow);
    connect(&document, &Document::opened, this, &LookActions::follow);
    follow();
}

QAction* LookActions::add(const QString& text,
                          const QString& toolTip,
                          const QKeySequence& shortcut,
                          Change change)
{
    QAction* action = ActionMaker(m_window)(text, toolTip, shortcut);
    connect(action, &QAction::triggered, this, [this, change = std::move(change)] {
        m_settings.setLook(change(m_settings.look()));
    });
    m_actions += action;
    return action;
}

QAction* LookActions::addToggle(const QString& text,
                                const QString& toolTip,
                                const QKeySequence& shortcut,
                                bool render::Look::*member)
{
    QAction* action = ActionMaker(m_window).toggle(text, toolTip, shortcut);
    connect(action, &QAction::triggered, this, [this, member](bool on) {
        render::Look look = m_settings.look();
        look.*member = on;
        m_settings.setLook(look);
    });
    m_actions += action;
    m_toggles += std::pair(action, member);
    return action;
}

void LookActions::follow()
{
    for (const auto& [action, member] : std::as_const(m_toggles)) {
        action->setChecked(m_settings.look().*member);
    }
    for (QAction* action : std::as_const(m_actions)) {
        if (action != nullptr) {
            action->setEnabled(m_document.isOpen());
        }
    }
}

void LookActions::fillToolBar(QToolBar& bar)
{
    auto* channels = new ChannelRow(m_document, m_settings);
    channels->setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Fixed);
    bar.addWidget(channels);
    auto* exposure = new QDoubleSpinBox;
    exposure->setRange(double{-kMostStops}, double{kMostStops});
    exposure->setDecimals(1);
    exposure->setSingleStep(double{kStopStep});
    exposure->setSuffix(tr(" EV"));
    exposure->setAccessibleName(tr("Exposure of the view"));
    exposure->setToolTip(tr("Exposure in stops: values count 2 to this power times (Ctrl+Up, "
                            "Ctrl+Down)"));
    exposure->setFocusPolicy(Qt::ClickFocus); // keys of the view stay with the view
    exposure->setKeyboardTracking(false);
    bar.addWidget(exposure);
    const auto follow = [this, exposure] {
        const QSignalBlocker quiet(exposure);
        exposure->setValue(double{m_settings.look().exposure});
        exposure->setEnabled(m_document.isOpen());
    };
    connect(&m_settings, &ViewSettings::lookChanged, exposure, follow);
    connect(&m_document, &Document::opened, exposure, follow);
    connect(exposure, &QDoubleSpinBox::valueChanged, this, [this](double stops) {
        render::Look look = m_settings.look();
        look.exposure = static_cast<float>(stops);
        m_settings.setLook(look);
    });
    follow();
    bar.addAction(m_falseColor);
}

void LookActions::fillMenu(QMenu& menu)
{
    QMenu* looks = menu.addMenu(tr("Loo&k"));
    for (QAction* action : std::as_const(m_actions)) {
        if (action != nullptr) {
            looks->addAction(action);
        } else {
            looks->addSeparator();
        }
    }
}

} // namespace trixel::ui
