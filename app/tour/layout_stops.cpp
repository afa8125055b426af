// SPDX-License-Identifier: GPL-3.0-or-later
//
// The stop at the texels of a face, laid out in three ways.
#include <QDockWidget>

#include "app/tour/looks.h"
#include "app/tour/stops.h"
#include "core/filter/face_net.h"
#include "ui/document/inspection.h"
#include "ui/inspector/layout_panel.h"
#include "ui/viewport/viewport.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <optional>

namespace trixel::app {

namespace {

constexpr int kLayoutHeight = 380;

/// How much the first channel varies over its texels: the variance, in bytes' steps.
double contrastOf(const FaceTexels& face)
{
    const auto count = static_cast<double>(face.level().texelCount());
    double sum = 0;
    double squares = 0;
    for (std::size_t k = 0; k < face.level().texelCount(); ++k) {
        const auto value = static_cast<double>(face.texel(k)[0]);
        sum += value;
        squares += value * value;
    }
    return squares / count - (sum / count) * (sum / count);
}

/// 1 for equal sides, 0 for a needle.
double evennessOf(const LaidFace& laid)
{
    double longest = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        longest = std::max(longest, glm::distance(laid.corners[k], laid.corners[(k + 1) % 3]));
    }
    return laid.layout().map().area() / (longest * longest);
}

/// A painted face of few texels that meets another level: there is most to see.
std::optional<FaceId> faceToShow(const Surface& surface, const TexelStore& texels)
{
    std::optional<FaceId> best;
    double most = 0;
    for (std::size_t k = 0; k < texels.faceCount(); ++k) {
        const FaceId face = faceId(k);
        const FaceTexels& own = texels.face(face);
        if (own.isConstant() || own.level().log2() < 2 || own.level().log2() > 3) {
            continue;
        }
        int painted = 0;
        bool meetsAnother = false;
        for (const LocalEdge edge : kLocalEdges) {
            if (const auto across = surface.adjacency().neighbour(face, edge)) {
                const FaceTexels& other = texels.face(across->face);
                painted += other.isConstant() ? 0 : 1;
                meetsAnother = meetsAnother || other.level() != own.level();
            }
        }
        if (painted < 3 || !meetsAnother) {
            continue;
        }
        const FaceNet net = layNet(surface.mesh(), surface.adjacency(), face);
        double worth = contrastOf(own) * evennessOf(net.centre);
        for (const auto& laid : net.across) {
            worth *= evennessOf(*laid);
        }
        if (worth > most) {
            most = worth;
            best = face;
        }
    }
    return best;
}

} // namespace

Status Stops::laidOutFace()
{
    const auto face = faceToShow(*m_window.document().surface(), m_window.document().texels());
    if (Status found = expect(face.has_value(), "the sample has a painted face between levels");
        !found) {
        return found;
    }
    auto* dock = m_window.findChild<QDockWidget*>("layoutPanel");
    m_input.keys(QKeySequence(Qt::SHIFT | Qt::Key_F3));
    m_window.resizeDocks({dock}, {kLayoutHeight}, Qt::Vertical);
    m_input.settle();
    m_window.viewport().frameFace(*face);
    ui::Inspection& inspection = m_window.inspection();
    inspection.letGo();
    inspection.pointAt(*face, {0.4F, 0.3F});
    auto* panel = m_window.findChild<ui::LayoutPanel*>();
    m_input.settle();
    // A texel of a neighbour under the pointer shows in the other views too.
    ui::LayoutView& net = panel->view(ui::LayoutKind::Net);
    const ui::SceneFace neighbour = net.scene()->faces.front();
    const auto spot =
        net.positionOf({neighbour.face, texelAt(neighbour.level, glm::dvec2(0.3, 0.3))});
    m_input.hover(net, spot->toPoint());
    const bool linked = inspection.texel()->place.face == neighbour.face;
    // And one that is clicked is held.
    const TexelPlace place{*face, texelAt(net.scene()->main().level, glm::dvec2(0.4, 0.35))};
    m_input.click(net, net.positionOf(place)->toPoint());
    const bool held = inspection.isHeld() && inspection.texel()->place == place;
    if (Status shown = expect(linked && held, "the layout dock points at texels and holds them");
        !shown) {
        return shown;
    }
    const Status taken = picture("layout");
    inspection.letGo();
    m_input.keys(QKeySequence(Qt::SHIFT | Qt::Key_F3));
    return taken;
}

} // namespace trixel::app
