// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/resample/transfer_paint.h"

#include <algorithm>
#include <atomic>
#include <glm/geometric.hpp>
#include <utility>

namespace trixel {

namespace {

constexpr std::size_t kFacesAtOnce = 1024;
constexpr std::size_t kGrain = 8;

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

/// Works face by face, from several threads.
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

    /// The texels of a face, and how many of them found the other surface.
    std::pair<FaceTexels, std::uint64_t> face(FaceId face) const
    {
        const FaceTexels before = m_texels.face(face).pinned();
        QueryArrays queries;
        std::vector<std::uint32_t> indices;
        ask(face, before.level(), queries, indices);
        if (indices.empty()) {
            return {m_texels.face(face), 0};
        }
        ResultArrays answers(queries.size(), m_paint.channels());
        m_method->filter(m_paint, queries.queries(), answers.results());
        FaceTexels after = before;
        put(answers, indices, after.writable());
        return {after.collapsed(), indices.size()};
    }

private:
    void
    ask(FaceId face, Level level, QueryArrays& queries, std::vector<std::uint32_t>& indices) const
    {
        const auto corners = m_to.mesh().corners(face);
        const double step = 1.0 / level.resolution();
        const glm::dvec3 along1 = step * glm::dvec3(corners[1] - corners[0]);
        const glm::dvec3 along2 = step * glm::dvec3(corners[2] - corners[0]);
        for (std::uint32_t k = 0; k < level.texelCount(); ++k) {
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
    std::vector<std::pair<FaceTexels, std::uint64_t>> some;
    for (std::size_t first = 0; first < texels.faceCount(); first += kFacesAtOnce) {
        if (!progress.report(static_cast<double>(first) / texels.faceCount())) {
            return cancelled();
        }
        some.assign(std::min<std::size_t>(kFacesAtOnce, texels.faceCount() - first), {});
        parallelFor(some.size(), kGrain, options.threads, [&](std::size_t begin, std::size_t end) {
            for (std::size_t k = begin; k < end; ++k) {
                some[k] = transferrer.face(faceId(first + k));
            }
        });
        for (std::size_t k = 0; k < some.size(); ++k) {
            transfer.reached += some[k].second;
            if (some[k].second > 0) {
                transfer.texels.exchange(faceId(first + k), std::move(some[k].first));
            }
        }
    }
    if (const Status whole = texels.checkWhole(); !whole) {
        return tl::unexpected(whole.error());
    }
    return progress.report(1) ? Result<Transfer>(std::move(transfer)) : cancelled();
}

} // namespace trixel
