// SPDX-License-Identifier: GPL-3.0-or-later
//
// Other levels for faces that are painted already, the paint kept.
#pragma once

#include "core/base/parallel.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/mesh/adjacency.h"
#include "core/texture/texel_patch.h"
#include "core/texture/texel_store.h"

#include <cstdint>
#include <functional>
#include <span>

namespace trixel {

/// What a face's level is to become.
struct LevelChange
{
    enum class Kind { Set, Halve, Double };
    Kind kind = Kind::Set;
    Level level; ///< for Set

    /// Halving stops at level 0, doubling at Level::kMax.
    Level appliedTo(Level before) const;
};

/// Texels of the whole store before and after, as addressed (4^n a face, stored or not).
struct LevelCost
{
    std::uint64_t texelsBefore = 0;
    std::uint64_t texelsAfter = 0;
    std::uint64_t bytesBefore = 0;
    std::uint64_t bytesAfter = 0;
    std::uint32_t changedFaces = 0;

    bool operator==(const LevelCost&) const = default;
};

/// The levels the store has.
FaceMap<Level> levelsOf(const TexelStore& store);

/// The levels it would have. \param faces  each once
FaceMap<Level>
changedLevels(const TexelStore& store, std::span<const FaceId> faces, LevelChange change);

/// \param levels  one a face (checked)
LevelCost levelCost(const TexelStore& store, const FaceMap<Level>& levels);

/// Texels in another form, in which means are those that are wanted.
struct AveragedAs
{
    TexelFormat format;
    /// Into that form and out of it, at the face's own level, from several threads; faces of one
    /// value stay such.
    std::function<FaceTexels(const FaceTexels&)> into, outOf;
};

/// Brings every face to its level: coarser by `reduced`, finer by `refined`, one level at a time,
/// all from the texels as they were. Constant faces stay constant. Returns what was replaced, so
/// that swapping it is undo. Cost follows the faces that change and those around them. Fails
/// when cancelled or when one of these could not be read, and then leaves the store as it was.
/// \param levels    one a face (checked)
/// \param averaged  null for texels that are averaged as they are
Result<TexelPatch> changeLevels(TexelStore& store,
                                const Adjacency& adjacency,
                                const FaceMap<Level>& levels,
                                Threads threads,
                                Progress& progress,
                                const AveragedAs* averaged = nullptr);

} // namespace trixel
