// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/resample/transfer_paint.h"

#include "core/mesh/face_pieces.h"
#include "core/resample/uv_image.h"
#include "core/texture/opacity.h"

#include <algorithm>
#include <atomic>
#include <glm/geometric.hpp>
#include <limits>
#include <mutex>
#include <optional>
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
    FaceTexels before;
    FaceTexels after;
    std::span<std::byte> bytes;            ///< of what they become
    std::atomic<std::uint32_t> reached{0}; ///< texels that found the other surface
};

/// Works on pieces of faces, from several threads.
class Transferrer
{
public:
    Transferrer(const Surface& from,
                const TransferScene& paint,
                const Surface& to,
                const TexelStore& texels,
                const TransferOptions& options)
        : m_from(from)
        , m_paint(paint.paint)
        , m_opacity(paint.opacity)
        , m_to(to)
        , m_texels(texels)
        , m_options(options)
        , m_method(makeMethod(options.method))
    {
    }

    /// \param piece  texels of the face `face`
    void bring(FaceId face, const FacePiece& piece, TakingFace& taking) const
    {
        QueryArrays queries;
        std::vector<std::uint32_t> indices;
        ask(face, piece, queries, indices);
        if (indices.empty()) {
            return;
        }
        std::call_once(taking.begun, [&] {
            taking.before = m_texels.face(face).pinned();
            taking.after = fills() ? filled(face) : taking.before;
            taking.bytes = taking.after.writable();
        });
        ResultArrays answers(queries.size(), m_paint.channels());
        m_method->filter(m_paint, queries.queries(), answers.results());
        put(answers, indices, taking);
        taking.reached += static_cast<std::uint32_t>(indices.size());
    }

    /// What a face becomes of which all pieces are done; nothing if it stays as it is.
    std::optional<FaceTexels> made(FaceId face, const TakingFace& taking) const
    {
        return taking.reached > 0 ? std::optional(taking.after.collapsed())
               : fills()          ? std::optional(filled(face))
                                  : std::nullopt;
    }

private:
    bool fills() const { return m_options.outOfReach == OutOfReach::Fill; }
    FaceTexels filled(FaceId face) const
    {
        return FaceTexels::constant(m_texels.face(face).level(), m_options.fill);
    }

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
                m_from.bvh().closestPoint(pointAt(corners, uv.x, uv.y), m_options.maxDistance);
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
             const TakingFace& taking) const
    {
        const TexelFormat& format = m_texels.format();
        const std::size_t bytes = format.texelBytes();
        std::vector<float> paint(static_cast<std::size_t>(m_paint.channels()));
        const std::size_t channels = std::min<std::size_t>(format.channels, paint.size());
        std::vector<float> value(format.channels);
        for (std::size_t k = 0; k < indices.size(); ++k) {
            for (std::size_t c = 0; c < paint.size(); ++c) {
                paint[c] = answers.values[c * indices.size() + k];
            }
            if (m_opacity) {
                unweigh(paint, *m_opacity);
            }
            decode(format.type, taking.before.texel(indices[k]), value);
            for (std::size_t c = 0; c < channels; ++c) {
                value[c] =
                    m_options.colors.empty() ? paint[c] : fromLinear(m_options.colors[c], paint[c]);
            }
            encode(format.type, value, taking.bytes.subspan(indices[k] * bytes, bytes));
        }
    }

    const Surface& m_from;
    const FilterScene& m_paint;
    std::optional<std::uint16_t> m_opacity;
    const Surface& m_to;
    const TexelStore& m_texels;
    const TransferOptions& m_options;
    std::unique_ptr<const FilterMethod> m_method;
};

float distanceTo(const Surface& surface, glm::vec3 point)
{
    constexpr float kAny = std::numeric_limits<float>::infinity();
    const auto found = surface.bvh().closestPoint(point, kAny);
    return found
               ? glm::distance(
                     point, pointAt(surface.mesh().corners(found->face), found->uv.x, found->uv.y))
               : kAny;
}

std::vector<FaceId> facesOf(const TransferOptions& options, std::uint32_t faceCount)
{
    std::vector<FaceId> faces = options.faces;
    if (faces.empty()) {
        faces.resize(faceCount);
        for (std::size_t k = 0; k < faces.size(); ++k) {
            faces[k] = faceId(k);
        }
    }
    return faces;
}

/// As many of the faces as have so many texels, but at least one.
std::size_t howManyAtOnce(const TexelStore& texels, std::span<const FaceId> faces)
{
    std::uint64_t sum = 0;
    std::size_t count = 0;
    while (count < faces.size()) {
        sum += texels.face(faces[count]).level().texelCount();
        if (count > 0 && sum > kTexelsAtOnce) {
            break;
        }
        ++count;
    }
    return count;
}

std::uint64_t texelCountOf(const TexelStore& texels, std::span<const FaceId> faces)
{
    std::uint64_t sum = 0;
    for (const FaceId face : faces) {
        sum += texels.face(face).level().texelCount();
    }
    return sum;
}

/// What some faces become goes into the transfer.
Status bringSome(const Transferrer& transferrer,
                 std::span<const FaceId> faces,
                 Threads threads,
                 Transfer& transfer,
                 Progress& progress)
{
    std::vector<TakingFace> taking(faces.size());
    std::vector<std::optional<FaceTexels>> made(faces.size());
    const auto texels = [&](FaceId k) -> std::uint64_t {
        return transfer.texels.face(faces[indexOf(k)]).level().texelCount();
    };
    StageProgress bringing(progress, 0, 0.98);
    Status done =
        forFacePieces(faces.size(), texels, threads, bringing, [&](const FacePiece& piece) {
            const std::size_t k = indexOf(piece.face);
            transferrer.bring(faces[k], piece, taking[k]);
        });
    if (done) {
        StageProgress finishing(progress, 0.98, 1);
        done = forWholeFaces(faces.size(), texels, threads, finishing, [&](FaceId k) {
            made[indexOf(k)] = transferrer.made(faces[indexOf(k)], taking[indexOf(k)]);
        });
    }
    for (std::size_t k = 0; k < faces.size() && done; ++k) {
        transfer.reached += taking[k].reached;
        if (made[k]) {
            transfer.texels.exchange(faces[k], std::move(*made[k]));
        }
    }
    return done;
}

} // namespace

TransferColors transferColors(const std::optional<std::vector<ColorSpace>>& paint,
                              const TexelFormat& paintFormat,
                              const std::optional<std::vector<ColorSpace>>& texels,
                              const TexelFormat& texelFormat)
{
    if (!paint && !texels) {
        return {};
    }
    TransferColors colors{paint ? *paint : *texels, texels ? *texels : *paint};
    // Channels that the other side lacks are not brought over.
    colors.paint.resize(paintFormat.channels, ColorSpace::Raw);
    colors.texels.resize(texelFormat.channels, ColorSpace::Raw);
    return colors;
}

Result<TransferScene> transferScene(const Surface& from,
                                    const TexelStore& texels,
                                    const std::vector<ColorSpace>& colors,
                                    Threads threads,
                                    Progress& progress)
{
    StageProgress converting(progress, 0, 0.25);
    auto linear = linearStore(texels, colors, threads, converting);
    if (linear) {
        StageProgress weighing(progress, 0.25, 0.3);
        linear = weighed(*linear, threads, weighing);
    }
    if (!linear) {
        return tl::unexpected(linear.error());
    }
    StageProgress building(progress, 0.3, 1);
    return FilterScene::build(std::make_shared<const FilterSurface>(
                                  FilterSurface::fromMesh(from.mesh(), from.adjacency())),
                              *linear,
                              threads,
                              building)
        .map([&](FilterScene&& paint) {
            return TransferScene{std::move(paint), texels.format().alpha};
        });
}

std::vector<float> sampleDistances(const Surface& from,
                                   const Surface& to,
                                   const TexelStore& texels,
                                   std::size_t count,
                                   std::span<const FaceId> faces)
{
    check(texels.faceCount() == to.mesh().faceCount(), "texels of the surface it goes to");
    TransferOptions some;
    some.faces.assign(faces.begin(), faces.end());
    const std::vector<FaceId> all = facesOf(some, texels.faceCount());
    std::uint64_t total = 0;
    for (const FaceId face : all) {
        total += texels.face(face).level().texelCount();
    }
    std::vector<float> distances;
    if (from.mesh().faceCount() == 0 || total == 0 || count == 0) {
        return distances;
    }
    // Every so many texels, as they are numbered through all faces.
    const std::uint64_t step = std::max<std::uint64_t>(1, total / count);
    std::uint64_t next = step / 2;
    std::uint64_t begin = 0;
    for (const FaceId face : all) {
        const Level level = texels.face(face).level();
        const auto corners = to.mesh().corners(face);
        for (; next < begin + level.texelCount() && distances.size() < count; next += step) {
            const auto texel = static_cast<TexelIndex>(next - begin);
            const glm::vec2 uv(centroid(level, texelAt(level, texel)));
            distances.push_back(distanceTo(from, pointAt(corners, uv.x, uv.y)));
        }
        begin += level.texelCount();
    }
    return distances;
}

Result<Transfer> transferPaint(const Surface& from,
                               const TransferScene& paint,
                               const Surface& to,
                               const TexelStore& texels,
                               const TransferOptions& options,
                               Progress& progress)
{
    check(paint.paint.faceCount() == from.mesh().faceCount(), "paint on the surface it comes from");
    check(texels.faceCount() == to.mesh().faceCount(), "texels of the surface it goes to");
    check(options.outOfReach == OutOfReach::Keep ||
              options.fill.size() == texels.format().texelBytes(),
          "the bytes of one texel");
    check(options.colors.empty() || options.colors.size() == texels.format().channels,
          "a colour space for each channel");
    check(!paint.opacity || *paint.opacity < paint.paint.channels(), "a channel of the paint");
    const Transferrer transferrer(from, paint, to, texels, options);
    const std::vector<FaceId> faces = facesOf(options, texels.faceCount());
    Transfer transfer{texels, 0, texelCountOf(texels, faces)};
    const auto part = [&](std::uint64_t done) {
        return static_cast<double>(done) / static_cast<double>(transfer.total);
    };
    std::uint64_t done = 0;
    for (std::span<const FaceId> left(faces); !left.empty();) {
        const auto some = left.first(howManyAtOnce(texels, left));
        left = left.subspan(some.size());
        const std::uint64_t before = std::exchange(done, done + texelCountOf(texels, some));
        StageProgress stage(progress, part(before), part(done));
        const Status brought = bringSome(transferrer, some, options.threads, transfer, stage);
        if (!brought) {
            return tl::unexpected(brought.error());
        }
    }
    if (const Status whole = texels.checkWhole(); !whole) {
        return tl::unexpected(whole.error());
    }
    return progress.report(1) ? Result<Transfer>(std::move(transfer)) : cancelled();
}

} // namespace trixel
