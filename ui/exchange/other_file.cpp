// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/exchange/other_file.h"

#include <QFileInfo>
#include <QObject>

#include "core/io/layers_metadata.h"
#include "core/io/ptx_reader.h"
#include "ui/document/project_files.h"

#include <utility>

namespace trixel::ui {

namespace {

QString channelsText(std::uint16_t channels)
{
    return channels == 1 ? QObject::tr("1 channel") : QObject::tr("%1 channels").arg(channels);
}

QString alphaText(const TexelFormat& format)
{
    return format.alpha ? QObject::tr("channel %1").arg(*format.alpha) : QObject::tr("no channel");
}

QString notesOn(const TexelFormat& ours, const TexelFormat& theirs)
{
    QStringList notes;
    if (ours.type != theirs.type) {
        notes += QObject::tr("It stores %1, this project %2.")
                     .arg(QString::fromUtf8(nameOf(theirs.type).data()),
                          QString::fromUtf8(nameOf(ours.type).data()));
    }
    if (ours.alpha != theirs.alpha) {
        notes += QObject::tr("Its opacity is %1, this project's %2.")
                     .arg(alphaText(theirs), alphaText(ours));
    }
    return notes.join(' ');
}

/// The other file's texels, face by face those of the project's surface.
Result<MatchedPtx>
openOther(const Project& project, const QString& path, bool matches, Progress& progress)
{
    if (matches) {
        return openPtxMatched(toPath(path), project.surface, progress);
    }
    auto opened = openPtxTexels(toPath(path), progress);
    if (!opened) {
        return tl::unexpected(opened.error());
    }
    MatchedPtx other;
    other.project.texels = std::move(opened->texels);
    other.project.storedFaces = std::move(opened->faces);
    return other;
}

} // namespace

std::filesystem::path toPath(const QString& path)
{
    return std::filesystem::path(path.toStdU16String());
}

QString sentenceOf(const Error& error, const QString& path)
{
    QString sentence = QString::fromStdString(error.message);
    sentence.replace(path, QFileInfo(path).fileName());
    return sentence.endsWith('.') ? sentence : sentence + '.';
}

Result<std::shared_ptr<const Project>> openPainted(const QString& path, Progress& progress)
{
    const FileKind kind = fileKindOf(path);
    if (kind != FileKind::Project && kind != FileKind::Ptx) {
        return contentsError(QObject::tr("%1: expected a project or a .ptx that carries its mesh")
                                 .arg(path)
                                 .toStdString());
    }
    auto project = kind == FileKind::Project ? openProject(toPath(path), progress)
                                             : openPtx(toPath(path), progress);
    if (!project) {
        return tl::unexpected(project.error());
    }
    return std::make_shared<const Project>(std::move(*project));
}

Result<OtherFile> lookAtOther(const std::filesystem::path& path,
                              const Surface& surface,
                              const TexelFormat& format,
                              Progress& progress)
{
    MemoryBudget budget;
    const auto file = openPtxFile(path, budget);
    if (!file) {
        return tl::unexpected(file.error());
    }
    const auto metadata = file->metadata(budget);
    if (!metadata) {
        return prefixed(path.string(), metadata.error());
    }
    const auto theirs = shownFormat(file->format(), *metadata);
    if (!theirs) {
        return prefixed(path.string(), theirs.error());
    }
    if (file->faceCount() == surface.mesh().faceCount() && theirs->channels != format.channels) {
        return contentsError(QObject::tr("%1: has %2, this project %3")
                                 .arg(QString::fromStdString(path.string()),
                                      channelsText(theirs->channels),
                                      channelsText(format.channels))
                                 .toStdString());
    }
    auto match = matchPtx(*file, *metadata, surface, progress);
    if (!match) {
        return match.error().kind == ErrorKind::Contents ? prefixed(path.string(), match.error())
                                                         : tl::unexpected(match.error());
    }
    return OtherFile{*theirs, file->faceCount(), std::move(*match)};
}

Result<std::shared_ptr<const FileComparison>>
compareWithOther(const Project& project, const QString& path, bool matches, Progress& progress)
{
    StageProgress opening(progress, 0, 0.5);
    auto other = openOther(project, path, matches, opening);
    if (!other) {
        return tl::unexpected(other.error());
    }
    const DiffSide ours = DiffSide::of(project.texels);
    const DiffSide theirs = DiffSide::of(other->project.texels);
    if (const std::string why = incomparable(ours, theirs); !why.empty()) {
        return contentsError(path.toStdString() + ": " + why);
    }
    StageProgress comparing(progress, 0.5, 1);
    auto diff = diffTexels(ours, theirs, {.acrossLevels = true}, comparing);
    if (!diff) {
        return tl::unexpected(diff.error());
    }
    auto result = std::make_shared<FileComparison>();
    result->path = path;
    result->rms = FaceMap<float>(ours.faceCount, 0.0F);
    for (const FaceDifference& face : diff->faces) {
        result->rms[face.face] = static_cast<float>(face.rms / diff->peak);
    }
    result->diff = std::move(*diff);
    result->match = std::move(other->match);
    result->format = theirs.format;
    result->notes = notesOn(ours.format, theirs.format);
    result->texels = project.texels.texelCount();
    return std::shared_ptr<const FileComparison>(std::move(result));
}

} // namespace trixel::ui
