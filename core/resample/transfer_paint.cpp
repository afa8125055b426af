// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/resample/transfer_paint.h"

#include "core/mesh/face_pieces.h"

#include <algorithm>
#include <atomic>
#include <glm/geometric.hpp>
#include <mutex>
#include <utility>

namespace trixel {

namespace {

/// Of the faces that are held twice, as they were and as they become.
constexpr std::uint64_t kTexelsAtOnce = std::uint64_t{1} << 22U;

/// A vector of space as (u,v) of a face: what of it lies in the face's plane. Zero for a face
/// without area.
glm::dvec2 onFace(const std::array<glm::vec3, 3>& corners, glm::dvec3 vector)
{
    const glm::dvec3 e1(corners[1] - corners[0]);
    const glm::dvec3 e2(corners[2] - corners[0]);
    const double a = glm::dot(e1, e1);
    const double b = glm::dot(e1, e2);
    const double c = glm::dot(e2, e2);
    const double area = a * c - b * b;
    if (!(area > 1e-12 * a * c)) {
        return glm::dvec2(0);
    }
    const double p = glm::dot(e1, vector);
    const double q = glm::dot(e2, vector);
    return glm::dvec2(c * p - b * q, a * q - b * p) / area;
}

/// A face that takes paint, by several threads that each fill texels of their own.
struct TakingFace
{
    std::once_flag begun;
    FaceTexels texels; ///< as they were, then as they become
    std::span<std::byte> bytes;
    std::atomic<std::uint32_t> reached{0}; ///< texels that found the other surface
};

/// Works on pieces of faces, from several threads.
class Transferrer
{
public:
    Transferrer(const Surface& from,
                const FilterScene& paint,
                const Surface& to,
                const TexelStore& texels,
                const TransferOptions& options)
        : m_from(from)
        , m_paint(paint)
        , m_to(to)
        , m_texels(texels)
        , m_maxDistance(options.maxDistance)
        , m_method(makeMethod(options.method))
    {
    }

    /// \param piece  texels of the face `face`, which becomes `after`
    void bring(FaceId face, const FacePiece& piece, TakingFace& after) const
    {
        QueryArrays queries;
        std::vector<std::uint32_t> indices;
        ask(face, piece, queries, indices);
        if (indices.empty()) {
            return;
        }
        std::call_once(after.begun, [&] {
            after.texels = m_texels.face(face).pinned();
            after.bytes = after.texels.writable();
        });
        ResultArrays answers(queries.size(), m_paint.channels());
        m_method->filter(m_paint, queries.queries(), answers.results());
        put(answers, indices, after.bytes);
        after.reached += static_cast<std::uint32_t>(indices.size());
    }

private:
    void ask(FaceId face,
             const FacePiece& piece,
             QueryArrays& queries,
             std::vector<std::uint32_t>& indices) const
    {
        const Level level = m_texels.face(face).level();
        const auto corners = m_to.mesh().corners(face);
        const double step = 1.0 / level.resolution();
        const glm::dvec3 along1 = step * glm::dvec3(corners[1] - corners[0]);
        const glm::dvec3 along2 = step * glm::dvec3(corners[2] - corners[0]);
        const auto first = static_cast<std::uint32_t>(piece.first);
        for (std::uint32_t k = first; k < first + piece.count; ++k) {
            const glm::vec2 uv(centroid(level, texelAt(level, TexelIndex(k))));
            const auto found =
                m_from.bvh().closestPoint(pointAt(corners, uv.x, uv.y), m_maxDistance);
            if (found) {
                const auto there = m_from.mesh().corners(found->face);
                queries.add(found->face,
                            found->uv,
                            glm::vec2(onFace(there, along1)),
                            glm::vec2(onFace(there, along2)));
                indices.push_back(k);
            }
        }
    }

    void put(const ResultArrays& answers,
             std::span<const std::uint32_t> indices,
             std::span<std::byte> texels) const
    {
        const TexelFormat& format = m_texels.format();
        const std::size_t bytes = format.texelBytes();
        const auto channels =
            std::min<std::size_t>(format.channels, static_cast<std::size_t>(m_paint.channels()));
        std::vector<float> value(format.channels);
        for (std::size_t k = 0; k < indices.size(); ++k) {
            const auto texel = texels.subspan(indices[k] * bytes, bytes);
            decode(format.type, texel, value);
            for (std::size_t c = 0; c < channels; ++c) {
                value[c] = answers.values[c * indices.size() + k];
            }
            encode(format.type, value, texel);
        }
    }

    const Surface& m_from;
    const FilterScene& m_paint;
    const Surface& m_to;
    const TexelStore& m_texels;
    float m_maxDistance;
    std::unique_ptr<const FilterMethod> m_method;
};

/// As many faces from `first` on as have so many texels, but at least one.
std::size_t facesAtOnce(const TexelStore& texels, std::size_t first)
{
    std::uint64_t sum = texels.face(faceId(first)).level().texelCount();
    std::size_t end = first + 1;
    for (; end < texels.faceCount(); ++end) {
        sum += texels.face(faceId(end)).level().texelCount();
        if (sum > kTexelsAtOnce) {
            break;
        }
    }
    return end - first;
}

/// Some faces, from `first` on; they go into the transfer.
Status bringSome(const Transferrer& transferrer,
                 std::size_t first,
                 std::size_t count,
                 Threads threads,
                 Transfer& transfer,
                 Progress& progress)
{
    std::vector<TakingFace> some(count);
    const auto texelCount = [&](FaceId k) -> std::uint64_t {
        return transfer.texels.face(faceId(first + indexOf(k))).level().texelCount();
    };
    StageProgress bringing(progress, 0, 0.98);
    const Status brought =
        forFacePieces(count, texelCount, threads, bringing, [&](const FacePiece& piece) {
            const std::size_t k = indexOf(piece.face);
            transferrer.bring(faceId(first + k), piece, some[k]);
        });
    if (!brought) {
        return brought;
    }
    StageProgress finishing(progress, 0.98, 1);
    const Status finished = forWholeFaces(count, texelCount, threads, finishing, [&](FaceId k) {
        TakingFace& face = some[indexOf(k)];
        if (face.reached > 0) {
            face.texels = face.texels.collapsed();
        }
    });
    if (!finished) {
        return finished;
    }
    for (std::size_t k = 0; k < count; ++k) {
        if (some[k].reached > 0) {
            transfer.reached += some[k].reached;
            transfer.texels.exchange(faceId(first + k), std::move(some[k].texels));
        }
    }
    return {};
}

} // namespace

Result<Transfer> transferPaint(const Surface& from,
                               const FilterScene& paint,
                               const Surface& to,
                               const TexelStore& texels,
                               const TransferOptions& options,
                               Progress& progress)
{
    check(paint.faceCount() == from.mesh().faceCount(), "paint on the surface it comes from");
    check(texels.faceCount() == to.mesh().faceCount(), "texels of the surface it goes to");
    const Transferrer transferrer(from, paint, to, texels, options);
    Transfer transfer{texels, 0, texels.texelCount()};
    std::uint64_t done = 0;
    for (std::size_t first = 0; first < texels.faceCount();) {
        const std::size_t count = facesAtOnce(texels, first);
        const std::uint64_t before = done;
        for (std::size_t k = 0; k < count; ++k) {
            done += texels.face(faceId(first + k)).level().texelCount();
        }
        const auto part = [&](std::uint64_t sum) {
            return static_cast<double>(sum) / static_cast<double>(transfer.total);
        };
        StageProgress stage(progress, part(before), part(done));
        const Status some = bringSome(transferrer, first, count, options.threads, transfer, stage);
        if (!some) {
            return tl::unexpected(some.error());
        }
        first += count;
    }
    if (const Status whole = texels.checkWhole(); !whole) {
        return tl::unexpected(whole.error());
    }
    return progress.report(1) ? Result<Transfer>(std::move(transfer)) : cancelled();
}

} // namespace trixel
