// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/resample/uv_raster.h"

#include "core/base/check.h"
#include "core/mesh/triangle_geometry.h"

#include <algorithm>
#include <cmath>
#include <limits>

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

class Grower
{
public:
    Grower(const UvRaster& before, const TriangleMesh& mesh, const PixelPlane& plane)
        : m_before(before)
        , m_mesh(mesh)
        , m_plane(plane)
    {
    }

    void row(int y, std::uint32_t* owners) const
    {
        for (int x = 0; x < m_before.width; ++x) {
            if (owners[x] == 0) {
                owners[x] = nearestOwner(x, y);
            }
        }
    }

private:
    std::uint32_t at(int x, int y) const
    {
        const bool inside = x >= 0 && y >= 0 && x < m_before.width && y < m_before.height;
        return inside ? m_before.owners[static_cast<std::size_t>(y) *
                                            static_cast<std::size_t>(m_before.width) +
                                        static_cast<std::size_t>(x)]
                      : 0;
    }

    std::uint32_t nearestOwner(int x, int y) const
    {
        std::uint32_t best = 0;
        double bestDistance = std::numeric_limits<double>::infinity();
        for (int k = 0; k < 9; ++k) {
            const std::uint32_t owner = at(x + k % 3 - 1, y + k / 3 - 1);
            if (owner == 0 || owner == best) {
                continue;
            }
            const double distance = squaredDistance(m_mesh, owner - 1, m_plane, {x + 0.5, y + 0.5});
            if (distance < bestDistance || (distance == bestDistance && owner < best)) {
                best = owner;
                bestDistance = distance;
            }
        }
        return best;
    }

    const UvRaster& m_before;
    const TriangleMesh& m_mesh;
    const PixelPlane& m_plane;
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

UvRaster rasterUvs(const TriangleMesh& mesh, int width, int height, UdimTile tile, Threads threads)
{
    check(mesh.hasUvs(), "a mesh with uvs");
    check(width > 0 && height > 0, "an image of at least one pixel");
    const PixelPlane plane(width, height, tile);
    const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    UvRaster raster{
        width, height, std::vector<std::uint32_t>(pixels), std::vector<std::uint8_t>(pixels)};
    const auto bands = facesOfBands(mesh, plane, width, height);
    parallelFor(bands.size(), 1, threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t band = begin; band < end; ++band) {
            const int top = static_cast<int>(band) * kBandRows;
            for (const std::uint32_t face : bands[band]) {
                const auto uvs = mesh.uvs(faceId(face));
                const PixelsInFace in = *PixelsInFace::of(uvs, plane);
                const PixelBox box = boxOf(uvs, plane, width, height);
                const int last = std::min(box.bottom, top + kBandRows - 1);
                for (int y = std::max(box.top, top); y <= last; ++y) {
                    for (int x = box.left; x <= box.right; ++x) {
                        const glm::dvec2 uv = in.uv({x + 0.5, y + 0.5});
                        const std::size_t at =
                            static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                            static_cast<std::size_t>(x);
                        if (raster.owners[at] == 0 && uv.x >= -kOnEdge && uv.y >= -kOnEdge &&
                            uv.x + uv.y <= 1 + kOnEdge) {
                            raster.owners[at] = face + 1;
                            raster.inside[at] = 1;
                        }
                    }
                }
            }
        }
    });
    return raster;
}

void growRaster(
    UvRaster& raster, const TriangleMesh& mesh, UdimTile tile, int pixels, Threads threads)
{
    const PixelPlane plane(raster.width, raster.height, tile);
    UvRaster before;
    before.width = raster.width;
    before.height = raster.height;
    for (int step = 0; step < pixels; ++step) {
        before.owners = raster.owners;
        const Grower grower(before, mesh, plane);
        parallelFor(static_cast<std::size_t>(raster.height),
                    16,
                    threads,
                    [&](std::size_t begin, std::size_t end) {
                        for (std::size_t y = begin; y < end; ++y) {
                            grower.row(static_cast<int>(y),
                                       raster.owners.data() +
                                           y * static_cast<std::size_t>(raster.width));
                        }
                    });
        if (raster.owners == before.owners) {
            return;
        }
    }
}

} // namespace trixel
