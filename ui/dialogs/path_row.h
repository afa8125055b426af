// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QLineEdit;

namespace trixel::ui {

/// A file name to type, or to choose with Browse.
class PathRow : public QWidget
{
    Q_OBJECT

public:
    enum class Purpose { Open, Save };

    /// \param name    for screen readers and the file dialog's title: "Mesh file"
    /// \param filter  as a QFileDialog takes it
    PathRow(Purpose purpose, const QString& name, const QString& filter, QWidget* parent = nullptr);

    QString path() const;
    void setPath(const QString& path);

signals:
    void pathChanged(const QString& path);

private:
    void browse();

    Purpose m_purpose;
    QString m_name;
    QString m_filter;
    QLineEdit* m_edit;
};

} // namespace trixel::ui
