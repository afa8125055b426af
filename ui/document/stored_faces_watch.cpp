// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/stored_faces_watch.h"

#include "core/texture/stored_faces.h"
#include "ui/document/document.h"

namespace trixel::ui {

namespace {

constexpr int kBetweenLooks = 500; ///< milliseconds

/// The sentence with its file named without folders: "/a/b.ptx: why" becomes "b.ptx: why".
QString withoutFolders(const QString& sentence)
{
    const qsizetype end = sentence.indexOf(": ");
    const qsizetype name = sentence.lastIndexOf('/', end);
    return end < 0 || name < 0 ? sentence : sentence.mid(name + 1);
}

} // namespace

StoredFacesWatch::StoredFacesWatch(Document& document)
    : QObject(&document)
    , m_document(document)
{
    m_timer.setInterval(kBetweenLooks);
    connect(&m_timer, &QTimer::timeout, this, &StoredFacesWatch::look);
}

void StoredFacesWatch::begin()
{
    m_faces = m_document.storedFaces();
    m_told = 0;
    if (m_faces) {
        m_timer.start();
    } else {
        m_timer.stop();
    }
}

void StoredFacesWatch::look()
{
    if (!m_faces) {
        return;
    }
    if (m_faces->heldBytes() > m_faces->budget()) {
        m_document.releaseHeldTexels();
    }
    const std::vector<FaceFault> faults = m_faces->faults(m_told);
    if (faults.empty()) {
        return;
    }
    m_told += faults.size();
    const FaceFault& first = faults.front();
    const auto face = static_cast<qulonglong>(indexOf(first.face));
    const QString what = faults.size() == 1
                             ? tr("Face %1 cannot be read and is shown as checks").arg(face)
                             : tr("Face %1 and %n others cannot be read and are shown as checks",
                                  nullptr,
                                  static_cast<int>(faults.size() - 1))
                                   .arg(face);
    emit damaged(tr("%1; saving is refused until they are filled. %2.")
                     .arg(what, withoutFolders(QString::fromStdString(first.sentence))));
}

} // namespace trixel::ui
