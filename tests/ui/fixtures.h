// SPDX-License-Identifier: GPL-3.0-or-later
//
// What several tests of the window build on.
#pragma once

#include <QCoreApplication>
#include <QSettings>
#include <QTemporaryDir>

#include "core/io/new_project.h"

#include <cstdint>
#include <set>
#include <vector>

namespace trixel::ui {

/// A flat square of 2 · cells² triangles, from (0,0) to (1,1).
inline TriangleMesh gridMesh(int cells)
{
    TriangleMesh mesh;
    const auto step = 1.0F / static_cast<float>(cells);
    for (int y = 0; y <= cells; ++y) {
        for (int x = 0; x <= cells; ++x) {
            mesh.positions.emplace_back(
                static_cast<float>(x) * step, static_cast<float>(y) * step, 0.0F);
        }
    }
    const auto vertex = [cells](int x, int y) {
        return static_cast<std::uint32_t>(y * (cells + 1) + x);
    };
    for (int y = 0; y < cells; ++y) {
        for (int x = 0; x < cells; ++x) {
            mesh.triangles.push_back({vertex(x, y), vertex(x + 1, y), vertex(x, y + 1)});
            mesh.triangles.push_back({vertex(x + 1, y + 1), vertex(x, y + 1), vertex(x + 1, y)});
        }
    }
    return mesh;
}

/// The square at one level, uint8 RGB, light grey.
inline Project gridProject(int cells = 8, int level = 3)
{
    NoProgress progress;
    TriangleMesh mesh = gridMesh(cells);
    const LevelPlan plan = planUniform(mesh.faceCount(), Level(level));
    const std::vector<float> fill{0.8F, 0.8F, 0.8F};
    return newProject(std::move(mesh), plan, {}, fill, progress).value();
}

/// Every texel of every face, whether stored or constant.
inline std::vector<std::byte> allTexels(const TexelStore& texels)
{
    std::vector<std::byte> all;
    for (std::size_t k = 0; k < texels.faceCount(); ++k) {
        const FaceTexels& face = texels.face(faceId(k));
        for (std::size_t t = 0; t < face.level().texelCount(); ++t) {
            all.insert(all.end(), face.texel(t).begin(), face.texel(t).end());
        }
    }
    return all;
}

inline std::set<FaceId> facesThatDiffer(const TexelStore& a, const TexelStore& b)
{
    std::set<FaceId> faces;
    for (std::size_t k = 0; k < a.faceCount(); ++k) {
        if (!(a.face(faceId(k)) == b.face(faceId(k)))) {
            faces.insert(faceId(k));
        }
    }
    return faces;
}

/// Settings of their own for the time of a test.
class TemporarySettings
{
public:
    TemporarySettings()
    {
        QSettings::setDefaultFormat(QSettings::IniFormat);
        QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, m_folder.path());
        QCoreApplication::setOrganizationName("TrixelTest");
        QCoreApplication::setApplicationName("TrixelTest");
    }
    void clear() { QSettings().clear(); }

private:
    QTemporaryDir m_folder;
};

} // namespace trixel::ui
