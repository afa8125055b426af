// SPDX-License-Identifier: GPL-3.0-or-later
//
// A small surface on which faces of several levels meet, all painted, for tests of the layout.
#pragma once

#include "tests/ui/fixtures.h"
#include "ui/document/document.h"
#include "ui/document/face_selection.h"
#include "ui/document/inspection.h"
#include "ui/inspector/layout_panel.h"
#include "ui/viewport/view_settings.h"

#include <cmath>

namespace trixel::ui {

/// Smooth colours over the face, with a step that tells lower texels from upper ones.
inline FaceTexels paintedFace(Level level, double phase)
{
    std::vector<std::byte> bytes;
    for (std::uint32_t k = 0; k < level.texelCount(); ++k) {
        const TexelCoord texel = texelAt(level, static_cast<TexelIndex>(k));
        const glm::dvec2 at = centroid(level, texel);
        const double lift = texel.half == TexelHalf::Upper ? 18 : 0;
        for (const double wave : {0.0, 2.1, 4.2}) {
            const double value = 128 + 90 * std::sin(5 * at.x + 3 * at.y + wave + phase) + lift;
            bytes.push_back(static_cast<std::byte>(std::lround(std::clamp(value, 0.0, 255.0))));
        }
    }
    return FaceTexels::full(level, 3, bytes);
}

/// Six faces about a vertex, bent, at levels 1 to 4.
inline Project fanProject()
{
    TriangleMesh mesh;
    mesh.positions = {{0, 0, 0.4F},
                      {1, 0, 0},
                      {0.5F, 0.9F, 0.1F},
                      {-0.6F, 0.8F, 0},
                      {-1.1F, 0, -0.1F},
                      {-0.4F, -0.9F, 0},
                      {0.6F, -0.7F, 0.2F}};
    for (std::uint32_t k = 0; k < 6; ++k) {
        mesh.triangles.push_back({0, 1 + k, 1 + (k + 1) % 6});
    }
    NoProgress progress;
    const LevelPlan plan = planUniform(mesh.faceCount(), Level(3));
    const std::vector<float> fill{0.5F, 0.5F, 0.5F};
    Project project = newProject(std::move(mesh), plan, {}, fill, progress).value();
    const int levels[] = {3, 2, 4, 1, 3, 2};
    for (std::size_t k = 0; k < 6; ++k) {
        (void)project.texels.exchange(faceId(k),
                                      paintedFace(Level(levels[k]), 0.7 * static_cast<double>(k)));
    }
    return project;
}

/// A panel on an open document.
struct LayoutFixture
{
    explicit LayoutFixture(Project project = fanProject(), QSize size = {930, 360})
        : selection(document)
        , inspection(document)
        , panel(document, settings, inspection, selection)
    {
        document.open(std::move(project), {}, "fan");
        panel.resize(size);
        panel.show();
    }

    LayoutView& net() { return panel.view(LayoutKind::Net); }
    LayoutView& packed() { return panel.view(LayoutKind::Packed); }
    LayoutView& rows() { return panel.view(LayoutKind::Rectilinear); }

    Document document;
    FaceSelection selection;
    ViewSettings settings;
    Inspection inspection;
    LayoutPanel panel;
};

} // namespace trixel::ui
