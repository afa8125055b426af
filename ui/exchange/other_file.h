// SPDX-License-Identifier: GPL-3.0-or-later
//
// Another texture of the open mesh: what is to be known of it before it is compared with.
#pragma once

#include <QString>

#include "core/io/ptx_rematch.h"
#include "core/texture/texel_diff.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace trixel::ui {

std::filesystem::path toPath(const QString& path);

/// An error as the window says it: the file without its folders, a full stop at the end.
QString sentenceOf(const Error& error, const QString& path);

/// Opens a project, or a .ptx that carries its mesh.
Result<std::shared_ptr<const Project>> openPainted(const QString& path, Progress& progress);

/// What a look at the file's structure tells.
struct OtherFile
{
    TexelFormat format;
    std::uint32_t faceCount = 0;
    PtxMatch match; ///< where the mesh's faces are in it

    bool needsMatch() const { return match.by != MatchedBy::Order; }
};

/// Looks into a .ptx or project that is to be compared with texels on a surface. Reads no texels.
/// Errors name the file: it cannot be read, has other numbers of faces or channels, or its faces
/// are others.
Result<OtherFile> lookAtOther(const std::filesystem::path& path,
                              const Surface& surface,
                              const TexelFormat& format,
                              Progress& progress);

/// What comparing found.
struct FileComparison
{
    QString path;
    TexelDiff diff;
    FaceMap<float> rms; ///< of every face, in parts of `diff.peak`; 0 where nothing differs
    PtxMatch match;
    TexelFormat format;       ///< of the other file
    QString notes;            ///< differences that are not of texels, a sentence each; often empty
    std::uint64_t texels = 0; ///< of all faces, as the document has them
};

/// Compares texels with those of a file.
/// \param matches  whether its faces are matched to the surface's, else compared by number
Result<std::shared_ptr<const FileComparison>>
compareWithOther(const Project& project, const QString& path, bool matches, Progress& progress);

} // namespace trixel::ui
