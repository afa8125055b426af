// SPDX-License-Identifier: GPL-3.0-or-later
//
// What cameras see of a surface, and what is hidden from them.
#pragma once

#include "core/base/parallel.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/mesh/surface.h"
#include "core/study/views/view_camera.h"

#include <cstdint>
#include <span>
#include <vector>

namespace trixel {

/// Whether a camera sees a point of the surface, from either side: it frames it, and nothing stands
/// in between. What stands nearer by less than a hundred-thousandth of the distance hides nothing,
/// so that a point is not hidden by the faces about it.
/// \param margin  pixels outside the picture that still count as framed
bool sees(const Surface& surface, const ViewCamera& camera, glm::dvec3 point, double margin = 0);

/// Which faces each of some cameras sees any part of.
class SeenFaces
{
public:
    /// Asks the pixels of each picture, all of them where they are up to four million for all
    /// cameras together, and of each face that they miss points at its corners, along its edges and
    /// within. So what is missed is smaller than a pixel and than a thousandth of its face. Fails
    /// only when cancelled. \param margin  pixels outside a picture that still count as framed
    static Result<SeenFaces> find(const Surface& surface,
                                  std::span<const ViewCamera> cameras,
                                  double margin,
                                  Threads threads,
                                  Progress& progress);

    /// Whether a camera, by its number, sees part of the face.
    bool isSeenBy(std::size_t camera, FaceId face) const
    {
        return (m_seen[wordOf(camera, face)] >> (camera % 64) & 1U) != 0;
    }
    /// Whether any camera does.
    bool isSeen(FaceId face) const;

private:
    SeenFaces(std::size_t faces, std::size_t cameras);

    std::size_t wordOf(std::size_t camera, FaceId face) const
    {
        return indexOf(face) * m_words + camera / 64;
    }
    void mark(std::size_t camera, FaceId face)
    {
        m_seen[wordOf(camera, face)] |= std::uint64_t{1} << (camera % 64);
    }
    Status askPixels(const Surface& surface,
                     std::span<const ViewCamera> cameras,
                     Threads threads,
                     Progress& progress);
    Status askFaces(const Surface& surface,
                    std::span<const ViewCamera> cameras,
                    double margin,
                    Threads threads,
                    Progress& progress);

    std::size_t m_words = 0;           ///< of each face
    std::vector<std::uint64_t> m_seen; ///< a bit a camera
};

} // namespace trixel
