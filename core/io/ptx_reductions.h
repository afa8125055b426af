// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which levels of a face a .ptx stores, with what texels, and how many bytes that takes.
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/io/buffer.h"
#include "core/texture/face_texels.h"
#include "core/texture/texel_format.h"

#include <array>
#include <cstdint>
#include <functional>
#include <span>

namespace trixel {

/// Smallest reduction that is stored: 4 by 4 texels.
inline constexpr int kSmallestPtxReduction = 2;

/// How many reductions of a face that is not constant are stored.
constexpr int ptxReductions(Level level)
{
    return level.log2() > kSmallestPtxReduction ? level.log2() - kSmallestPtxReduction : 0;
}

/// How a .ptx with mips keeps one level of a face.
enum class PtxKeeping : std::uint8_t {
    Block,    ///< its texels, packed
    Constant, ///< the face's one value, in the table of constants; levels cost nothing
    Average,  ///< one texel: the face's average, in the same table
    Computed  ///< not at all: readers reduce what is stored
};

/// \param constant  whether all texels of the face are alike
/// \param level     not above `face` (checked)
PtxKeeping ptxKeeping(Level face, bool constant, Level level);

/// Makes the reductions of one face after the other, with memory that is kept in between.
class PtxReducer
{
public:
    explicit PtxReducer(const TexelFormat& format)
        : m_format(format)
    {
    }

    /// Calls visit(Level, std::span<const std::byte>) for each stored reduction from the finest,
    /// until one returns false; the texels are good until the next. Each is made from the one
    /// before it as stored; with alpha, from premultiplied texels.
    /// \return  false if a visit did
    template <class Visit>
    bool forEach(const FaceTexels& face, Visit visit)
    {
        const int count = ptxReductions(face.level());
        std::span<const std::byte> finer = count > 0 ? begin(face) : face.bytes();
        for (int k = 0; k < count; ++k) {
            finer = reduce(face.level().coarser(k), finer, m_reductions[k % 2]);
            if (!visit(face.level().coarser(k + 1), finer)) {
                return false;
            }
        }
        return true;
    }

private:
    std::span<const std::byte> begin(const FaceTexels& face);
    std::span<const std::byte>
    reduce(Level fine, std::span<const std::byte> from, Buffer& to) const;

    TexelFormat m_format;
    Buffer m_premultiplied;
    std::array<Buffer, 2> m_reductions;
};

/// Bytes that the blocks of one face's levels take in a .ptx with mips; the coarsest is told of
/// first. Nothing is told of levels that are not blocks. Fails when cancelled, and when a block is
/// larger than the format can hold.
/// \param tell  called from this thread
Status measurePtxLevels(const TexelFormat& format,
                        const FaceTexels& face,
                        const std::function<void(Level level, std::uint64_t bytes)>& tell,
                        Progress& progress);

} // namespace trixel
