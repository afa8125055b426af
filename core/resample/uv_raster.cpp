// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/resample/uv_raster.h"

#include "core/base/check.h"
#include "core/mesh/shared_progress.h"
#include "core/mesh/triangle_geometry.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace trixel {

namespace {

/// Rows that one thread fills at a time.
constexpr int kBandRows = 32;

/// Rounding: centres that lie on an edge by the numbers lie on it.
constexpr double kOnEdge = 1e-9;

struct PixelBox
{
    int left = 0, top = 0, right = -1, bottom = -1; ///< both ends included

    bool isEmpty() const { return right < left || bottom < top; }
};

/// Pixels whose centres a face's box holds, within the image.
PixelBox boxOf(const std::array<glm::vec2, 3>& uvs, const PixelPlane& plane, int width, int height)
{
    glm::dvec2 low(std::numeric_limits<double>::infinity());
    glm::dvec2 high(-low);
    for (const glm::vec2 uv : uvs) {
        const glm::dvec2 p = plane.pixels(glm::dvec2(uv));
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    const auto first = [](double at, int size) {
        return static_cast<int>(std::clamp(std::ceil(at - 0.5 - 1e-6), 0.0, 1.0 * size));
    };
    const auto last = [](double at, int size) {
        return static_cast<int>(std::clamp(std::floor(at - 0.5 + 1e-6), -1.0, size - 1.0));
    };
    return {first(low.x, width), first(low.y, height), last(high.x, width), last(high.y, height)};
}

/// The faces whose boxes reach into each band of rows.
std::vector<std::vector<std::uint32_t>>
facesOfBands(const TriangleMesh& mesh, const PixelPlane& plane, int width, int height)
{
    std::vector<std::vector<std::uint32_t>> bands(
        static_cast<std::size_t>((height + kBandRows - 1) / kBandRows));
    for (std::uint32_t k = 0; k < mesh.faceCount(); ++k) {
        const auto uvs = mesh.uvs(faceId(k));
        if (!PixelsInFace::of(uvs, plane)) {
            continue;
        }
        const PixelBox box = boxOf(uvs, plane, width, height);
        for (int band = box.top / kBandRows; !box.isEmpty() && band <= box.bottom / kBandRows;
             ++band) {
            bands[static_cast<std::size_t>(band)].push_back(k);
        }
    }
    return bands;
}

/// Distance in pixels from a centre to a face's uvs, squared.
double squaredDistance(const TriangleMesh& mesh,
                       std::uint32_t face,
                       const PixelPlane& plane,
                       glm::dvec2 centre)
{
    const auto uvs = mesh.uvs(faceId(face));
    std::array<glm::vec3, 3> corners{};
    for (std::size_t k = 0; k < 3; ++k) {
        // Relative to the centre, so that floats suffice.
        corners[k] = glm::vec3(glm::vec2(plane.pixels(glm::dvec2(uvs[k])) - centre), 0);
    }
    return nearestOnTriangle(corners, glm::dvec3(0)).distanceSquared;
}

/// Takes the pixels of one band, from row `top` on, that lie in a face and that no other has.
void drawFace(const TriangleMesh& mesh,
              std::uint32_t face,
              const PixelPlane& plane,
              int top,
              UvRaster& raster)
{
    const auto uvs = mesh.uvs(faceId(face));
    const PixelsInFace in = *PixelsInFace::of(uvs, plane);
    const PixelBox box = boxOf(uvs, plane, raster.width, raster.height);
    const int last = std::min(box.bottom, top + kBandRows - 1);
    for (int y = std::max(box.top, top); y <= last; ++y) {
        for (int x = box.left; x <= box.right; ++x) {
            const glm::dvec2 uv = in.uv({x + 0.5, y + 0.5});
            const std::size_t at =
                static_cast<std::size_t>(y) * static_cast<std::size_t>(raster.width) +
                static_cast<std::size_t>(x);
            if (raster.owners[at] == 0 && uv.x >= -kOnEdge && uv.y >= -kOnEdge &&
                uv.x + uv.y <= 1 + kOnEdge) {
                raster.owners[at] = face + 1;
                raster.inside[at] = 1;
            }
        }
    }
}

/// Waits for an owner; no face has that number.
constexpr std::uint32_t kWaiting = std::numeric_limits<std::uint32_t>::max();

/// Gives owners to pixels next to owned ones, step by step. Only those are looked at that border on
/// pixels which the step before has given away.
class Grower
{
public:
    Grower(UvRaster& raster, const TriangleMesh& mesh, const PixelPlane& plane, Threads threads)
        : m_raster(raster)
        , m_mesh(mesh)
        , m_plane(plane)
        , m_threads(threads)
    {
    }

    /// Begins with every pixel next to an owned one.
    void begin()
    {
        const auto height = static_cast<std::size_t>(m_raster.height);
        std::vector<std::vector<std::size_t>> bands((height + kBandRows - 1) / kBandRows);
        parallelFor(bands.size(), 1, m_threads, [&](std::size_t first, std::size_t last) {
            for (std::size_t band = first; band < last; ++band) {
                bands[band] = besideOwned(static_cast<int>(band) * kBandRows);
            }
        });
        for (const std::vector<std::size_t>& band : bands) {
            m_front.insert(m_front.end(), band.begin(), band.end());
        }
        for (const std::size_t pixel : m_front) {
            m_raster.owners[pixel] = kWaiting;
        }
    }

    bool isDone() const { return m_front.empty(); }

    void step()
    {
        m_found.resize(m_front.size());
        parallelFor(m_front.size(), 256, m_threads, [&](std::size_t first, std::size_t last) {
            for (std::size_t k = first; k < last; ++k) {
                m_found[k] = nearestOwner(m_front[k]);
            }
        });
        for (std::size_t k = 0; k < m_front.size(); ++k) {
            m_raster.owners[m_front[k]] = m_found[k];
        }
        m_next.clear();
        for (const std::size_t pixel : m_front) {
            forBeside(pixel, [&](std::size_t beside) {
                if (m_raster.owners[beside] == 0) {
                    m_raster.owners[beside] = kWaiting;
                    m_next.push_back(beside);
                }
            });
        }
        m_front.swap(m_next);
    }

    /// Those that still wait get none.
    void end()
    {
        for (const std::size_t pixel : m_front) {
            m_raster.owners[pixel] = 0;
        }
    }

private:
    std::vector<std::size_t> besideOwned(int top) const
    {
        const auto width = static_cast<std::size_t>(m_raster.width);
        const auto begin = static_cast<std::size_t>(top) * width;
        const std::size_t end = std::min(begin + kBandRows * width, m_raster.pixelCount());
        std::vector<std::size_t> found;
        for (std::size_t pixel = begin; pixel < end; ++pixel) {
            bool borders = false;
            if (m_raster.owners[pixel] == 0) {
                forBeside(pixel, [&](std::size_t beside) {
                    borders = borders || m_raster.owners[beside] != 0;
                });
            }
            if (borders) {
                found.push_back(pixel);
            }
        }
        return found;
    }

    /// The pixels about one, in rows from the top.
    template <class Look>
    void forBeside(std::size_t pixel, const Look& look) const
    {
        const auto width = static_cast<std::size_t>(m_raster.width);
        const std::size_t x = pixel % width;
        const std::size_t y = pixel / width;
        const std::size_t left = x > 0 ? x - 1 : x;
        const std::size_t right = std::min(x + 1, width - 1);
        const std::size_t bottom = std::min(y + 1, static_cast<std::size_t>(m_raster.height) - 1);
        for (std::size_t row = y > 0 ? y - 1 : y; row <= bottom; ++row) {
            for (std::size_t column = left; column <= right; ++column) {
                look(row * width + column);
            }
        }
    }

    std::uint32_t nearestOwner(std::size_t pixel) const
    {
        const auto width = static_cast<std::size_t>(m_raster.width);
        const glm::dvec2 centre(static_cast<double>(pixel % width) + 0.5,
                                static_cast<double>(pixel / width) + 0.5);
        std::uint32_t best = 0;
        double bestDistance = std::numeric_limits<double>::infinity();
        forBeside(pixel, [&](std::size_t beside) {
            const std::uint32_t owner = m_raster.owners[beside];
            if (owner == 0 || owner == kWaiting || owner == best) {
                return;
            }
            const double distance = squaredDistance(m_mesh, owner - 1, m_plane, centre);
            if (distance < bestDistance || (distance == bestDistance && owner < best)) {
                best = owner;
                bestDistance = distance;
            }
        });
        return best;
    }

    UvRaster& m_raster;
    const TriangleMesh& m_mesh;
    const PixelPlane& m_plane;
    Threads m_threads;
    std::vector<std::size_t> m_front, m_next;
    std::vector<std::uint32_t> m_found;
};

} // namespace

std::optional<PixelsInFace> PixelsInFace::of(const std::array<glm::vec2, 3>& uvs,
                                             const PixelPlane& plane)
{
    const glm::dvec2 origin = plane.pixels(glm::dvec2(uvs[0]));
    const glm::dvec2 perU = plane.pixels(glm::dvec2(uvs[1])) - origin;
    const glm::dvec2 perV = plane.pixels(glm::dvec2(uvs[2])) - origin;
    const double area = perU.x * perV.y - perU.y * perV.x;
    const double longest =
        std::max({std::abs(perU.x), std::abs(perU.y), std::abs(perV.x), std::abs(perV.y)});
    constexpr double kFlattest = 1e-12;
    if (!(std::abs(area) > kFlattest * longest * longest) || !std::isfinite(area)) {
        return std::nullopt;
    }
    return PixelsInFace{
        origin, glm::dvec2(perV.y, -perU.y) / area, glm::dvec2(-perV.x, perU.x) / area};
}

Result<UvRaster> rasterUvs(const TriangleMesh& mesh,
                           int width,
                           int height,
                           UdimTile tile,
                           Threads threads,
                           Progress& progress)
{
    check(mesh.hasUvs(), "a mesh with uvs");
    check(width > 0 && height > 0, "an image of at least one pixel");
    const PixelPlane plane(width, height, tile);
    const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    UvRaster raster{
        width, height, std::vector<std::uint32_t>(pixels), std::vector<std::uint8_t>(pixels)};
    const auto bands = facesOfBands(mesh, plane, width, height);
    SharedProgress shared(progress, bands.size());
    parallelFor(bands.size(), 1, threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t band = begin; band < end && shared.goesOn(); ++band) {
            const int top = static_cast<int>(band) * kBandRows;
            for (const std::uint32_t face : bands[band]) {
                drawFace(mesh, face, plane, top, raster);
            }
            shared.step();
        }
    });
    return shared.goesOn() ? Result<UvRaster>(std::move(raster)) : cancelled();
}

Status growRaster(UvRaster& raster,
                  const TriangleMesh& mesh,
                  UdimTile tile,
                  int pixels,
                  Threads threads,
                  Progress& progress)
{
    const PixelPlane plane(raster.width, raster.height, tile);
    Grower grower(raster, mesh, plane, threads);
    if (pixels > 0) {
        grower.begin();
    }
    for (int step = 0; step < pixels && !grower.isDone(); ++step) {
        if (!progress.report(static_cast<double>(step) / pixels)) {
            return cancelled();
        }
        grower.step();
    }
    grower.end();
    return progress.report(1) ? Status() : cancelled();
}

} // namespace trixel
