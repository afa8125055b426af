// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/fit/fitted_texels.h"

#include "core/study/fit/fit_texel_group.h"
#include "core/texture/convert.h"
#include "core/texture/mips.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace trixel {
namespace {

/// Pixels this much wider than a coarse texel do not notice its floor.
constexpr double kWidePixel = 4;

/// Faces that were left alone take their bytes back; so do constant ones, at their level.
TexelStore inFormat(const FitSource& source, const TexelStore& coarse, const FaceMap<char>& isMoved)
{
    const TexelFormat& format = source.texels.format();
    TexelStore result = source.texels;
    std::vector<std::byte> bytes;
    for (std::uint32_t f = 0; f < coarse.faceCount(); ++f) {
        const FaceTexels& face = coarse.face(faceId(f));
        const FaceTexels& original = source.texels.face(faceId(f));
        if (face.level() == original.level() && isMoved[faceId(f)] == 0) {
            continue;
        }
        if (original.isConstant()) {
            result.exchange(faceId(f), original.atLevel(face.level()));
            continue;
        }
        std::vector<float> values(face.bytes().size() / sizeof(float));
        std::memcpy(values.data(), face.bytes().data(), face.bytes().size());
        bytes.resize(values.size() * byteSize(format.type));
        encode(format.type, values, bytes);
        result.exchange(faceId(f),
                        face.isConstant()
                            ? FaceTexels::constant(face.level(), bytes)
                            : FaceTexels::full(face.level(), format.texelBytes(), bytes));
    }
    return result;
}

} // namespace

Coarsener::Coarsener(const FitSource& source)
    : m_source(source)
    , m_wanted(source)
    , m_found(Level::kMax + 1)
{
}

TexelStore Coarsener::begin(const FaceMap<Level>& levels) const
{
    TexelStore coarse = m_source.floats;
    for (std::uint32_t f = 0; f < coarse.faceCount(); ++f) {
        const FaceId face = faceId(f);
        const FaceTexels& original = m_source.floats.face(face);
        const int steps = original.level().log2() - levels[face].log2();
        check(steps >= 0, "levels that only become coarser");
        if (steps > 0) {
            coarse.exchange(face, reduced(coarse.format(), original, steps));
        }
    }
    return coarse;
}

/// Faces whose texels or floor changed and that are seen closely enough for it to matter.
FaceMap<char> Coarsener::movable(const TexelStore& coarse) const
{
    const FilterSurface& shapes = *m_source.shapes;
    FaceMap<char> near(coarse.faceCount(), 0);
    for (std::size_t r = 0; r < shapes.rings().ringCount(); ++r) {
        const auto corners = shapes.rings().corners(static_cast<RingId>(r));
        const bool changed = std::ranges::any_of(corners, [&](const Corner& corner) {
            return coarse.face(corner.face).level() != m_source.texels.face(corner.face).level();
        });
        for (const Corner& corner : corners) {
            near[corner.face] = near[corner.face] != 0 || changed ? 1 : 0;
        }
    }
    for (std::uint32_t f = 0; f < coarse.faceCount(); ++f) {
        const FaceId face = faceId(f);
        const double edge = std::exp2(shapes.log2Length(face, glm::dvec2(1.0 / 3.0)) -
                                      coarse.face(face).level().log2());
        if (m_source.texels.face(face).isConstant() || !(m_source.weight(face) > 0) ||
            m_source.spacing(face) >= kWidePixel * edge) {
            near[face] = 0;
        }
    }
    return near;
}

Status Coarsener::move(TexelStore& coarse,
                       const FitPoints& points,
                       int steps,
                       FittedTexels& fitted,
                       Threads threads,
                       Progress& progress)
{
    StageProgress looking(progress, 0, 0.3);
    if (const Status status = m_wanted.look(points, threads, looking); !status) {
        return status;
    }
    StageProgress weighing(progress, 0.3, 0.6);
    NoProgress unseen;
    const auto scene = FilterScene::build(m_source.shapes, coarse, threads, unseen);
    const auto equations =
        FitEquations::make(*scene, points.queries, points.ranges, threads, weighing);
    if (!equations) {
        return tl::unexpected(equations.error());
    }
    const int groups = scene->mips().groups();
    FaceMap<double> counted(coarse.faceCount(), 0);
    for (int group = 0; group < groups; ++group) {
        StageProgress solving(
            progress, 0.6 + 0.4 * group / groups, 0.6 + 0.4 * (group + 1) / groups);
        FitTexelGroup texels(*equations, coarse, group);
        std::vector<Quad> values = texels.read();
        const auto missing = equations->solve(m_wanted.group(points, group),
                                              fitted.isMoved,
                                              {m_source.least, m_source.most},
                                              steps,
                                              values,
                                              threads,
                                              solving);
        if (!missing) {
            return tl::unexpected(missing.error());
        }
        texels.write(values, fitted.isMoved);
        std::size_t at = 0;
        for (const PointRange& range : points.ranges) {
            for (std::uint32_t p = 0; p < range.count; ++p, ++at) {
                for (std::size_t c = 0; c < texels.channels(); ++c) {
                    const double square = (*missing)[at][static_cast<int>(c)];
                    if (std::isfinite(square)) {
                        fitted.squares[range.face] += square * square;
                        counted[range.face] += 1;
                    }
                }
            }
        }
    }
    for (const PointRange& range : points.ranges) {
        fitted.squares[range.face] /= std::max(counted[range.face], 1.0);
    }
    return {};
}

Result<FittedTexels>
Coarsener::fitted(const FaceMap<Level>& levels, int steps, Threads threads, Progress& progress)
{
    TexelStore coarse = begin(levels);
    FittedTexels fitted;
    fitted.isMoved = movable(coarse);
    fitted.squares = FaceMap<double>(coarse.faceCount(), 0);
    for (std::uint32_t f = 0; f < coarse.faceCount(); ++f) {
        const auto& found = m_found[static_cast<std::size_t>(levels[faceId(f)].log2())];
        if (fitted.isMoved[faceId(f)] != 0 && found.size() > 0 && found[faceId(f)]) {
            coarse.exchange(faceId(f), *found[faceId(f)]);
        }
    }
    const FitPoints points = fitPoints(m_source, levels, fitted.isMoved);
    if (points.queries.size() > 0) {
        if (const Status status = move(coarse, points, steps, fitted, threads, progress); !status) {
            return tl::unexpected(status.error());
        }
    }
    for (std::uint32_t f = 0; f < coarse.faceCount(); ++f) {
        const FaceTexels& face = coarse.face(faceId(f));
        if (fitted.isMoved[faceId(f)] != 0) {
            auto& found = m_found[static_cast<std::size_t>(face.level().log2())];
            if (found.size() == 0) {
                found = FaceMap<std::optional<FaceTexels>>(coarse.faceCount());
            }
            found[faceId(f)] = face;
        }
    }
    fitted.texels = inFormat(m_source, coarse, fitted.isMoved);
    return fitted;
}

} // namespace trixel
