// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QStringList>

class QMenu;

namespace trixel::ui {

/// The files used last, kept in the settings, and the menu that offers them.
class RecentFiles : public QObject
{
    Q_OBJECT

public:
    static constexpr qsizetype kMax = 12;

    explicit RecentFiles(QObject* parent = nullptr);

    /// Latest first.
    QStringList paths() const;
    /// Puts a file first.
    void add(const QString& path);
    void clear();

    /// Fills the menu afresh each time it opens; files that are gone are greyed.
    void attachTo(QMenu& menu);

signals:
    void chosen(const QString& path);

private:
    void fill(QMenu& menu);
};

} // namespace trixel::ui
