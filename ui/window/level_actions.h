// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "core/texture/level_change.h"
#include "ui/document/document.h"

#include <memory>

class QAction;
class QMenu;
class QWidget;

namespace trixel::ui {

class BackgroundJobs;
class FaceSelection;
class MessageBar;

/// A change of levels takes no more texel bytes than this, unless it takes less than before.
inline constexpr std::uint64_t kLevelBudget = std::uint64_t{1} << 30U;

/// Edit > Levels: other levels for the selected faces, or all when none is. What it would cost is
/// said above the view first; Apply does it as one undo step. Both are worked out in the
/// background.
class LevelActions : public QObject
{
    Q_OBJECT

public:
    LevelActions(Document& document,
                 const FaceSelection& selection,
                 BackgroundJobs& jobs,
                 MessageBar& messages,
                 QWidget& window);

    void fillMenu(QMenu& menu);

private:
    struct Plan;
    void enable();
    void askForLevel();
    void plan(LevelChange change, const QString& text);
    void count(const LevelChange& change, const QString& text);
    void offer(const std::shared_ptr<const Plan>& plan);
    void apply(const std::shared_ptr<const Plan>& plan);
    void applyToLayers(const std::shared_ptr<const Plan>& plan);
    void complain(const Error& error);
    void withdraw();

    Document& m_document;
    const FaceSelection& m_selection;
    BackgroundJobs& m_jobs;
    MessageBar& m_messages;
    QWidget& m_window;
    QAction* m_halve;
    QAction* m_double;
    QAction* m_set;
    QString m_offered;           ///< the sentence with Apply, while it may be shown
    std::uint64_t m_planned = 0; ///< counts the plans: answers to earlier ones are dropped
};

} // namespace trixel::ui
