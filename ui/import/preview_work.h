// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/import/import_work.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace trixel::ui {

/// What an import will look like, and what it will take.
struct PreviewPicture
{
    TexelStore texels;
    std::uint32_t facesReached = 0;
    std::uint64_t texelsReached = 0; ///< of those faces, at their own levels
    double seconds = 0;              ///< that all of it will take, from what this took
    bool isComplete = false;         ///< these are the very texels that an import leaves
};

/// Faces at a coarser level, kept between previews. For one thread at a time.
class CoarseFaces
{
public:
    /// \param texels  whose faces these are
    explicit CoarseFaces(TexelStore texels);

    const TexelStore& texels() const { return m_texels; }
    /// Faces no finer than the level. \param faces  each once
    void prepare(std::span<const FaceId> faces, Level level);
    /// One that was prepared for that level.
    const FaceTexels& face(FaceId face) const { return m_faces[face]; }

private:
    TexelStore m_texels;
    std::optional<Level> m_level;
    FaceMap<FaceTexels> m_faces; ///< empty ones are not made yet
    std::vector<std::uint8_t> m_isMade;
};

/// Makes one preview, pass after pass, each of finer texels: the first within the time that a
/// dragged corner may lag behind, the last as the import itself makes them unless they are very
/// many. For one thread at a time.
class PreviewMaker
{
public:
    /// \param coarse  of the same texels
    PreviewMaker(ImportInput input, std::shared_ptr<CoarseFaces> coarse);

    bool isDone() const { return m_isDone; }
    /// Whether the next pass is the quick one.
    bool isFirst() const { return !m_prepared; }
    /// Fails as `importImage` does.
    Result<std::shared_ptr<const PreviewPicture>> next(Progress& progress);

private:
    std::uint64_t texelsAt(Level level) const;
    Level finestWithin(std::uint64_t texels) const;
    void choosePass();

    ImportInput m_input;
    std::shared_ptr<CoarseFaces> m_coarse;
    std::optional<PreparedImport> m_prepared;
    std::vector<std::uint32_t> m_facesOfLevel; ///< in reach
    Level m_highest;                           ///< of these
    std::size_t m_pass = 0;
    Level m_level; ///< of the pass to come: no face is finer
    bool m_isDone = false;
};

} // namespace trixel::ui
