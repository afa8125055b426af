// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a window has that streams to the card, without the window.
#pragma once

#include "render/residency.h"
#include "tests/render/offscreen.h"
#include "tests/ui/fixtures.h"
#include "ui/viewport/card_streaming.h"

#include <array>
#include <cmath>
#include <memory>
#include <random>

namespace trixel::ui {

inline constexpr std::uint64_t kMiB = 1U << 20U;
inline constexpr double kFrameMs = 4;

/// A square of 2 · cells² faces, each of one colour of its own in every texel but noise in the last
/// bits: every level of it looks the same, whatever is shown.
inline Project noisyProject(int cells, int level)
{
    Project project = gridProject(cells, level);
    std::mt19937 random(1);
    for (std::size_t f = 0; f < project.texels.faceCount(); ++f) {
        const auto color = static_cast<std::uint32_t>(random());
        std::size_t k = 0;
        for (std::byte& b : project.texels.writable(faceId(f))) {
            const std::uint32_t part = 64 + (color >> (8 * (k++ % 3)) & 0x7fU);
            b = static_cast<std::byte>(part ^ (random() & 1U));
        }
    }
    return project;
}

inline int farthest(const QImage& a, const QImage& b)
{
    int most = 0;
    for (int y = 0; y < a.height(); ++y) {
        for (int x = 0; x < a.width(); ++x) {
            const QRgb p = a.pixel(x, y);
            const QRgb q = b.pixel(x, y);
            most = std::max({most,
                             std::abs(qRed(p) - qRed(q)),
                             std::abs(qGreen(p) - qGreen(q)),
                             std::abs(qBlue(p) - qBlue(q))});
        }
    }
    return most;
}

/// What a window has, without the window.
struct StreamingView
{
    StreamingView(Project shown, std::uint64_t budget)
        : project(std::move(shown))
        , offscreen(500, 400)
    {
        offscreen.bind();
        renderer = std::move(*render::Renderer::create());
        renderer->setCardBudget(budget);
        (void)renderer->setMesh(project.surface->mesh());
        renderer->setTexels(project.texels, 0);
        streaming.setSurface(project.surface);
        scene.surface.lit = false;
        scene.camera.setViewport(500, 400);
        scene.camera.setScene(project.surface->low(), project.surface->high());
    }

    /// What `Viewport` does where a way of filtering is chosen.
    void filter(render::Filtering filtering)
    {
        offscreen.bind();
        scene.surface.filtering = filtering;
        renderer->wantFilterings(std::array{filtering});
        streaming.showTexels(render::readsTexels(filtering));
        if (!filterMesh) {
            filterMesh = std::make_shared<const render::FilterMesh>(
                project.surface->mesh(), project.surface->adjacency(), project.texels);
            renderer->setFilterMesh(filterMesh);
            streaming.setFilterMesh(filterMesh);
        }
    }

    void frame(double milliseconds = kFrameMs)
    {
        offscreen.bind();
        (void)streaming.send(
            *renderer, scene.camera, project.texels, render::Side::A, milliseconds);
    }

    void finish()
    {
        offscreen.bind();
        streaming.finish(*renderer, scene.camera, project.texels, render::Side::A);
    }

    Project project;
    render::Offscreen offscreen;
    std::unique_ptr<render::Renderer> renderer;
    render::Scene scene;
    std::shared_ptr<const render::FilterMesh> filterMesh;
    CardStreaming streaming;
};

/// Around, close and away.
inline render::CameraPose poseAt(double t)
{
    render::CameraPose pose;
    pose.target = {0.5 + 0.4 * std::sin(5 * t), 0.5 + 0.4 * std::cos(3 * t), 0};
    pose.distance = 0.06 + 1.5 * std::pow(std::cos(4 * t), 2);
    pose.yaw = 0.4 * std::sin(7 * t);
    pose.pitch = 0.3;
    return pose;
}

} // namespace trixel::ui
