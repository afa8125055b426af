// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/camera_files.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QSettings>

#include "core/base/read_file.h"
#include "core/study/views/view_camera.h"
#include "ui/charts/write_chart.h"
#include "ui/document/background_job.h"
#include "ui/document/document.h"
#include "ui/document/view_bookmarks.h"

#include <cstdint>
#include <filesystem>

namespace trixel::ui {

namespace {

constexpr auto kFolderKey = "files/folder";
/// Thousands of cameras take less; anything larger is another kind of file.
constexpr std::uint64_t kMostBytes = std::uint64_t{16} << 20U;

std::filesystem::path toPath(const QString& path)
{
    return std::filesystem::path(path.toStdU16String());
}

Result<SceneViews> readCameras(const std::filesystem::path& path)
{
    const auto text = readFile(path, kMostBytes);
    if (!text) {
        return tl::unexpected(text.error());
    }
    auto views = parseCameras(*text);
    return views ? std::move(views) : prefixed(path.string(), views.error());
}

/// An error as the window says it: the file without its folders, a full stop at the end.
QString sentenceOf(const Error& error, const QString& path)
{
    QString sentence = QString::fromStdString(error.message);
    sentence.replace(path, QFileInfo(path).fileName());
    return sentence.endsWith('.') ? sentence : sentence + '.';
}

QString addedText(int views, const QString& file)
{
    if (views == 0) {
        return CameraFiles::tr("The views of %1 are there already.").arg(file);
    }
    return views == 1 ? CameraFiles::tr("1 view added from %1.").arg(file)
                      : CameraFiles::tr("%1 views added from %2.").arg(views).arg(file);
}

} // namespace

CameraFiles::CameraFiles(Document& document, BackgroundJobs& jobs, QWidget& parent)
    : QObject(&parent)
    , m_document(document)
    , m_jobs(jobs)
    , m_parent(parent)
{
}

void CameraFiles::askForLoad()
{
    const QString folder = QSettings().value(kFolderKey, QDir::homePath()).toString();
    auto* dialog = new QFileDialog(m_parent.window(), tr("Load Cameras"), folder);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::ExistingFile);
    dialog->setNameFilters({tr("Cameras (*.json)"), tr("All files (*)")});
    connect(dialog, &QFileDialog::fileSelected, this, &CameraFiles::load);
    dialog->open();
}

void CameraFiles::askForSave()
{
    const QString folder = QSettings().value(kFolderKey, QDir::homePath()).toString();
    auto* dialog = new QFileDialog(m_parent.window(), tr("Save Cameras"), folder);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setNameFilter(tr("Cameras (*.json)"));
    dialog->setDefaultSuffix("json");
    dialog->selectFile("cameras.json");
    connect(dialog, &QFileDialog::fileSelected, this, &CameraFiles::save);
    dialog->open();
}

void CameraFiles::load(const QString& path)
{
    m_jobs.run(
        tr("Reading %1…").arg(QFileInfo(path).fileName()),
        [file = toPath(path)](Progress& /*progress*/) { return readCameras(file); },
        [this, path, opened = m_document.openedState()](const Result<SceneViews>& views) {
            if (!views) {
                if (views.error().kind != ErrorKind::Cancelled) {
                    emit failed(sentenceOf(views.error(), path));
                }
                return;
            }
            ViewBookmarks& bookmarks = m_document.bookmarks();
            const int before = bookmarks.count();
            // Meant for the project that was open when they were asked for.
            if (m_document.openedState() == opened && bookmarks.addAll(*views)) {
                emit done(addedText(bookmarks.count() - before, QFileInfo(path).fileName()));
            }
        });
}

void CameraFiles::save(const QString& path)
{
    m_jobs.run(
        tr("Writing %1…").arg(QFileInfo(path).fileName()),
        [file = toPath(path), views = m_document.bookmarks().views()](Progress& /*progress*/) {
            return writeText(file, writeCameras(views));
        },
        [this, path](const Status& status) {
            if (status) {
                emit done(tr("Saved %1.").arg(path));
            } else if (status.error().kind != ErrorKind::Cancelled) {
                emit failed(sentenceOf(status.error(), path));
            }
        });
}

} // namespace trixel::ui
