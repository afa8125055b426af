// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/filter/face_net.h"
#include "core/texture/texel_walk.h"
#include "ui/inspector/plane_sight.h"

#include <functional>
#include <optional>
#include <vector>

namespace trixel::ui {

/// Three ways to look at the texels of a face.
enum class LayoutKind {
    Net,         ///< as on the mesh, with the neighbours unfolded
    Packed,      ///< as the file stores them
    Rectilinear, ///< in rows: x = u + v/2, y = v
};

/// A face in the plane of a view.
struct SceneFace
{
    FaceId face{};
    Level level; ///< as shown
    FaceLayout layout;

    bool operator==(const SceneFace&) const = default;
};

/// What one view shows: the face that it is about and perhaps its neighbours.
struct LayoutScene
{
    LayoutKind kind = LayoutKind::Net;
    std::vector<SceneFace> faces; ///< as they are drawn, one over the other: the main one is last
    PlaneBox home;                ///< what is shown when nothing was moved

    const SceneFace& main() const { return faces.back(); }
    /// Whether a face is part of it.
    bool shows(FaceId face) const;
    /// What is drawn at a point, and in which of the faces.
    struct Hit
    {
        const SceneFace* face = nullptr;
        TexelPlace place;
    };
    std::optional<Hit> at(glm::dvec2 point) const;
    /// The nearest one may want to look: a texel fills the view.
    double nearest() const;

    bool operator==(const LayoutScene&) const = default;
};

using LevelOfFace = std::function<Level(FaceId)>;

/// Around the net's centre some room shows of its neighbours, large as they may be.
LayoutScene netScene(const FaceNet& net, const LevelOfFace& levelOf);
/// \param kind  Packed or Rectilinear (checked)
LayoutScene faceScene(LayoutKind kind, FaceId face, Level level);

} // namespace trixel::ui
