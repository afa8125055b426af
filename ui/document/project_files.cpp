// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/project_files.h"

#include <QFile>
#include <QFileInfo>

#include "core/io/ptx_rematch.h"
#include "core/io/sample_scene.h"
#include "core/mesh/mesh_reader.h"
#include "core/texture/convert.h"
#include "ui/document/background_job.h"
#include "ui/document/document.h"

#include <utility>

namespace trixel::ui {

namespace {

std::filesystem::path toPath(const QString& path)
{
    return std::filesystem::path(path.toStdU16String());
}

QString fileName(const QString& path)
{
    return QFileInfo(path).fileName();
}

/// An error as the window says it: the file without its folders, a full stop at the end.
QString sentenceOf(const Error& error, const QString& path)
{
    QString sentence = QString::fromStdString(error.message);
    sentence.replace(path, fileName(path));
    return sentence.endsWith('.') ? sentence : sentence + '.';
}

/// A `.ptx` or, when only its mesh is at fault, why.
struct PtxOutcome
{
    std::optional<Project> project;
    Error meshFault;
};

Result<PtxOutcome> readPtxProject(const std::filesystem::path& path, Progress& progress)
{
    Result<Project> project = openPtx(path, progress);
    if (project) {
        return PtxOutcome{std::move(*project), {}};
    }
    if (project.error().kind != ErrorKind::Contents) {
        return tl::unexpected(project.error());
    }
    // The texels may be sound and only the mesh be missing, which the user can mend.
    if (openPtxTexels(path, progress)) {
        return PtxOutcome{{}, project.error()};
    }
    return tl::unexpected(project.error());
}

Result<Project> readMeshProject(const std::filesystem::path& path, Progress& progress)
{
    StageProgress reading(progress, 0.0, 0.6);
    Result<TriangleMesh> mesh = readMesh(path, reading);
    if (!mesh) {
        return tl::unexpected(mesh.error());
    }
    const ProjectOptions options = defaultOptions(mesh->faceCount());
    StageProgress building(progress, 0.6, 1.0);
    return makeProject(std::move(*mesh), options, building);
}

Result<MatchedPtx> readPtxMatched(const std::filesystem::path& ptx,
                                  const std::filesystem::path& meshPath,
                                  Progress& progress)
{
    StageProgress reading(progress, 0.0, 0.3);
    Result<TriangleMesh> mesh = readMesh(meshPath, reading);
    if (!mesh) {
        return tl::unexpected(mesh.error());
    }
    StageProgress building(progress, 0.3, 0.5);
    auto surface = Surface::build(std::move(*mesh), building);
    if (!surface) {
        return tl::unexpected(surface.error());
    }
    StageProgress opening(progress, 0.5, 1.0);
    return openPtxMatched(ptx, std::move(*surface), opening);
}

/// A `.ptx` on a mesh or, when its faces have to be matched to the mesh's first, why and how.
struct PtxOnMesh
{
    std::optional<Project> project;
    Error fault;
    std::string match;
};

Result<PtxOnMesh> readPtxOnMesh(const std::filesystem::path& ptx,
                                const std::filesystem::path& meshPath,
                                Progress& progress)
{
    StageProgress reading(progress, 0.0, 0.3);
    Result<TriangleMesh> mesh = readMesh(meshPath, reading);
    if (!mesh) {
        return tl::unexpected(mesh.error());
    }
    StageProgress opening(progress, 0.3, 0.7);
    Result<Project> project = openPtxOnMesh(ptx, std::move(*mesh), opening);
    if (project) {
        return PtxOnMesh{std::move(*project), {}, {}};
    }
    if (project.error().kind != ErrorKind::Contents) {
        return tl::unexpected(project.error());
    }
    StageProgress matching(progress, 0.7, 1.0);
    const auto matched = readPtxMatched(ptx, meshPath, matching);
    return matched ? Result<PtxOnMesh>(
                         PtxOnMesh{std::nullopt, project.error(), matched->match.describe()})
                   : tl::unexpected(project.error());
}

} // namespace

FileKind fileKindOf(const QString& path)
{
    const QString ending = QFileInfo(path).suffix().toLower();
    if (ending == "trixel") {
        return FileKind::Project;
    }
    if (ending == "ptx") {
        return FileKind::Ptx;
    }
    return meshFormatOf(toPath(path)) ? FileKind::Mesh : FileKind::Unknown;
}

ProjectFiles::ProjectFiles(Document& document, BackgroundJobs& jobs, QObject* parent)
    : QObject(parent)
    , m_document(document)
    , m_jobs(jobs)
{
}

/// Runs `work`, then hands its value to `then` unless another load has begun since.
template <class Work, class Then>
void ProjectFiles::load(const QString& path, Work work, Then then)
{
    if (m_loading) {
        m_loading->cancel();
    }
    const quint64 generation = ++m_generation;
    m_loading = &m_jobs.run(tr("Opening %1…").arg(fileName(path)),
                            std::move(work),
                            [this, path, generation, then = std::move(then)](auto result) {
                                if (generation != m_generation) {
                                    return;
                                }
                                if (result) {
                                    then(std::move(*result));
                                } else {
                                    tell(result.error(), path);
                                }
                            });
}

void ProjectFiles::open(const QString& path)
{
    switch (fileKindOf(path)) {
    case FileKind::Project:
        return openProjectFile(path);
    case FileKind::Ptx:
        return openPtxFile(path);
    case FileKind::Mesh:
        return openMeshFile(path);
    case FileKind::Unknown:
        break;
    }
    emit failed(tr("%1 is not a kind of file that can be opened: it must end in .trixel, .ptx, "
                   ".obj, .ply, .stl or .off.")
                    .arg(fileName(path)));
}

void ProjectFiles::openProjectFile(const QString& path)
{
    load(
        path,
        [file = toPath(path)](Progress& progress) { return openProject(file, progress); },
        [this, path](Project project) {
            m_document.open(std::move(project), path, fileName(path));
            emit opened(path);
        });
}

void ProjectFiles::openPtxFile(const QString& path)
{
    load(
        path,
        [file = toPath(path)](Progress& progress) { return readPtxProject(file, progress); },
        [this, path](PtxOutcome outcome) {
            if (!outcome.project) {
                emit meshWanted(path, sentenceOf(outcome.meshFault, path));
                return;
            }
            m_document.open(std::move(*outcome.project), {}, fileName(path));
            emit opened(path);
        });
}

void ProjectFiles::openMeshFile(const QString& path)
{
    load(
        path,
        [file = toPath(path)](Progress& progress) { return readMeshProject(file, progress); },
        [this, path](Project project) {
            m_document.open(std::move(project), {}, QFileInfo(path).completeBaseName());
            emit opened(path);
            emit meshOpened(path);
        });
}

void ProjectFiles::openSample()
{
    load(
        tr("the sample scene"),
        [](Progress& progress) -> Result<Project> {
            QFile cage(":/sample/chameleon.obj");
            QFile strokes(":/sample/chameleon.strokes.json");
            check(cage.open(QIODevice::ReadOnly) && strokes.open(QIODevice::ReadOnly),
                  "the sample is among the resources");
            return buildSampleScene(
                cage.readAll().toStdString(), strokes.readAll().toStdString(), progress);
        },
        [this](Project project) {
            m_document.open(std::move(project), {}, tr("Chameleon"));
            emit sampleOpened();
        });
}

void ProjectFiles::openPtxOn(const QString& ptxPath, const QString& meshPath)
{
    load(
        ptxPath,
        [ptx = toPath(ptxPath), mesh = toPath(meshPath)](Progress& progress) {
            return readPtxOnMesh(ptx, mesh, progress);
        },
        [this, ptxPath, meshPath](PtxOnMesh outcome) {
            if (!outcome.project) {
                emit matchWanted(ptxPath,
                                 meshPath,
                                 tr("%1 Its faces can be matched %2.")
                                     .arg(sentenceOf(outcome.fault, ptxPath),
                                          QString::fromStdString(outcome.match)));
                return;
            }
            m_document.open(std::move(*outcome.project), {}, fileName(ptxPath));
            emit opened(ptxPath);
        });
}

void ProjectFiles::openPtxMatchedOn(const QString& ptxPath, const QString& meshPath)
{
    load(
        ptxPath,
        [ptx = toPath(ptxPath), mesh = toPath(meshPath)](Progress& progress) {
            return readPtxMatched(ptx, mesh, progress);
        },
        [this, ptxPath](MatchedPtx matched) {
            m_document.open(std::move(matched.project), {}, fileName(ptxPath));
            emit opened(ptxPath);
        });
}

void ProjectFiles::createNew(std::shared_ptr<const TriangleMesh> mesh,
                             const ProjectOptions& options,
                             const QString& name)
{
    load(
        name,
        [mesh = std::move(mesh), options](Progress& progress) {
            return makeProject(*mesh, options, progress);
        },
        [this, name](Project project) { m_document.open(std::move(project), {}, name); });
}

void ProjectFiles::save(const QString& path)
{
    m_document.endStroke();
    ++m_saving;
    emit savingChanged();
    m_document.whenSettled([this, path] { saveNow(path); });
}

void ProjectFiles::saveNow(const QString& path)
{
    const StateId state = m_document.state();
    const StateId project = m_document.openedState();
    m_jobs.run(
        tr("Saving %1…").arg(fileName(path)),
        [file = toPath(path), snapshot = m_document.snapshot()](Progress& progress) {
            return saveProject(file, snapshot, progress);
        },
        [this, path, state, project](const Status& status) {
            --m_saving;
            emit savingChanged();
            if (!status) {
                tell(status.error(), path);
            } else {
                // Another project may have been opened while this one was being written.
                if (m_document.openedState() == project) {
                    m_document.markSaved(path, state);
                }
                emit saved(path);
            }
            emit saveEnded(status.has_value());
        });
}

void ProjectFiles::exportAs(const ExportRequest& request)
{
    m_document.endStroke();
    ++m_exporting;
    m_document.whenSettled([this, request] { exportNow(request); });
}

void ProjectFiles::exportNow(const ExportRequest& request)
{
    const QString path = QString::fromStdString(request.path.string());
    m_jobs.run(
        tr("Exporting %1…").arg(fileName(path)),
        [project = m_document.snapshot(), request](Progress& progress) {
            return exportProject(ImageWorker(), project, request, progress);
        },
        [this, path](const Result<ExportOutcome>& outcome) {
            --m_exporting;
            if (outcome) {
                emit exported(path, *outcome);
            } else {
                tell(outcome.error(), path);
            }
            emit exportEnded();
        });
}

void ProjectFiles::tell(const Error& error, const QString& path)
{
    if (error.kind != ErrorKind::Cancelled) {
        emit failed(sentenceOf(error, path));
    }
}

} // namespace trixel::ui
