// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mapping/bake.h"

#include "core/base/check.h"
#include "core/lattice/texel.h"
#include "core/mapping/bake_channels.h"
#include "core/mesh/shared_progress.h"
#include "core/texture/pinned_face.h"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <new>
#include <optional>
#include <string>
#include <utility>

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

    /// Makes the texels of some rows. Returns nothing where the image lies on none of them, which
    /// then are not read either.
    std::vector<std::byte> bake(FaceId face, const FaceTexels& before, const Piece& piece)
    {
        const Level level = before.level();
        const double step = 1.0 / level.resolution();
        const std::size_t bytes = m_format.texelBytes();
        const std::size_t first = std::size_t{piece.firstRow} * level.resolution();
        const std::size_t count = std::size_t{piece.rows} * level.resolution();
        std::vector<std::byte> texels;
        for (std::size_t k = 0; k < count; ++k) {
            const auto texel = TexelIndex{static_cast<std::uint32_t>(first + k)};
            const ImagePlace place =
                m_mapping.at(face, centroid(level, texelAt(level, texel)), step);
            if (!place.lands || !look(place)) {
                continue;
            }
            if (texels.empty()) {
                texels = texelsOf(face, before, first, count);
            }
            lay(std::span(texels).subspan(k * bytes, bytes));
        }
        return texels;
    }

    /// The first of the faces met that could not be read from its file.
    std::optional<FaceId> unreadable() const { return m_unreadable; }

private:
    /// Takes the image's colours at a place; false where it lets everything through.
    bool look(const ImagePlace& place)
    {
        for (std::size_t group = 0; group < m_images.groups(); ++group) {
            const glm::vec4 value = m_images.at(place.st, place.footprint, group);
            for (int c = 0; c < 3; ++c) {
                m_colors[3 * group + static_cast<std::size_t>(c)] = value[c] * m_opacity;
            }
            m_seen = value.a * m_opacity;
        }
        return m_seen > 0;
    }

    /// Lays the colours that were looked at over a texel.
    void lay(std::span<std::byte> texel)
    {
        decode(m_format.type, texel, m_values);
        m_channels.lay(m_colors, m_seen, m_values);
        encode(m_format.type, m_values, texel);
    }

    std::vector<std::byte>
    texelsOf(FaceId face, const FaceTexels& before, std::size_t first, std::size_t count)
    {
        const PinnedFace pinned(before);
        if (pinned->isDamaged() && !m_unreadable) {
            m_unreadable = face;
        }
        std::vector<std::byte> texels;
        texels.reserve(count * m_format.texelBytes());
        for (std::size_t k = 0; k < count; ++k) {
            const auto texel = pinned->texel(first + k);
            texels.insert(texels.end(), texel.begin(), texel.end());
        }
        return texels;
    }

    const Mapping& m_mapping;
    const ImageTiles& m_images;
    const BakeChannels& m_channels;
    TexelFormat m_format;
    float m_opacity;
    std::vector<float> m_values;
    std::vector<float> m_colors; ///< at the place looked at, times `m_seen`
    float m_seen = 0;            ///< opacity there
    std::optional<FaceId> m_unreadable;
};

/// Makes every face, as far as the image reaches it.
class FaceBaker
{
public:
    FaceBaker(const TexelStore& store, std::span<const FaceId> faces)
        : m_store(store)
        , m_faces(faces)
        , m_pieces(piecesOf(store, faces))
        , m_made(m_pieces.size())
    {
    }

    Status make(const Mapping& mapping,
                const ImageTiles& images,
                const BakeOptions& options,
                Progress& progress)
    {
        const BakeChannels channels(m_store.format(), options.colors, images.colors());
        const std::vector<std::size_t> runs = runsOf(m_pieces, m_store, m_faces);
        SharedProgress shared(progress, runs.size());
        std::atomic<bool> outOfMemory{false};
        parallelFor(runs.size() - 1, 1, options.threads, [&](std::size_t begin, std::size_t end) {
            try {
                PieceBaker baker(mapping, images, channels, m_store.format(), options.opacity);
                for (std::size_t r = begin; r < end && shared.goesOn(); ++r) {
                    for (std::size_t p = runs[r]; p < runs[r + 1]; ++p) {
                        const FaceId face = m_faces[m_pieces[p].number];
                        m_made[p] = baker.bake(face, m_store.face(face), m_pieces[p]);
                    }
                    shared.step();
                }
                note(baker.unreadable());
            } catch (const std::bad_alloc&) { // must not leave its thread
                outOfMemory = true;
            }
        });
        if (outOfMemory) {
            return contentsError("the texels do not fit into memory");
        }
        if (!shared.goesOn()) {
            return cancelled();
        }
        return m_unreadable ? Status(contentsError(
                                  "face " + std::to_string(indexOf(*m_unreadable)) +
                                  " could not be read from its file; fill it before an image is "
                                  "laid onto it"))
                            : Status();
    }

    /// The faces that the image reaches, whole.
    Result<std::vector<std::pair<FaceId, FaceTexels>>> assembled()
    {
        std::vector<std::pair<FaceId, FaceTexels>> faces;
        try {
            std::size_t p = 0;
            while (p < m_pieces.size()) {
                std::size_t end = p;
                while (end < m_pieces.size() && m_pieces[end].number == m_pieces[p].number) {
                    ++end;
                }
                if (std::any_of(m_made.begin() + static_cast<std::ptrdiff_t>(p),
                                m_made.begin() + static_cast<std::ptrdiff_t>(end),
                                [](const auto& texels) { return !texels.empty(); })) {
                    faces.emplace_back(m_faces[m_pieces[p].number], assembled(p, end));
                }
                p = end;
            }
        } catch (const std::bad_alloc&) {
            return contentsError("the texels do not fit into memory");
        }
        return faces;
    }

private:
    void note(std::optional<FaceId> unreadable)
    {
        const std::lock_guard lock(m_mutex);
        if (unreadable && (!m_unreadable || indexOf(*unreadable) < indexOf(*m_unreadable))) {
            m_unreadable = unreadable;
        }
    }

    /// \param first, end  the pieces of one face
    FaceTexels assembled(std::size_t first, std::size_t end)
    {
        FaceTexels face = m_store.face(m_faces[m_pieces[first].number]).pinned();
        const std::size_t rowBytes = face.level().resolution() * face.texelBytes();
        const std::span<std::byte> texels = face.writable();
        for (std::size_t p = first; p < end; ++p) {
            std::copy(m_made[p].begin(),
                      m_made[p].end(),
                      texels.begin() +
                          static_cast<std::ptrdiff_t>(m_pieces[p].firstRow * rowBytes));
            m_made[p] = {};
        }
        return face.collapsed();
    }

    const TexelStore& m_store;
    std::span<const FaceId> m_faces;
    std::vector<Piece> m_pieces; ///< those of a face one after the other
    /// Texels of each piece, by threads that each fill pieces of their own; empty where the image
    /// does not reach, so that memory is taken for what it reaches only.
    std::vector<std::vector<std::byte>> m_made;
    std::mutex m_mutex;
    std::optional<FaceId> m_unreadable;
};

} // namespace

Result<TexelPatch> bake(TexelStore& store,
                        std::span<const FaceId> faces,
                        const Mapping& mapping,
                        const ImageTiles& images,
                        const BakeOptions& options,
                        Progress& progress)
{
    FaceBaker baker(store, faces);
    if (const Status made = baker.make(mapping, images, options, progress); !made) {
        return tl::unexpected(made.error());
    }
    auto after = baker.assembled();
    if (!after) {
        return tl::unexpected(after.error());
    }
    if (after->empty()) {
        return contentsError("the image reaches no texel");
    }
    TexelPatch patch;
    for (auto& [face, texels] : *after) {
        patch.addFace(face, store.exchange(face, std::move(texels)));
    }
    return patch;
}

} // namespace trixel
