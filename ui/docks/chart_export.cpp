// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/chart_export.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <QSettings>

namespace trixel::ui {

namespace {

constexpr auto kFolderKey = "files/folder";

}

QMenu* makeExportMenu(std::span<const ExportFormat> formats,
                      QWidget& parent,
                      std::function<void(const ExportFormat&)> chosen)
{
    auto* menu = new QMenu(&parent);
    for (const ExportFormat& format : formats) {
        QAction* action = menu->addAction(QObject::tr(format.command));
        action->setToolTip(QObject::tr("Write a .%1 file").arg(format.ending));
        QObject::connect(action, &QAction::triggered, menu, [chosen, format] { chosen(format); });
    }
    return menu;
}

void askForExport(const ExportFormat& format,
                  const QString& name,
                  QWidget& parent,
                  std::function<void(const QString& path)> then)
{
    const QString folder = QSettings().value(kFolderKey, QDir::homePath()).toString();
    auto* dialog = new QFileDialog(&parent, QObject::tr("Export the Study"), folder);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setNameFilter(QObject::tr(format.filter));
    dialog->setDefaultSuffix(format.ending);
    dialog->selectFile(name + '.' + format.ending);
    QObject::connect(
        dialog, &QFileDialog::fileSelected, &parent, [then](const QString& path) { then(path); });
    dialog->open();
}

} // namespace trixel::ui
