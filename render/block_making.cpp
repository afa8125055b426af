// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/block_making.h"

#include "core/base/check.h"
#include "core/lattice/texel.h"
#include "core/texture/coarser_levels.h"
#include "core/texture/mips.h"
#include "core/texture/touched_cells.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <utility>

namespace trixel::render {

namespace {

constexpr std::size_t kGrain = 1U << 12U;

/// The texel in the middle of a face in memory.
std::span<const std::byte> middleTexel(const FaceTexels& face)
{
    const TexelCoord coarse = texelAt(Level(), TexelIndex{});
    const TexelCoord middle = texelAt(face.level(), centroid(Level(), coarse));
    return face.texel(indexOf(texelIndex(face.level(), middle)));
}

/// The face in memory, or the coarsest of the levels that its file keeps that will do: not to stay
/// in memory for having been looked at once.
FaceTexels readAt(const CardForm& form, const FaceTexels& face, Level level)
{
    if (face.isStored() && !face.isLoaded() && level < face.level() && form.mipDrop == 0) {
        if (const auto mean = face.mean(); mean && level == Level()) {
            return FaceTexels::constant(level, *mean);
        }
        for (int k = level.log2(); k < face.level().log2(); ++k) {
            if (auto kept = face.storedLevel(Level(k))) {
                return std::move(*kept);
            }
        }
    }
    return face.pinned();
}

/// Level by level in two buffers by turns.
class Reduction
{
public:
    explicit Reduction(const TexelFormat& format)
        : m_format(format)
    {
    }

    std::span<const std::byte> operator()(const FaceTexels& face, Level level)
    {
        check(level <= face.level(), "a level that the face has");
        if (face.isConstant()) {
            return face.bytes();
        }
        std::span<const std::byte> fine = face.bytes();
        for (int k = face.level().log2(); k > level.log2(); --k) {
            std::vector<std::byte>& coarse = m_buffers[static_cast<std::size_t>(k % 2)];
            coarse.resize(m_format.texelBytes() * Level(k - 1).texelCount());
            reduceTexels(m_format, Level(k), fine, coarse);
            fine = coarse;
        }
        return fine;
    }

private:
    const TexelFormat& m_format;
    std::array<std::vector<std::byte>, 2> m_buffers;
};

} // namespace

CardForm CardForm::of(const TexelStore& store, int mipDrop)
{
    return {store.format(), usualChannels(store.format()), mipDrop};
}

CardOpening openCard(const TexelStore& store, const CardForm& form, bool exact, Threads threads)
{
    CardOpening opening;
    opening.form = form;
    opening.faces.resize(store.faceCount());
    opening.bases.resize(store.faceCount() * form.elementBytes());
    parallelFor(store.faceCount(), kGrain, threads, [&](std::size_t begin, std::size_t end) {
        Reduction reduction(form.format);
        std::vector<std::byte> shown;
        for (std::size_t f = begin; f < end; ++f) {
            const FaceTexels& face = store.face(faceId(f));
            const auto mean = face.mean();
            const bool isMean = mean || exact || face.level() == Level();
            opening.faces[f] = static_cast<std::uint8_t>(
                form.shownLevel(face).log2() | (face.isConstant() ? CardOpening::kConstant : 0) |
                (isMean ? CardOpening::kMean : 0));
            const auto base = mean ? *mean : exact ? reduction(face, Level()) : middleTexel(face);
            appendShown(form.format, form.channels, base, shown);
        }
        std::memcpy(opening.bases.data() + begin * form.elementBytes(), shown.data(), shown.size());
    });
    return opening;
}

MadeBlocks makeBlocks(const TexelStore& store, const CardForm& form, std::span<const BlockJob> jobs)
{
    MadeBlocks made;
    made.jobs.assign(jobs.begin(), jobs.end());
    made.ends.reserve(jobs.size());
    made.bytes.reserve(bytesOf(form, jobs));
    Reduction reduction(form.format);
    for (const BlockJob& job : jobs) {
        const FaceTexels& face = store.face(job.face);
        const bool isPossible =
            job.level == 0 || (!face.isConstant() && job.level <= face.level().log2());
        if (isPossible) {
            const FaceTexels read = readAt(form, face, Level(job.level));
            appendShown(form.format, form.channels, reduction(read, Level(job.level)), made.bytes);
        }
        made.ends.push_back(made.bytes.size());
    }
    return made;
}

std::size_t bytesOf(const CardForm& form, std::span<const BlockJob> jobs)
{
    std::size_t elements = 0;
    for (const BlockJob& job : jobs) {
        elements += Level(job.level).texelCount();
    }
    return elements * form.elementBytes();
}

void appendAtLevel(const CardForm& form,
                   const FaceTexels& face,
                   Level level,
                   std::vector<std::byte>& bytes)
{
    appendShown(form.format, form.channels, Reduction(form.format)(face, level), bytes);
}

std::vector<std::uint32_t> touchedAt(Level level, Level faceLevel, const TouchedRect& rect)
{
    TouchedCells cells(faceLevel, rect);
    for (int k = faceLevel.log2(); k > level.log2(); --k) {
        cells = cells.coarser();
    }
    std::vector<std::uint32_t> texels;
    const std::uint32_t last = level.resolution() - 1;
    for (std::size_t k = 0; k < cells.count; ++k) {
        const CellRect& in = cells.rects[k];
        for (std::uint32_t j = in.j0; j <= std::min(in.j1, last); ++j) {
            for (std::uint32_t i = in.i0; i <= std::min(in.i1, last); ++i) {
                for (const TexelHalf half : {TexelHalf::Lower, TexelHalf::Upper}) {
                    const TexelCoord texel{
                        static_cast<std::uint16_t>(i), static_cast<std::uint16_t>(j), half};
                    if (isValid(level, texel)) {
                        texels.push_back(
                            static_cast<std::uint32_t>(indexOf(texelIndex(level, texel))));
                    }
                }
            }
        }
    }
    std::ranges::sort(texels);
    const auto repeated = std::ranges::unique(texels);
    texels.erase(repeated.begin(), repeated.end());
    return texels;
}

} // namespace trixel::render
