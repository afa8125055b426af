// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mapping/bake.h"

#include "core/base/check.h"
#include "core/lattice/texel.h"
#include "core/mapping/bake_channels.h"
#include "core/mesh/shared_progress.h"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <new>
#include <string>

namespace trixel {

namespace {

/// Texels that one thread bakes between two looks at the progress.
constexpr std::size_t kTexelsAtOnce = 4096;

/// Some rows of a face's packed square.
struct Piece
{
    std::uint32_t number = 0; ///< of the face, among those to bake
    std::uint32_t firstRow = 0;
    std::uint32_t rows = 0;
};

std::vector<Piece> piecesOf(const TexelStore& store, std::span<const FaceId> faces)
{
    std::vector<Piece> pieces;
    for (std::uint32_t k = 0; k < faces.size(); ++k) {
        const std::uint32_t rows = store.face(faces[k]).level().resolution();
        const std::uint32_t atOnce =
            static_cast<std::uint32_t>(std::max<std::size_t>(1, kTexelsAtOnce / rows));
        for (std::uint32_t row = 0; row < rows; row += atOnce) {
            pieces.push_back({k, row, std::min(atOnce, rows - row)});
        }
    }
    return pieces;
}

/// Runs of pieces that are worth a thread's while: where faces are small, many of them. Each run is
/// given by where it begins, and the last by its end.
std::vector<std::size_t>
runsOf(std::span<const Piece> pieces, const TexelStore& store, std::span<const FaceId> faces)
{
    std::vector<std::size_t> begins{0};
    std::size_t texels = 0;
    for (std::size_t p = 0; p < pieces.size(); ++p) {
        texels +=
            std::size_t{pieces[p].rows} * store.face(faces[pieces[p].number]).level().resolution();
        if (texels >= kTexelsAtOnce || p + 1 == pieces.size()) {
            begins.push_back(p + 1);
            texels = 0;
        }
    }
    return begins;
}

/// What a face becomes, made by several threads that each fill rows of their own.
struct MadeFace
{
    std::once_flag allocated;
    std::vector<std::byte> texels;
    std::atomic<std::uint32_t> reached{0}; ///< texels that the image lies on
};

class PieceBaker
{
public:
    PieceBaker(const Mapping& mapping,
               const ImageTiles& images,
               const BakeChannels& channels,
               const TexelFormat& format,
               float opacity)
        : m_mapping(mapping)
        , m_images(images)
        , m_channels(channels)
        , m_format(format)
        , m_opacity(opacity)
        , m_values(format.channels)
        , m_colors(3 * images.groups())
    {
    }

    /// Fills `texels`, those of the rows, and returns how many of them the image lies on.
    std::uint32_t bake(FaceId face,
                       const FaceTexels& before,
                       std::uint32_t firstTexel,
                       std::span<std::byte> texels)
    {
        const Level level = before.level();
        const double step = 1.0 / level.resolution();
        const std::size_t bytes = m_format.texelBytes();
        std::uint32_t reached = 0;
        for (std::size_t k = 0; k < texels.size() / bytes; ++k) {
            const auto texel = TexelIndex{firstTexel + static_cast<std::uint32_t>(k)};
            const auto stored = before.texel(indexOf(texel));
            const auto target = texels.subspan(k * bytes, bytes);
            const ImagePlace place =
                m_mapping.at(face, centroid(level, texelAt(level, texel)), step);
            if (place.lands && lay(place, stored, target)) {
                ++reached;
            } else {
                std::copy(stored.begin(), stored.end(), target.begin());
            }
        }
        return reached;
    }

private:
    bool
    lay(const ImagePlace& place, std::span<const std::byte> stored, std::span<std::byte> target)
    {
        float opacity = 0;
        for (std::size_t group = 0; group < m_images.groups(); ++group) {
            const glm::vec4 value = m_images.at(place.st, place.footprint, group);
            for (int c = 0; c < 3; ++c) {
                m_colors[3 * group + static_cast<std::size_t>(c)] = value[c] * m_opacity;
            }
            opacity = value.a * m_opacity;
        }
        if (!(opacity > 0)) {
            return false;
        }
        decode(m_format.type, stored, m_values);
        m_channels.lay(m_colors, opacity, m_values);
        encode(m_format.type, m_values, target);
        return true;
    }

    const Mapping& m_mapping;
    const ImageTiles& m_images;
    const BakeChannels& m_channels;
    TexelFormat m_format;
    float m_opacity;
    std::vector<float> m_values, m_colors;
};

/// Faces that lie in a file are read once, not by every thread that bakes a piece of them.
Status readAll(const TexelStore& store, std::span<const FaceId> faces)
{
    for (const FaceId face : faces) {
        const FaceTexels& texels = store.face(face);
        if (texels.isStored()) {
            (void)texels.bytes();
            if (texels.isDamaged()) {
                return contentsError("face " + std::to_string(indexOf(face)) +
                                     " could not be read from its file; fill it before an image "
                                     "is laid onto it");
            }
        }
    }
    return {};
}

/// Makes every face, as far as the image reaches it.
class FaceBaker
{
public:
    FaceBaker(const TexelStore& store, std::span<const FaceId> faces)
        : m_store(store)
        , m_faces(faces)
        , m_made(faces.size())
    {
    }

    Status make(const Mapping& mapping,
                const ImageTiles& images,
                const BakeOptions& options,
                Progress& progress)
    {
        const BakeChannels channels(m_store.format(), options.colors, images.colors());
        const std::vector<Piece> pieces = piecesOf(m_store, m_faces);
        const std::vector<std::size_t> runs = runsOf(pieces, m_store, m_faces);
        SharedProgress shared(progress, runs.size());
        std::atomic<bool> outOfMemory{false};
        parallelFor(runs.size() - 1, 1, options.threads, [&](std::size_t begin, std::size_t end) {
            try {
                PieceBaker baker(mapping, images, channels, m_store.format(), options.opacity);
                for (std::size_t r = begin; r < end && shared.goesOn(); ++r) {
                    for (std::size_t p = runs[r]; p < runs[r + 1]; ++p) {
                        makePiece(baker, pieces[p]);
                    }
                    shared.step();
                }
            } catch (const std::bad_alloc&) { // must not leave its thread
                outOfMemory = true;
            }
        });
        if (outOfMemory) {
            return contentsError("the texels do not fit into memory");
        }
        return shared.goesOn() ? Status() : cancelled();
    }

    bool reachesAny() const
    {
        return std::any_of(
            m_made.begin(), m_made.end(), [](const MadeFace& face) { return face.reached > 0; });
    }

    TexelPatch exchange(TexelStore& store)
    {
        TexelPatch patch;
        for (std::size_t k = 0; k < m_faces.size(); ++k) {
            if (m_made[k].reached == 0) {
                continue;
            }
            const Level level = store.face(m_faces[k]).level();
            const FaceTexels after =
                FaceTexels::full(level, store.format().texelBytes(), m_made[k].texels);
            m_made[k].texels = {};
            patch.addFace(m_faces[k], store.exchange(m_faces[k], after.collapsed()));
        }
        return patch;
    }

private:
    void makePiece(PieceBaker& baker, const Piece& piece)
    {
        const FaceId face = m_faces[piece.number];
        const FaceTexels& before = m_store.face(face);
        const std::uint32_t width = before.level().resolution();
        const std::size_t rowBytes = width * m_store.format().texelBytes();
        MadeFace& made = m_made[piece.number];
        std::call_once(made.allocated, [&] { made.texels.resize(width * rowBytes); });
        made.reached += baker.bake(
            face,
            before,
            piece.firstRow * width,
            std::span(made.texels).subspan(piece.firstRow * rowBytes, piece.rows * rowBytes));
        if (piece.rows == width && made.reached == 0) {
            made.texels = {}; // a whole face that the image does not reach
        }
    }

    const TexelStore& m_store;
    std::span<const FaceId> m_faces;
    std::vector<MadeFace> m_made;
};

} // namespace

Result<TexelPatch> bake(TexelStore& store,
                        std::span<const FaceId> faces,
                        const Mapping& mapping,
                        const ImageTiles& images,
                        const BakeOptions& options,
                        Progress& progress)
{
    if (const Status read = readAll(store, faces); !read) {
        return tl::unexpected(read.error());
    }
    FaceBaker baker(store, faces);
    if (const Status made = baker.make(mapping, images, options, progress); !made) {
        return tl::unexpected(made.error());
    }
    if (!baker.reachesAny()) {
        return contentsError("the image reaches no texel");
    }
    return baker.exchange(store);
}

} // namespace trixel
