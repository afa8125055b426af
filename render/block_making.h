// SPDX-License-Identifier: GPL-3.0-or-later
//
// Texels on their way to the graphics card: made on any thread from a snapshot of the store.
#pragma once

#include "core/base/parallel.h"
#include "core/texture/texel_store.h"
#include "core/texture/touched_rect.h"
#include "render/display_conversion.h"
#include "render/residency.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace trixel::render {

/// How texels of a store become elements of a buffer.
struct CardForm
{
    TexelFormat format;
    CardChannels channels{0, 1, 2, -1};
    int mipDrop = 0; ///< every face is shown this many levels coarser (>= 0)

    static CardForm of(const TexelStore& store, int mipDrop);
    std::size_t elementBytes() const { return texelBytes(displayFormat(format.type)); }
    Level shownLevel(const FaceTexels& face) const { return face.level().coarser(mipDrop); }

    bool operator==(const CardForm&) const = default;
};

/// What there is to show of a store at the least: the first that is sent.
struct CardOpening
{
    static constexpr std::uint8_t kConstant = 0x80;
    static constexpr std::uint8_t kMean = 0x40; ///< the base is the face's mean

    CardForm form;
    std::vector<std::uint8_t> faces; ///< level to be shown at most, and flags
    std::vector<std::byte> bases;    ///< one element a face, or three

    static int level(std::uint8_t face) { return face & 0x3f; }
    bool isConstant(std::size_t face) const { return (faces[face] & kConstant) != 0; }
    /// Finest level worth a block.
    std::uint8_t ownLevel(std::size_t face) const
    {
        return isConstant(face) ? std::uint8_t{0} : static_cast<std::uint8_t>(level(faces[face]));
    }
    /// For `CardBlocks::mark`.
    std::uint32_t recordBits(std::size_t face) const
    {
        return FaceRecord::bitsOf(level(faces[face]), isConstant(face));
    }
};

/// \param exact  whether to read every texel for means; else, but where a file keeps them, a texel
///               from the middle stands for them, until jobs of level 0 bring means
CardOpening openCard(const TexelStore& store, const CardForm& form, bool exact, Threads threads);

/// Blocks made for jobs, one after the other.
struct MadeBlocks
{
    std::vector<BlockJob> jobs;
    std::vector<std::size_t> ends; ///< of each job's bytes; a job that cannot be done has none
    std::vector<std::byte> bytes;
};

/// Texels at the level of each job, at level 0 their mean. A face that is coarser by now, or
/// constant, cannot be done at a finer level. Of faces still in their file coarser levels are those
/// that the file keeps, unless levels are dropped on purpose.
MadeBlocks
makeBlocks(const TexelStore& store, const CardForm& form, std::span<const BlockJob> jobs);

/// Bytes that the jobs' blocks will take.
std::size_t bytesOf(const CardForm& form, std::span<const BlockJob> jobs);

/// Appends the texels of a face reduced to a level. \param level  not above the face's (checked)
void appendAtLevel(const CardForm& form,
                   const FaceTexels& face,
                   Level level,
                   std::vector<std::byte>& bytes);

/// Which texels of a coarser level a rectangle of a face changes: packed indices, ascending.
std::vector<std::uint32_t> touchedAt(Level level, Level faceLevel, const TouchedRect& rect);

} // namespace trixel::render
