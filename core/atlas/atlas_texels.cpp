// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/atlas/atlas_texels.h"

#include "core/atlas/unfolded_place.h"
#include "core/mesh/face_pieces.h"
#include "core/texture/mips.h"
#include "core/texture/opacity.h"

#include <algorithm>
#include <cstring>
#include <deque>
#include <utility>

namespace trixel {

namespace {

/// Copies a texel to so many that follow each other.
void repeat(std::span<const std::byte> texel, std::size_t count, std::byte* target)
{
    for (std::size_t k = 0; k < count; ++k) {
        std::memcpy(target + k * texel.size(), texel.data(), texel.size());
    }
}

FaceTexels coarser(const TexelFormat& format, const FaceTexels& face)
{
    return format.alpha
               ? unweighed(reduced(weighedFormat(format), weighed(face.pinned(), format)), format)
               : reduced(format, face);
}

} // namespace

/// Faces about a tile, for as long as it is filled: those still in their file are read to be
/// forgotten again.
class AtlasTexels::Neighbours
{
public:
    explicit Neighbours(const std::vector<FaceTexels>& faces)
        : m_faces(faces)
    {
    }

    const FaceTexels& operator[](FaceId face)
    {
        const FaceTexels& texels = m_faces[indexOf(face)];
        if (!texels.isStored()) {
            return texels;
        }
        auto known = std::ranges::find(m_pinned, face, &Pinned::face);
        if (known == m_pinned.end()) {
            known = m_pinned.insert(m_pinned.end(), {face, texels.pinned()});
        }
        return known->texels;
    }

private:
    struct Pinned
    {
        FaceId face{};
        FaceTexels texels;
    };

    const std::vector<FaceTexels>& m_faces;
    std::deque<Pinned> m_pinned; // a few: those about the tile's corners
};

AtlasTexels::AtlasTexels(const TexelStore& store, const Adjacency& adjacency)
    : m_adjacency(adjacency)
    , m_format(store.format())
    , m_faces(store.faceCount())
{
    check(adjacency.faceCount() == store.faceCount(), "adjacency of these faces");
    for (std::size_t f = 0; f < m_faces.size(); ++f) {
        m_faces[f] = store.face(faceId(f));
        m_level = std::max(m_level, m_faces[f].level());
    }
}

void AtlasTexels::coarsen(Threads threads)
{
    NoProgress progress;
    const Status done = coarsen(threads, progress);
    check(done.has_value(), "memory for a coarser level");
}

Status AtlasTexels::coarsen(Threads threads, Progress& progress)
{
    check(m_level > Level(), "a level to reduce");
    const auto cost = [&](FaceId face) -> std::uint64_t {
        const FaceTexels& texels = m_faces[indexOf(face)];
        return texels.level() == m_level && !texels.isConstant() ? m_level.texelCount() : 1;
    };
    const Status done = forWholeFaces(m_faces.size(), cost, threads, progress, [&](FaceId face) {
        FaceTexels& texels = m_faces[indexOf(face)];
        if (texels.level() == m_level) {
            texels = coarser(m_format, texels);
        }
    });
    if (done) {
        m_level = m_level.coarser();
    }
    return done;
}

void AtlasTexels::replace(FaceId face, FaceTexels texels)
{
    check(texels.level() == levelOf(face), "texels of the level that the face has");
    m_faces[indexOf(face)] = std::move(texels);
}

AtlasSource AtlasTexels::source(FaceId face, LatticeCell cell) const
{
    const double third = cell.half == TexelHalf::Lower ? 1.0 / 3.0 : 2.0 / 3.0;
    const glm::dvec2 uv =
        glm::dvec2(cell.i + third, cell.j + third) / double(levelOf(face).resolution());
    const SurfacePlace place = unfoldedPlace(m_adjacency, face, uv);
    return {place.face, levelOf(place.face), texelAt(levelOf(place.face), place.uv)};
}

void AtlasTexels::fillBorder(Neighbours& neighbours,
                             FaceId face,
                             const AtlasTile& tile,
                             std::uint32_t row,
                             std::uint32_t begin,
                             std::uint32_t end,
                             std::byte* target) const
{
    const std::size_t texelBytes = m_format.texelBytes();
    for (std::uint32_t x = begin; x < end; ++x) {
        const AtlasSource from = source(face, tile.cell({x, row}));
        const auto texel = neighbours[from.face].texel(indexOf(texelIndex(from.level, from.texel)));
        std::memcpy(target + x * texelBytes, texel.data(), texelBytes);
    }
}

void AtlasTexels::fill(FaceId face,
                       const AtlasTile& tile,
                       std::byte* page,
                       std::size_t stride) const
{
    Neighbours neighbours(m_faces);
    const FaceTexels& texels = neighbours[face];
    const std::uint32_t resolution = texels.level().resolution();
    const std::size_t texelBytes = m_format.texelBytes();
    const std::uint32_t side = tile.side();
    check(side == resolution || side == resolution + 4, "the tile of this level");
    // Each half keeps its rows and columns as in the packed square, moved by so many pixels.
    const std::uint32_t lower = side == resolution ? 0 : 1;
    const std::uint32_t upper = 3 * lower;
    const auto copy = [&](std::uint32_t x, std::uint32_t y, std::uint32_t count, std::byte* to) {
        if (texels.isConstant()) {
            repeat(texels.bytes(), count, to);
        } else {
            std::memcpy(to,
                        texels.bytes().data() + (std::size_t{y} * resolution + x) * texelBytes,
                        count * texelBytes);
        }
    };
    for (std::uint32_t row = 0; row < side; ++row) {
        std::byte* target = page + row * stride;
        std::uint32_t done = 0; // columns of this row
        const auto place =
            [&](std::uint32_t x, std::uint32_t y, std::uint32_t count, std::uint32_t moved) {
                fillBorder(neighbours, face, tile, row, done, x + moved, target);
                copy(x, y, count, target + (x + moved) * texelBytes);
                done = x + moved + count;
            };
        if (row >= lower && row - lower < resolution) {
            place(0, row - lower, resolution - (row - lower), lower);
        }
        if (row >= upper && row - upper < resolution && row > upper) {
            place(resolution - (row - upper), row - upper, row - upper, upper);
        }
        fillBorder(neighbours, face, tile, row, done, side, target);
    }
}

} // namespace trixel
