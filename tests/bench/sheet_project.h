// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/io/project.h"
#include "tests/bench/sheet_mesh.h"

#include <random>
#include <utility>
#include <vector>

namespace trixel {

/// `sheetMesh(n)`, every face at one level, every texel noise: the same each time.
inline Project sheetProject(int n, Level level)
{
    TriangleMesh mesh = sheetMesh(n);
    NoProgress progress;
    Project project;
    std::mt19937 random(1);
    project.texels = TexelStore(static_cast<std::uint32_t>(mesh.faceCount()),
                                TexelFormat{},
                                level,
                                std::vector<std::byte>(3));
    for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
        for (std::byte& b : project.texels.writable(faceId(f))) {
            b = static_cast<std::byte>(random());
        }
    }
    project.surface = Surface::build(std::move(mesh), progress).value();
    return project;
}

} // namespace trixel
