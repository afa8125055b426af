// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bringing a .ptx onto a mesh that has its faces in another order, begun at other corners or wound
// the other way round.
#pragma once

#include "core/io/project.h"
#include "core/io/ptx_file.h"
#include "core/mesh/face_match.h"

#include <filesystem>
#include <memory>
#include <span>
#include <string>

namespace trixel {

/// What tells which face is which.
enum class MatchedBy {
    Order,     ///< the file's faces are the mesh's as they stand
    Positions, ///< of the corners, which the file carries
    Neighbours ///< who borders on whom
};

/// Where the faces of a mesh are in a .ptx.
struct PtxMatch
{
    FaceMatch faces;
    MatchedBy by = MatchedBy::Order;

    std::size_t moved() const;  ///< faces that have another number in the file
    std::size_t turned() const; ///< faces that begin at another corner, wound alike
    std::size_t turnedOver() const;
    /// "by their positions: 12 of 20 faces have another number, 3 begin at another corner, 0 are
    /// wound the other way round"
    std::string describe() const;
};

/// Finds out by the vertex positions that the file carries; where there are none, or they lie
/// elsewhere, by the file's order if its links fit the mesh, else by the links.
/// Errors do not name the file: other numbers of faces, no match, more than one, cancelled.
Result<PtxMatch> matchPtx(const PtxFile& file,
                          std::span<const PtxMetadata> metadata,
                          const Surface& surface,
                          Progress& progress);

/// A .ptx on a mesh, its texels where the mesh's faces are.
struct MatchedPtx
{
    Project project;
    PtxMatch match;
    bool hasMips = true; ///< whether the file stores reduced levels
};

/// Opens a .ptx or a project on a mesh of the same faces, whatever their order and winding: texels
/// move with their faces, to the bit. Errors name the file.
Result<MatchedPtx> openPtxMatched(const std::filesystem::path& path,
                                  std::shared_ptr<const Surface> surface,
                                  Progress& progress,
                                  const OpenOptions& options = {});

} // namespace trixel
