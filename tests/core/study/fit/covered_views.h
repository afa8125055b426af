// SPDX-License-Identifier: GPL-3.0-or-later
//
// Random views that a scene's cameras cover, most of them as close as they may come.
#pragma once

#include "core/study/fit/fit.h"
#include "core/study/views/view_queries.h"

#include <glm/geometric.hpp>
#include <random>
#include <vector>

namespace trixel::test {

class CoveredViews
{
public:
    CoveredViews(const Surface& surface, const SceneViews& scene, std::uint32_t seed)
        : m_surface(surface)
        , m_scene(scene)
        , m_random(seed)
    {
    }

    /// From any side, at any place of the mesh, through lenses of 10 to 70 degrees, in pictures of
    /// 100 to 500 pixels. Shows at least kFewestPixels pixels of the mesh.
    ViewCamera next()
    {
        while (true) {
            ViewCamera view = aim();
            const glm::dvec3 away = view.position - view.target;
            double near = 0;
            double far = 1;
            while (!isCoveredAt(view, far * away)) {
                far *= 2;
            }
            for (int k = 0; k < 12; ++k) {
                const double middle = (near + far) / 2;
                (isCoveredAt(view, middle * away) ? far : near) = middle;
            }
            // Half of them touch the limit.
            const double back = m_unit(m_random) < 0.5 ? 1.0 : 1.0 + m_unit(m_random);
            view.position = view.target + far * back * away;
            if (pixels(view) >= kFewestPixels && isCovered(m_surface, m_scene, view, {3, 1})) {
                return view;
            }
        }
    }

private:
    ViewCamera aim()
    {
        std::normal_distribution<double> normal;
        const glm::dvec3 from =
            glm::normalize(glm::dvec3(normal(m_random), normal(m_random), normal(m_random)));
        const auto face = static_cast<std::size_t>(
            m_unit(m_random) * static_cast<double>(m_surface.mesh().faceCount()));
        ViewCamera view;
        view.target = glm::dvec3(m_surface.mesh().corners(faceId(face))[0]);
        view.position = view.target + from * static_cast<double>(m_surface.size());
        view.up = {normal(m_random), normal(m_random), normal(m_random)};
        view.fovY = 10 + 60 * m_unit(m_random);
        view.width = 100 + static_cast<int>(400 * m_unit(m_random));
        view.height = 100 + static_cast<int>(400 * m_unit(m_random));
        return view;
    }

    bool isCoveredAt(ViewCamera view, glm::dvec3 offset) const
    {
        view.position = view.target + offset;
        return isCovered(m_surface, m_scene, view, {8, 0});
    }

    std::size_t pixels(const ViewCamera& view) const
    {
        NoProgress progress;
        return 16 * viewQueries(m_surface, view, {4, 0}, Threads{1}, progress)->size();
    }

    const Surface& m_surface;
    const SceneViews& m_scene;
    std::mt19937 m_random;
    std::uniform_real_distribution<double> m_unit{0, 1};
};

} // namespace trixel::test
