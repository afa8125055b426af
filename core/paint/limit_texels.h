// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where the texels of faces lie on a limit surface: evaluated where a stroke comes near, once a
// stroke.
#pragma once

#include "core/base/level.h"
#include "core/mesh/limit_mesh.h"
#include "core/paint/dab.h"
#include "core/paint/dab_reach.h"

#include <cstdint>
#include <memory>
#include <span>
#include <unordered_map>
#include <vector>

namespace trixel {

/// A texel's centroid on the limit surface.
struct LimitTexel
{
    glm::vec3 position{0};
    glm::vec3 normal{0}; ///< as `Dab::normal`; zero where texels that face away are painted
};

/// The texels of one face, in the tiles of the packed square that `StrokeFace` has. Rows of tiles
/// are independent of each other and may be worked on by different threads.
class LimitFaceTexels
{
public:
    /// \param reach  that turns normals; null for no normals
    LimitFaceTexels(const LimitMesh& limit,
                    FaceId face,
                    Level level,
                    std::shared_ptr<const DabReach> reach);

    std::uint32_t tileSide() const { return m_side; }
    std::uint32_t tilesPerRow() const { return m_perRow; }
    /// Whether a tile may hold texels within the dab's radius.
    bool isInReach(std::uint32_t tileX, std::uint32_t tileY, const Dab& dab) const;
    /// Row-major; evaluated at the first call.
    std::span<const LimitTexel>
    texels(std::uint32_t tileX, std::uint32_t tileY, LimitSurface::Evaluator& evaluator);

private:
    struct Tile
    {
        glm::vec3 centre{0}; ///< of a ball around what the tile's texels cover
        float radius = 0;
        std::vector<LimitTexel> texels;
    };
    LimitTexel evaluated(glm::dvec2 uv, const LimitSurface::Evaluator& evaluator) const;
    void bound(Tile& tile,
               std::uint32_t tileX,
               std::uint32_t tileY,
               const LimitSurface::Evaluator& evaluator,
               const FaceBend& bend) const;

    std::shared_ptr<const DabReach> m_reach;
    FaceId m_face{};
    Level m_level;
    std::uint32_t m_side = 1;
    std::uint32_t m_perRow = 1;
    std::vector<Tile> m_tiles; ///< row-major
};

/// The faces that a stroke has come near.
class LimitTexels
{
public:
    /// \param reach  by which texels are told that face away from a dab; null to paint those, too
    LimitTexels(std::shared_ptr<const LimitMesh> limit, std::shared_ptr<const DabReach> reach)
        : m_limit(std::move(limit))
        , m_reach(std::move(reach))
    {
    }

    const LimitSurface& surface() const { return m_limit->surface(); }
    /// Stays where it is. \param level  the same at every call for a face
    LimitFaceTexels& face(FaceId face, Level level);

private:
    std::shared_ptr<const LimitMesh> m_limit;
    std::shared_ptr<const DabReach> m_reach;
    std::unordered_map<std::uint32_t, std::unique_ptr<LimitFaceTexels>> m_faces;
};

} // namespace trixel
