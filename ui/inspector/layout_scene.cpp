// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inspector/layout_scene.h"

#include "core/base/check.h"

#include <algorithm>
#include <glm/common.hpp>

namespace trixel::ui {

namespace {

PlaneBox boxOf(const FaceLayout& layout)
{
    const TexelOutline outline = layout.outline();
    const auto corners = outline.corners();
    PlaneBox box{corners[0], corners[0]};
    for (const glm::dvec2 corner : corners) {
        box = box.with(corner);
    }
    return box;
}

} // namespace

bool LayoutScene::shows(FaceId face) const
{
    return std::ranges::any_of(faces, [&](const SceneFace& shown) { return shown.face == face; });
}

std::optional<LayoutScene::Hit> LayoutScene::at(glm::dvec2 point) const
{
    for (auto shown = faces.rbegin(); shown != faces.rend(); ++shown) {
        if (const auto texel = shown->layout.texelAt(shown->level, point)) {
            return Hit{&*shown, {shown->face, *texel}};
        }
    }
    return std::nullopt;
}

double LayoutScene::nearest() const
{
    int finest = 0;
    for (const SceneFace& shown : faces) {
        finest = std::max(finest, shown.level.log2());
    }
    constexpr double kNearer = 2;
    return kNearer * static_cast<double>(1U << static_cast<unsigned>(finest));
}

LayoutScene netScene(const FaceNet& net, const LevelOfFace& levelOf)
{
    LayoutScene scene{LayoutKind::Net, {}, boxOf(net.centre.layout())};
    PlaneBox whole = scene.home;
    for (const auto& laid : net.across) {
        if (laid) {
            scene.faces.push_back({laid->face, levelOf(laid->face), laid->layout()});
            const PlaneBox box = boxOf(scene.faces.back().layout);
            whole = whole.with(box.low).with(box.high);
        }
    }
    scene.faces.push_back({net.centre.face, levelOf(net.centre.face), net.centre.layout()});
    constexpr double kRoomAround = 0.6;
    const glm::dvec2 size = scene.home.size();
    const glm::dvec2 room = kRoomAround * glm::dvec2(std::max(size.x, size.y));
    scene.home = {glm::max(scene.home.low - room, whole.low),
                  glm::min(scene.home.high + room, whole.high)};
    return scene;
}

LayoutScene faceScene(LayoutKind kind, FaceId face, Level level)
{
    check(kind != LayoutKind::Net, "a view of one face");
    const FaceLayout layout =
        kind == LayoutKind::Packed ? FaceLayout::packed() : FaceLayout::rectilinear();
    return {kind, {{face, level, layout}}, boxOf(layout)};
}

} // namespace trixel::ui
