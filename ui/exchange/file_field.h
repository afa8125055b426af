// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTimer>
#include <QWidget>

class QLabel;

namespace trixel::ui {

class PathRow;

/// The name of a file to read, and below it what was found in the file or what is wrong with it.
/// While a name is being typed nobody looks into it.
class FileField : public QWidget
{
    Q_OBJECT

public:
    /// \param name    for screen readers: "Second file"; the line below is "About the second file"
    /// \param filter  as a QFileDialog takes it
    /// \param hint    what to say while there is no name
    FileField(const QString& name, const QString& filter, const QString& hint);

    QString path() const;
    /// Asks for a look at once.
    void setPath(const QString& path);

    void showFound(const QString& sentence);
    void showError(const QString& sentence);
    bool hasError() const { return m_hasError; }

signals:
    /// Another file is named: what is known of the last no longer counts.
    void left();
    /// The name stands: look into it. Not for an empty one.
    void lookWanted(const QString& path);

private:
    void say(const QString& sentence, bool isError);
    void look();

    PathRow* m_row;
    QLabel* m_about;
    QString m_hint;
    QTimer m_typing;
    bool m_hasError = false;
};

} // namespace trixel::ui
