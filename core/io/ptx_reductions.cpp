// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/ptx_reductions.h"

#include "core/base/check.h"
#include "core/io/ptx_average.h"
#include "core/io/ptx_encode.h"
#include "core/texture/mips.h"

#include <algorithm>
#include <cmath>
#include <ranges>
#include <string>
#include <utility>
#include <vector>

namespace trixel {

namespace {

struct StoredLevel
{
    Level level;
    std::vector<std::byte> texels;
};

std::vector<StoredLevel> reductionsOf(const TexelFormat& format, const FaceTexels& face)
{
    std::vector<StoredLevel> levels;
    PtxReducer reducer(format);
    reducer.forEach(face, [&](Level level, std::span<const std::byte> texels) {
        levels.push_back({level, {texels.begin(), texels.end()}});
        return true;
    });
    return levels;
}

} // namespace

PtxKeeping ptxKeeping(Level face, bool constant, Level level)
{
    check(level <= face, "a level that the face has");
    if (constant) {
        return PtxKeeping::Constant;
    }
    if (level == face || level.log2() >= kSmallestPtxReduction) {
        return PtxKeeping::Block;
    }
    return level.log2() == 0 ? PtxKeeping::Average : PtxKeeping::Computed;
}

std::span<const std::byte> PtxReducer::begin(const FaceTexels& face)
{
    if (!m_format.alpha) {
        return face.bytes();
    }
    const std::span<std::byte> premultiplied = m_premultiplied.first(face.bytes().size());
    std::ranges::copy(face.bytes(), premultiplied.begin());
    premultiply(m_format, premultiplied);
    return premultiplied;
}

std::span<const std::byte>
PtxReducer::reduce(Level fine, std::span<const std::byte> from, Buffer& to) const
{
    const std::span<std::byte> coarser =
        to.first(fine.coarser().texelCount() * m_format.texelBytes());
    reduceTexels(m_format, fine, from, coarser);
    return coarser;
}

Status measurePtxLevels(const TexelFormat& format,
                        const FaceTexels& face,
                        const std::function<void(Level level, std::uint64_t bytes)>& tell,
                        Progress& progress)
{
    if (face.collapsed().isConstant()) {
        return {};
    }
    const std::vector<StoredLevel> reductions = reductionsOf(format, face);
    PtxEncoder encoder;
    std::vector<std::byte> block;
    const auto measure = [&](Level level, std::span<const std::byte> texels) -> Status {
        // Four times the texels, four times the time.
        if (!progress.report(std::pow(0.25, face.level().log2() - level.log2()))) {
            return cancelled();
        }
        block.clear();
        const PtxBlockHeader header = encodePtxBlock(format, level, texels, encoder, block);
        if (header.size() == 0) {
            return contentsError("level " + std::to_string(level.log2()) +
                                 " takes more bytes than a .ptx can hold in one face");
        }
        tell(level, header.size());
        return {};
    };
    for (const StoredLevel& reduction : std::views::reverse(reductions)) {
        if (Status status = measure(reduction.level, reduction.texels); !status) {
            return status;
        }
    }
    return measure(face.level(), face.bytes());
}

} // namespace trixel
