// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/views/view_queries.h"

#include "core/study/views/seen_faces.h"

#include <algorithm>
#include <functional>
#include <optional>

namespace trixel {
namespace {

/// Pixels by which a point that one view shows may lie outside another's picture of the same place.
constexpr double kFrameRounding = 1e-3;

/// Well-mixed bits of a number (the finaliser of SplitMix64).
std::uint64_t mixed(std::uint64_t x)
{
    x += 0x9E3779B97F4A7C15ULL;
    x = (x ^ (x >> 30U)) * 0xBF58476D1CE4E5B9ULL;
    x = (x ^ (x >> 27U)) * 0x94D049BB133111EBULL;
    return x ^ (x >> 31U);
}

/// The pixels of one row of blocks.
class BlockRow
{
public:
    BlockRow(const ViewCamera& camera, PixelSubset subset, std::size_t row)
        : m_camera(camera)
        , m_subset(subset)
        , m_row(static_cast<int>(row))
    {
    }

    void forEach(const std::function<void(int x, int y)>& visit) const
    {
        const int step = m_subset.step;
        const int top = m_row * step;
        for (int left = 0; left < m_camera.width; left += step) {
            // Blocks that the picture cuts off choose within what is left of them.
            const auto wide = static_cast<std::uint64_t>(std::min(step, m_camera.width - left));
            const auto high = static_cast<std::uint64_t>(std::min(step, m_camera.height - top));
            const std::uint64_t place = mixed((std::uint64_t{m_subset.seed} << 40U) ^
                                              (static_cast<std::uint64_t>(m_row) << 20U) ^
                                              static_cast<std::uint64_t>(left / step));
            visit(left + static_cast<int>(place % wide),
                  top + static_cast<int>((place >> 32U) % high));
        }
    }

private:
    const ViewCamera& m_camera;
    PixelSubset m_subset;
    int m_row;
};

std::size_t blockRows(const ViewCamera& camera, PixelSubset subset)
{
    check(subset.step >= 1, "a step of at least one pixel");
    return (static_cast<std::size_t>(camera.height) + static_cast<std::size_t>(subset.step) - 1) /
           static_cast<std::size_t>(subset.step);
}

std::optional<SurfacePoint> seenBy(const Surface& surface, const PixelRay& ray)
{
    return surface.bvh().raycast({glm::vec3(ray.origin), glm::vec3(ray.direction)});
}

void append(ViewQueries& to, const ViewQueries& from)
{
    const auto join = [](auto& whole, const auto& part) {
        whole.insert(whole.end(), part.begin(), part.end());
    };
    join(to.pixel, from.pixel);
    join(to.queries.face, from.queries.face);
    join(to.queries.u, from.queries.u);
    join(to.queries.v, from.queries.v);
    join(to.queries.uw1, from.queries.uw1);
    join(to.queries.vw1, from.queries.vw1);
    join(to.queries.uw2, from.queries.uw2);
    join(to.queries.vw2, from.queries.vw2);
    to.asked += from.asked;
}

/// Whether one of the views sees a point with a spacing of no more than this.
bool isCovered(const Surface& surface, const SceneViews& views, glm::dvec3 point, double spacing)
{
    const auto reaches = [&](const DistantViews& distant) {
        return distant.unitsPerPixel() <= spacing;
    };
    const auto shows = [&](const ViewCamera& listed) {
        return listed.unitsPerPixel(point) <= spacing &&
               sees(surface, listed, point, kFrameRounding);
    };
    return std::ranges::any_of(views.distant, reaches) || std::ranges::any_of(views.cameras, shows);
}

/// What rays meet of a cage, and the flat face that is there.
class CageSight
{
public:
    explicit CageSight(const Surface& surface)
        : m_surface(surface)
    {
    }
    std::optional<SurfacePoint> meet(const PixelRay& ray) const { return seenBy(m_surface, ray); }
    std::array<glm::vec3, 3> flatFace(const SurfacePoint& at) const
    {
        return m_surface.mesh().corners(at.face);
    }

private:
    const Surface& m_surface;
};

/// The same of its limit surface; for one thread.
class LimitSight
{
public:
    explicit LimitSight(const LimitMesh& limit)
        : m_limit(limit)
        , m_evaluator(limit.surface())
    {
    }
    std::optional<SurfacePoint> meet(const PixelRay& ray)
    {
        return m_limit.raycast({glm::vec3(ray.origin), glm::vec3(ray.direction)}, m_evaluator);
    }
    std::array<glm::vec3, 3> flatFace(const SurfacePoint& at)
    {
        m_evaluator.moveTo(at.face);
        return m_evaluator.at(glm::dvec2(at.uv)).tangentFace(glm::dvec2(at.uv));
    }

private:
    const LimitMesh& m_limit;
    LimitSurface::Evaluator m_evaluator;
};

template <class Sight>
ViewQueries rowQueries(Sight sight, const ViewCamera& camera, const BlockRow& row)
{
    ViewQueries found;
    row.forEach([&](int x, int y) {
        ++found.asked;
        const PixelRay ray = camera.pixelRay(x + 0.5, y + 0.5);
        const auto hit = sight.meet(ray);
        if (!hit) {
            return;
        }
        const Footprint footprint = screenFootprint(ray, sight.flatFace(*hit));
        found.pixel.push_back(static_cast<std::uint32_t>(y) *
                                  static_cast<std::uint32_t>(camera.width) +
                              static_cast<std::uint32_t>(x));
        found.queries.add(hit->face, hit->uv, glm::vec2(footprint.w1), glm::vec2(footprint.w2));
    });
    return found;
}

/// \param rowOf  the queries of a row of blocks
Result<ViewQueries> allRows(const ViewCamera& camera,
                            PixelSubset subset,
                            Threads threads,
                            Progress& progress,
                            const std::function<ViewQueries(const BlockRow&)>& rowOf)
{
    constexpr std::size_t kRowsBetweenReports = 32;
    const std::size_t rows = blockRows(camera, subset);
    ViewQueries all;
    for (std::size_t begin = 0; begin < rows; begin += kRowsBetweenReports) {
        if (!progress.report(static_cast<double>(begin) / static_cast<double>(rows))) {
            return cancelled();
        }
        const std::size_t count = std::min(kRowsBetweenReports, rows - begin);
        std::vector<ViewQueries> parts(count);
        parallelFor(count, 1, threads, [&](std::size_t from, std::size_t to) {
            for (std::size_t k = from; k < to; ++k) {
                parts[k] = rowOf(BlockRow(camera, subset, begin + k));
            }
        });
        for (const ViewQueries& part : parts) {
            append(all, part);
        }
    }
    return all;
}

} // namespace

Result<ViewQueries> viewQueries(const Surface& surface,
                                const ViewCamera& camera,
                                PixelSubset subset,
                                Threads threads,
                                Progress& progress)
{
    return allRows(camera, subset, threads, progress, [&](const BlockRow& row) {
        return rowQueries(CageSight(surface), camera, row);
    });
}

Result<ViewQueries> viewQueries(const LimitMesh& limit,
                                const ViewCamera& camera,
                                PixelSubset subset,
                                Threads threads,
                                Progress& progress)
{
    return allRows(camera, subset, threads, progress, [&](const BlockRow& row) {
        return rowQueries(LimitSight(limit), camera, row);
    });
}

bool isCovered(const Surface& surface,
               const SceneViews& views,
               const ViewCamera& camera,
               PixelSubset subset)
{
    // The view may be one of the listed ones, its hits computed along another way.
    constexpr double kRounding = 1e-6;
    bool covered = true;
    for (std::size_t row = 0; row < blockRows(camera, subset) && covered; ++row) {
        BlockRow(camera, subset, row).forEach([&](int x, int y) {
            const auto hit =
                covered ? seenBy(surface, camera.pixelRay(x + 0.5, y + 0.5)) : std::nullopt;
            if (hit) {
                const glm::dvec3 point(hit->position);
                covered =
                    isCovered(surface, views, point, camera.unitsPerPixel(point) * (1 + kRounding));
            }
        });
    }
    return covered;
}

} // namespace trixel
