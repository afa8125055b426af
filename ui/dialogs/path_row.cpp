// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/path_row.h"

#include <QDir>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QPushButton>

namespace trixel::ui {

PathRow::PathRow(Purpose purpose, const QString& name, const QString& filter, QWidget* parent)
    : QWidget(parent)
    , m_purpose(purpose)
    , m_name(name)
    , m_filter(filter)
    , m_edit(new QLineEdit)
{
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(6);
    auto* browse = new QPushButton(tr("&Browse…"));
    layout->addWidget(m_edit, 1);
    layout->addWidget(browse);

    m_edit->setAccessibleName(name);
    m_edit->setToolTip(name);
    browse->setAccessibleName(tr("Browse for: %1").arg(name));
    browse->setToolTip(tr("Choose in a file dialog"));
    browse->setAutoDefault(false);
    setFocusProxy(m_edit);
    connect(m_edit, &QLineEdit::textChanged, this, [this] { emit pathChanged(path()); });
    connect(browse, &QPushButton::clicked, this, &PathRow::browse);
}

QString PathRow::path() const
{
    return m_edit->text().trimmed();
}

void PathRow::setPath(const QString& path)
{
    m_edit->setText(QDir::toNativeSeparators(path));
}

void PathRow::browse()
{
    auto* dialog = new QFileDialog(this, m_name, path(), m_filter);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    const bool saves = m_purpose == Purpose::Save;
    dialog->setAcceptMode(saves ? QFileDialog::AcceptSave : QFileDialog::AcceptOpen);
    dialog->setFileMode(saves ? QFileDialog::AnyFile : QFileDialog::ExistingFile);
    connect(dialog, &QFileDialog::fileSelected, this, &PathRow::setPath);
    dialog->open();
}

} // namespace trixel::ui
