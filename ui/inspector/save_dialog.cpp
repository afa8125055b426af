// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inspector/save_dialog.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QSettings>

#include "core/base/check.h"

#include <algorithm>

namespace trixel::ui {

namespace {

constexpr auto kFolderKey = "files/folder";

/// The kind of the filter chosen, or of the ending typed where that is of another kind.
int kindOf(const QList<SaveKind>& kinds, const QString& filter, const QString& path)
{
    const auto chosen = std::ranges::find(kinds, filter, &SaveKind::filter);
    const QString ending = QFileInfo(path).suffix().toLower();
    if (chosen != kinds.end() && chosen->ending == ending) {
        return static_cast<int>(chosen - kinds.begin());
    }
    const auto typed = std::ranges::find(kinds, ending, &SaveKind::ending);
    return static_cast<int>((typed != kinds.end() ? typed : kinds.begin()) - kinds.begin());
}

} // namespace

void askWhereToSave(QWidget& parent,
                    const QString& title,
                    const QString& name,
                    const QList<SaveKind>& kinds,
                    std::function<void(const QString& path, int kind)> then)
{
    check(!kinds.isEmpty(), "a kind to save as");
    const QString folder = QSettings().value(kFolderKey, QDir::homePath()).toString();
    auto* dialog = new QFileDialog(&parent, title, folder);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    QStringList filters;
    for (const SaveKind& kind : kinds) {
        filters += kind.filter;
    }
    dialog->setNameFilters(filters);
    dialog->setDefaultSuffix(kinds.front().ending);
    dialog->selectFile(name + '.' + kinds.front().ending);
    QObject::connect(
        dialog, &QFileDialog::filterSelected, dialog, [dialog, kinds](const QString& filter) {
            const auto kind = std::ranges::find(kinds, filter, &SaveKind::filter);
            if (kind != kinds.end()) {
                dialog->setDefaultSuffix(kind->ending);
            }
        });
    QObject::connect(dialog,
                     &QFileDialog::fileSelected,
                     &parent,
                     [dialog, kinds, then = std::move(then)](const QString& path) {
                         QSettings().setValue(kFolderKey, QFileInfo(path).absolutePath());
                         then(path, kindOf(kinds, dialog->selectedNameFilter(), path));
                     });
    dialog->open();
}

} // namespace trixel::ui
