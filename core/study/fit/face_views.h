// SPDX-License-Identifier: GPL-3.0-or-later
//
// How closely the views of a scene see each face, and what is done with faces that none of them
// sees.
#pragma once

#include "core/study/views/seen_faces.h"

#include <array>
#include <string_view>
#include <utility>

namespace trixel {

/// What a fit does with faces that no view sees: they are in no picture, or hidden in all.
enum class UnseenFaces {
    OneTexel,   ///< they keep their mean
    ByDistance, ///< as if each camera turned to them and nothing stood in between
};

inline constexpr std::array kUnseenFaces = {UnseenFaces::OneTexel, UnseenFaces::ByDistance};

/// As the command line calls it: "one-texel", "by-distance".
constexpr std::string_view nameOf(UnseenFaces unseen)
{
    return unseen == UnseenFaces::OneTexel ? "one-texel" : "by-distance";
}

/// How closely a fit takes each face to be seen.
class FaceViews
{
public:
    /// Fails only when cancelled. The surface and the views must outlive it.
    static Result<FaceViews> find(const Surface& surface,
                                  const SceneViews& views,
                                  UnseenFaces unseen,
                                  Threads threads,
                                  Progress& progress);

    /// Whether a view sees part of the face; those of a distance see every face.
    bool isSeen(FaceId face) const { return !m_views->distant.empty() || m_seen.isSeen(face); }

    /// The fewest world units a pixel at a point of a face, over the views that see the point;
    /// infinite where none does. Where no view sees any part of the face, what becomes of it
    /// decides.
    double finestSpacing(FaceId face, glm::dvec3 point) const;
    /// The same over the views that see any part of the face and frame the point, whatever hides
    /// it.
    double spacingUnhidden(FaceId face, glm::dvec3 point) const;

private:
    FaceViews(const Surface& surface, const SceneViews& views, UnseenFaces unseen, SeenFaces seen)
        : m_surface(&surface)
        , m_views(&views)
        , m_unseen(unseen)
        , m_seen(std::move(seen))
    {
    }

    double distantSpacing() const;

    const Surface* m_surface;
    const SceneViews* m_views;
    UnseenFaces m_unseen;
    SeenFaces m_seen;
};

} // namespace trixel
