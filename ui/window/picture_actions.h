// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QKeySequence>
#include <QObject>

#include "core/base/result.h"
#include "ui/window/mnemonics.h"
#include "ui/window/workspace.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <vector>

class QAction;
class QDockWidget;
class QMenu;

namespace trixel::ui {

class PictureSource;

/// Saves and copies pictures of the view and of every panel, for papers and tickets: by the File
/// menu, by the palette, and by a right click on a panel.
class PictureActions : public QObject
{
    Q_OBJECT

public:
    /// The window's panels are there.
    explicit PictureActions(const Workspace& work);

    void fillMenu(QMenu& menu);

    /// The line below pictures: the file, the texel looked at, the look and the filter. Empty where
    /// captions are switched off.
    QString caption() const;

private:
    /// Makes what a picture is of, at the time it is wanted.
    using Maker = std::function<std::unique_ptr<PictureSource>()>;

    void addPanel(QDockWidget& dock);
    QAction* addSave(const QString& text,
                     const QString& toolTip,
                     const Maker& maker,
                     const QKeySequence& shortcut = {});
    QAction* addCopy(const QString& text,
                     const QString& toolTip,
                     const Maker& maker,
                     const QKeySequence& shortcut = {});
    void save(const Maker& maker);
    void copy(const Maker& maker);
    void write(PictureSource& source, const QString& path, int kind);
    void writeInBackground(const QString& path,
                           std::function<Status(const std::filesystem::path&)> work);
    double density() const;

    Workspace m_work;
    QAction* m_saveView;
    QAction* m_copyView;
    QAction* m_captions;
    std::vector<QAction*> m_panelActions;    ///< of the menu
    Mnemonics m_mnemonics{QLatin1Char('c')}; ///< that its commands have
};

} // namespace trixel::ui
