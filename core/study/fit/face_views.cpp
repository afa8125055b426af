// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/fit/face_views.h"

#include <algorithm>
#include <limits>

namespace trixel {
namespace {

/// A covered view may show the edge of what its camera frames with part of a footprint beyond.
constexpr double kFrameMargin = 4; // pixels
constexpr double kNever = std::numeric_limits<double>::infinity();

} // namespace

Result<FaceViews> FaceViews::find(const Surface& surface,
                                  const SceneViews& views,
                                  UnseenFaces unseen,
                                  Threads threads,
                                  Progress& progress)
{
    auto seen = SeenFaces::find(surface, views.cameras, kFrameMargin, threads, progress);
    if (!seen) {
        return tl::unexpected(seen.error());
    }
    return FaceViews(surface, views, unseen, std::move(*seen));
}

double FaceViews::distantSpacing() const
{
    double finest = kNever;
    for (const DistantViews& views : m_views->distant) {
        finest = std::min(finest, views.unitsPerPixel());
    }
    return finest;
}

double FaceViews::finestSpacing(FaceId face, glm::dvec3 point) const
{
    double finest = distantSpacing();
    if (!isSeen(face)) {
        return spacingUnhidden(face, point);
    }
    for (std::size_t k = 0; k < m_views->cameras.size(); ++k) {
        const ViewCamera& camera = m_views->cameras[k];
        if (m_seen.isSeenBy(k, face) && camera.unitsPerPixel(point) < finest &&
            sees(*m_surface, camera, point, kFrameMargin)) {
            finest = camera.unitsPerPixel(point);
        }
    }
    return finest;
}

double FaceViews::spacingUnhidden(FaceId face, glm::dvec3 point) const
{
    double finest = distantSpacing();
    const bool byDistance = !isSeen(face) && m_unseen == UnseenFaces::ByDistance;
    for (std::size_t k = 0; k < m_views->cameras.size(); ++k) {
        const ViewCamera& camera = m_views->cameras[k];
        if (!byDistance && !m_seen.isSeenBy(k, face)) {
            continue;
        }
        if (camera.frames(point, kFrameMargin)) {
            finest = std::min(finest, camera.unitsPerPixel(point));
        } else if (byDistance) {
            finest = std::min(finest, camera.unitsPerPixelTurned(point));
        }
    }
    return finest;
}

} // namespace trixel
