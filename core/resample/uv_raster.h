// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which face's uvs the pixels of an image lie in, and which is nearest to those that lie in none.
#pragma once

#include "core/base/parallel.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/mapping/uv_mapping.h"
#include "core/mesh/triangle_mesh.h"

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <optional>
#include <vector>

namespace trixel {

/// The pixels of one tile's image, and how its plane lies in faces.
class PixelPlane
{
public:
    PixelPlane(int width, int height, UdimTile tile)
        : m_size(width, height)
        , m_corner(tile.column, tile.row)
    {
    }

    /// A place in the image plane in pixels from the upper left corner; centres at halves.
    glm::dvec2 pixels(glm::dvec2 st) const
    {
        const glm::dvec2 in = st - m_corner;
        return {in.x * m_size.x, (1 - in.y) * m_size.y};
    }

private:
    glm::dvec2 m_size;
    glm::dvec2 m_corner;
};

/// How pixels lie in the (u,v) of one face.
struct PixelsInFace
{
    glm::dvec2 origin{0}; ///< of V0, in pixels
    glm::dvec2 perX{0};   ///< change of (u,v) for a pixel to the right
    glm::dvec2 perY{0};   ///< for a pixel down

    glm::dvec2 uv(glm::dvec2 pixel) const
    {
        return (pixel.x - origin.x) * perX + (pixel.y - origin.y) * perY;
    }
    /// Nothing for a face without uvs or without area in them.
    static std::optional<PixelsInFace> of(const std::array<glm::vec2, 3>& uvs,
                                          const PixelPlane& plane);
};

/// For every pixel, rows from the top, the number of the face it belongs to plus one; 0 for none.
struct UvRaster
{
    int width = 0, height = 0;
    std::vector<std::uint32_t> owners;
    std::vector<std::uint8_t> inside; ///< 1 where the pixel's centre lies in the face's uvs

    std::size_t pixelCount() const { return owners.size(); }
};

/// Pixels whose centres lie in a face's uvs, its border counted; of several faces the lowest.
/// Fails only when cancelled.
/// \param mesh  with uvs (checked)
Result<UvRaster> rasterUvs(const TriangleMesh& mesh,
                           int width,
                           int height,
                           UdimTile tile,
                           Threads threads,
                           Progress& progress);

/// Gives pixels that belong to no face, and lie up to so many pixels from one that does, the
/// nearest of the faces that own their neighbours; of equals the lowest. Work goes by the pixels
/// that are given away, and is told of after each step of one pixel. Fails only when cancelled; the
/// raster is of no use then.
Status growRaster(UvRaster& raster,
                  const TriangleMesh& mesh,
                  UdimTile tile,
                  int pixels,
                  Threads threads,
                  Progress& progress);

} // namespace trixel
