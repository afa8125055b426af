// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointer>
#include <QString>

#include "core/io/export_project.h"
#include "core/io/project.h"
#include "ui/document/project_options.h"

namespace trixel::ui {

class BackgroundJob;
class BackgroundJobs;
class Document;

/// What a file may hold, by its name's ending.
enum class FileKind { Project, Ptx, Mesh, Unknown };
FileKind fileKindOf(const QString& path);

/// Brings files into the document and out of it, in the background. A failure leaves the document
/// as it was and is told in one sentence. Asks no questions: unsaved changes are the caller's care.
class ProjectFiles : public QObject
{
    Q_OBJECT

public:
    ProjectFiles(Document& document, BackgroundJobs& jobs, QObject* parent = nullptr);

    /// Opens a project, a `.ptx` with its mesh, or a mesh with default options. Another open under
    /// way is given up.
    void open(const QString& path);
    /// Opens the scene that comes with the program.
    void openSample();
    /// Opens a `.ptx` on a mesh from another file.
    void openPtxOn(const QString& ptxPath, const QString& meshPath);
    /// The same where its faces are in another order or wound otherwise: they are matched.
    void openPtxMatchedOn(const QString& ptxPath, const QString& meshPath);
    /// Starts a project on a mesh; `name` is its title.
    void createNew(std::shared_ptr<const TriangleMesh> mesh,
                   const ProjectOptions& options,
                   const QString& name);
    /// Saves a snapshot as it is now; painting may go on.
    void save(const QString& path);
    /// Exports a snapshot.
    void exportAs(const trixel::ExportRequest& request);

    bool isSaving() const { return m_saving > 0; }
    bool isExporting() const { return m_exporting > 0; }

signals:
    /// The document now holds this file.
    void opened(const QString& path);
    void sampleOpened();
    /// A bare mesh was opened with default options.
    void meshOpened(const QString& path);
    void saved(const QString& path);
    void exported(const QString& path, const trixel::ExportOutcome& outcome);
    /// An export ended, well or not.
    void exportEnded();
    /// The texels of the `.ptx` are sound but its mesh is missing or damaged, as the sentence says.
    void meshWanted(const QString& ptxPath, const QString& sentence);
    /// The `.ptx` does not fit the mesh as it stands, as the sentence says, but its faces can be
    /// matched to the mesh's.
    void matchWanted(const QString& ptxPath, const QString& meshPath, const QString& sentence);
    /// One sentence naming the file and the cause. Nothing is told of cancelled work.
    void failed(const QString& sentence);
    void savingChanged();
    /// A save ended, well or not.
    void saveEnded(bool done);

private:
    template <class Work, class Then>
    void load(const QString& path, Work work, Then then);
    void openProjectFile(const QString& path);
    void openPtxFile(const QString& path);
    void openMeshFile(const QString& path);
    void saveNow(const QString& path);
    void exportNow(const ExportRequest& request);
    void tell(const Error& error, const QString& path);

    Document& m_document;
    BackgroundJobs& m_jobs;
    QPointer<BackgroundJob> m_loading;
    quint64 m_generation = 0; ///< of the latest load; answers to earlier ones are stale
    int m_saving = 0;
    int m_exporting = 0;
};

} // namespace trixel::ui
