// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texture/reduced_texel.h"

#include "core/base/check.h"
#include "core/lattice/reduction.h"
#include "core/texture/mips.h"

#include <algorithm>
#include <vector>

namespace trixel {

namespace {

/// Goes down to the texels of the face and comes back with one mean a level.
class Reduction
{
public:
    Reduction(const TexelFormat& format, const FaceTexels& face, int steps)
        : m_format(format)
        , m_face(face)
        , m_fourTexels(4 * format.texelBytes() * static_cast<std::size_t>(steps))
    {
    }

    void texel(Level level, PackedPixel pixel, std::span<std::byte> target)
    {
        if (level == m_face.level()) {
            const auto bytes = m_face.texel(indexOf(texelIndex(level, pixel)));
            std::ranges::copy(bytes, target.begin());
            return;
        }
        const std::size_t bytes = m_format.texelBytes();
        const Level finer(level.log2() + 1);
        const auto above = static_cast<std::size_t>(m_face.level().log2() - finer.log2());
        const std::span<std::byte> four =
            std::span(m_fourTexels).subspan(4 * bytes * above, 4 * bytes);
        std::size_t k = 0;
        for (const PackedPixel& child : finerPixels(finer, pixel)) {
            texel(finer, child, four.subspan(bytes * k++, bytes));
        }
        // A face of four texels lists them in the order in which any coarser texel sums its own.
        reduceTexels(m_format, Level(1), four, target);
    }

private:
    const TexelFormat& m_format;
    const FaceTexels& m_face;
    std::vector<std::byte> m_fourTexels; ///< four for every level on the way
};

} // namespace

void reducedTexel(const TexelFormat& format,
                  const FaceTexels& face,
                  int steps,
                  TexelIndex index,
                  std::span<std::byte> target)
{
    const Level level = face.level().coarser(steps);
    check(steps >= 0 && indexOf(index) < level.texelCount(), "a texel of the coarser level");
    check(target.size() == format.texelBytes(), "room for one texel");
    if (face.isConstant()) {
        std::ranges::copy(face.texel(0), target.begin());
        return;
    }
    const int taken = face.level().log2() - level.log2();
    Reduction(format, face, taken).texel(level, packedPixel(level, index), target);
}

} // namespace trixel
