// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/command_palette.h"

#include <QAction>
#include <QCoreApplication>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <vector>

namespace trixel::ui {

namespace {

constexpr QSize kSize(520, 360);

QString plainText(QString text)
{
    text.replace("&&", "\x01").remove('&').replace("\x01", "&");
    return text;
}

} // namespace

CommandPalette::CommandPalette(QMenuBar& menus, QWidget* parent)
    : QDialog(parent, Qt::Popup)
    , m_typed(new QLineEdit)
    , m_list(new QTreeWidget)
{
    setObjectName("commandPalette");
    setWindowTitle(tr("Commands"));
    setFixedSize(kSize);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 8, 8, 8);
    layout->setSpacing(6);
    layout->addWidget(m_typed);
    layout->addWidget(m_list);
    m_typed->setPlaceholderText(tr("Type a command"));
    m_typed->setAccessibleName(tr("Command to search for"));
    m_typed->setToolTip(tr("Letters of the command, in order"));
    m_typed->installEventFilter(this);
    m_list->setAccessibleName(tr("Commands found"));
    m_list->setToolTip(tr("Enter runs the chosen command"));
    m_list->setFocusPolicy(Qt::NoFocus);
    m_list->setColumnCount(2);
    m_list->setHeaderHidden(true);
    m_list->setRootIsDecorated(false);
    m_list->setUniformRowHeights(true);
    m_list->header()->setStretchLastSection(false);
    m_list->header()->setSectionResizeMode(0, QHeaderView::Stretch);
    m_list->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);

    collect(menus.actions(), {});
    connect(m_typed, &QLineEdit::textChanged, this, &CommandPalette::list);
    connect(m_typed, &QLineEdit::returnPressed, this, &CommandPalette::run);
    connect(m_list, &QTreeWidget::itemClicked, this, &CommandPalette::run);
    list();
    m_typed->setFocus();
}

void CommandPalette::collect(const QList<QAction*>& actions, const QString& path)
{
    for (QAction* action : actions) {
        if (action->isSeparator()) {
            continue;
        }
        const QString name = path + plainText(action->text());
        if (QMenu* menu = action->menu()) {
            emit menu->aboutToShow(); // menus that are filled when they open
            collect(menu->actions(), name + " › ");
        } else if (action->isEnabled()) {
            m_commands += {name, action};
        }
    }
}

int CommandPalette::fit(const QString& name, const QString& typed)
{
    constexpr int kRun = 4;
    constexpr int kWord = 6;
    int score = 0;
    qsizetype at = -1;
    for (const QChar letter : typed) {
        if (letter.isSpace()) {
            continue;
        }
        const qsizetype found = name.indexOf(letter, at + 1, Qt::CaseInsensitive);
        if (found < 0) {
            return -1;
        }
        const bool startsWord = found == 0 || !name[found - 1].isLetterOrNumber();
        score += 1 + (found == at + 1 ? kRun : 0) + (startsWord ? kWord : 0);
        at = found;
    }
    return score;
}

void CommandPalette::list()
{
    struct Found
    {
        int score;
        qsizetype command;
    };
    std::vector<Found> found;
    for (qsizetype k = 0; k < m_commands.size(); ++k) {
        // The command's own name counts, its menus only help to find it.
        const QString& name = m_commands[k].name;
        const int own = fit(name.section(" › ", -1), m_typed->text());
        const int whole = fit(name, m_typed->text());
        if (std::max(own, whole) >= 0) {
            found.push_back({std::max(2 * own, whole), k});
        }
    }
    std::stable_sort(found.begin(), found.end(), [](const Found& a, const Found& b) {
        return a.score > b.score;
    });
    m_list->clear();
    for (const Found& entry : found) {
        const Command& command = m_commands[entry.command];
        const QString keys = command.action->shortcut().toString(QKeySequence::NativeText);
        const QString tick = command.action->isChecked() ? " ✓" : "";
        auto* item = new QTreeWidgetItem(m_list, {command.name + tick, keys});
        item->setData(0, Qt::UserRole, entry.command);
        item->setToolTip(0, command.action->toolTip());
        item->setTextAlignment(1, Qt::AlignRight | Qt::AlignVCenter);
    }
    m_list->setCurrentItem(m_list->topLevelItem(0));
}

void CommandPalette::run()
{
    const QTreeWidgetItem* item = m_list->currentItem();
    if (item == nullptr) {
        return;
    }
    QAction* action = m_commands[item->data(0, Qt::UserRole).toLongLong()].action;
    accept();
    // After this popup has let go of keyboard and mouse.
    QMetaObject::invokeMethod(action, &QAction::trigger, Qt::QueuedConnection);
}

bool CommandPalette::eventFilter(QObject* /*watched*/, QEvent* event)
{
    if (event->type() == QEvent::KeyPress) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        if (key == Qt::Key_Up || key == Qt::Key_Down || key == Qt::Key_PageUp ||
            key == Qt::Key_PageDown) {
            QCoreApplication::sendEvent(m_list, event);
            return true;
        }
    }
    return false;
}

} // namespace trixel::ui
