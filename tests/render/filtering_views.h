// SPDX-License-Identifier: GPL-3.0-or-later
//
// Views of the torus and the bunny that ways of filtering are judged by.
#pragma once

#include <QTest>

#include "tests/render/filtering_scenes.h"
#include "tests/render/offscreen.h"

#include <memory>
#include <optional>

namespace trixel::render {

inline constexpr int kSide = 192;

inline const char* nameOf(Filtering filtering)
{
    switch (filtering) {
    case Filtering::Texels:
        return "texels";
    case Filtering::LowerHalf:
        return "lower-half";
    case Filtering::PackedAtlas:
        return "packed-atlas";
    case Filtering::Seamless:
        return "seamless";
    case Filtering::Anisotropic:
        break;
    }
    return "anisotropic";
}

struct Shown
{
    std::shared_ptr<const Surface> surface;
    TexelStore store;
    Scene scene;
};

inline Scene sceneOf(const Surface& surface, int side, CameraPose pose)
{
    Scene scene;
    scene.camera.setViewport(side, side);
    scene.camera.setScene(surface.low(), surface.high());
    scene.camera.frame(surface.low(), surface.high());
    CameraPose framed = scene.camera.pose();
    framed.yaw = pose.yaw;
    framed.pitch = pose.pitch;
    framed.distance *= pose.distance;
    scene.camera.setPose(framed);
    scene.surface.lit = false;
    return scene;
}

/// 672 faces whose neighbours may be four levels apart.
inline Shown torus(int side = kSide)
{
    Shown shown;
    shown.surface = surfaceOf(torusMesh(24, 14));
    const TriangleMesh& mesh = shown.surface->mesh();
    shown.store = solidStore(mesh, mixedLevels(mesh.faceCount(), 1, 5, 7), 3);
    shown.scene = sceneOf(*shown.surface, side, {{}, 1.0, 0.4, 0.75});
    return shown;
}

/// The bunny as if someone had painted it: levels change from region to region.
inline std::optional<Shown> bunny(int side = kSide)
{
    NoProgress progress;
    auto mesh = readMesh("/usr/share/glmark2/models/bunny.obj", progress);
    if (!mesh) {
        return std::nullopt;
    }
    Shown shown;
    shown.surface = surfaceOf(std::move(*mesh));
    shown.store = solidStore(shown.surface->mesh(), bandedLevels(shown.surface->mesh(), 1, 3), 3);
    shown.scene = sceneOf(*shown.surface, side, {{}, 1.0, 0.3, 0.2});
    return shown;
}

/// Tests that draw such views, each in a context of its own.
class FilteringTest : public QObject
{
protected:
    void begin()
    {
        m_offscreen = std::make_unique<Offscreen>(kSide, kSide);
        QVERIFY2(m_offscreen->isValid(), "OpenGL 4.1 core is needed");
        m_offscreen->bind();
        m_gl = currentGl();
    }
    void end()
    {
        QVERIFY(!m_offscreen->hadErrors());
        m_gl.reset();
        m_offscreen.reset();
    }

    std::unique_ptr<Offscreen> m_offscreen;
    std::unique_ptr<Gl> m_gl;
};

} // namespace trixel::render
