// SPDX-License-Identifier: GPL-3.0-or-later
//
// Random views that a scene's views cover, most of them as close as they may come.
#pragma once

#include "core/study/fit/fit.h"
#include "core/study/views/seen_faces.h"
#include "core/study/views/view_queries.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <random>
#include <vector>

namespace trixel::test {

/// Makes views at random, as close as listed cameras that frame the same, and keeps those that are
/// covered: they show nothing that is hidden from all listed cameras.
class CoveredViews
{
public:
    /// By the angle between the view's direction to its target and that of the nearest listed
    /// camera, in steps of 15 degrees.
    struct Tally
    {
        std::size_t tried = 0;
        std::size_t covered = 0;
    };
    static constexpr double kTallyDegrees = 15;

    CoveredViews(const Surface& surface, const SceneViews& scene, std::uint32_t seed)
        : m_surface(surface)
        , m_scene(scene)
        , m_random(seed)
    {
    }

    /// Of any place of the mesh that listed views see, from up to 90 degrees beside a listed camera
    /// (from any side where the scene has views of a distance), through lenses of 10 to 70 degrees,
    /// in pictures of 64 to 500 pixels. Shows at least kFewestPixels pixels of the mesh.
    ViewCamera next()
    {
        while (true) {
            const ViewCamera view = tried();
            Tally& tally = m_tally[binOf(view)];
            ++tally.tried;
            // Most that are not covered tell at a few pixels.
            if (isCovered(m_surface, m_scene, view, {12, 2}) &&
                isCovered(m_surface, m_scene, view, {3, 1})) {
                ++tally.covered;
                return view;
            }
        }
    }

    /// As close and as large as those, but not covered: shows something that the scene's views do
    /// not see.
    ViewCamera nextUncovered()
    {
        while (true) {
            const ViewCamera view = tried();
            if (!isCovered(m_surface, m_scene, view, {12, 2})) {
                return view;
            }
        }
    }

    const std::array<Tally, 6>& tallies() const { return m_tally; }

private:
    /// A view of enough pixels that is no closer anywhere than listed cameras that frame the same.
    ViewCamera tried()
    {
        while (true) {
            ViewCamera view = aim();
            const glm::dvec3 away = view.position - view.target;
            double near = 0;
            double far = 1;
            while (far < kFarthest && isTooClose(view, far * away)) {
                far *= 2;
            }
            if (!(far < kFarthest)) {
                continue;
            }
            for (int k = 0; k < 12; ++k) {
                const double middle = (near + far) / 2;
                (isTooClose(view, middle * away) ? near : far) = middle;
            }
            // Half of them touch the limit.
            const double back = m_unit(m_random) < 0.5 ? 1.0 : 1.0 + m_unit(m_random);
            view.position = view.target + far * back * away;
            if (pixels(view) >= kFewestPixels) {
                return view;
            }
        }
    }

    ViewCamera aim()
    {
        ViewCamera view;
        view.target = target();
        view.position =
            view.target + directionTo(view.target) * static_cast<double>(m_surface.size());
        view.up = anyDirection();
        view.fovY = 10 + 60 * m_unit(m_random);
        view.width = side();
        view.height = side();
        return view;
    }

    glm::dvec3 target()
    {
        while (true) {
            const auto face = static_cast<std::size_t>(
                m_unit(m_random) * static_cast<double>(m_surface.mesh().faceCount()));
            const glm::dvec3 point(m_surface.mesh().corners(faceId(face))[0]);
            const auto isSeen = [&](const ViewCamera& camera) {
                return sees(m_surface, camera, point);
            };
            if (!m_scene.distant.empty() || std::ranges::any_of(m_scene.cameras, isSeen)) {
                return point;
            }
        }
    }

    glm::dvec3 anyDirection()
    {
        std::normal_distribution<double> normal;
        return glm::normalize(glm::dvec3(normal(m_random), normal(m_random), normal(m_random)));
    }

    glm::dvec3 directionTo(glm::dvec3 target)
    {
        if (!m_scene.distant.empty()) {
            return anyDirection();
        }
        const auto k = static_cast<std::size_t>(m_unit(m_random) *
                                                static_cast<double>(m_scene.cameras.size()));
        const glm::dvec3 listed = glm::normalize(m_scene.cameras[k].position - target);
        const glm::dvec3 beside = glm::normalize(glm::cross(listed, anyDirection()));
        const double angle = m_unit(m_random) * std::numbers::pi / 2;
        return std::cos(angle) * listed + std::sin(angle) * beside;
    }

    /// Small pictures are more likely to show only what is seen: as many of each size.
    int side() { return static_cast<int>(64 * std::pow(500.0 / 64, m_unit(m_random))); }

    /// Whether a point is seen closer than by any listed view that frames it, whatever hides it.
    bool isTooClose(ViewCamera view, glm::dvec3 offset) const
    {
        view.position = view.target + offset;
        NoProgress progress;
        const auto seen = viewQueries(m_surface, view, {8, 0}, Threads{1}, progress);
        const QueryArrays& q = seen->queries;
        for (std::size_t i = 0; i < q.size(); ++i) {
            const glm::dvec3 point(pointAt(m_surface.mesh().corners(q.face[i]), q.u[i], q.v[i]));
            if (view.unitsPerPixel(point) * (1 + 1e-6) < m_scene.finestSpacing(point, 1e-3)) {
                return true;
            }
        }
        return false;
    }

    std::size_t binOf(const ViewCamera& view) const
    {
        double cosine = m_scene.cameras.empty() ? 1 : -1;
        for (const ViewCamera& listed : m_scene.cameras) {
            cosine = std::max(cosine,
                              glm::dot(glm::normalize(listed.position - view.target),
                                       glm::normalize(view.position - view.target)));
        }
        const double degrees = std::acos(std::clamp(cosine, -1.0, 1.0)) * 180 / std::numbers::pi;
        return std::min(static_cast<std::size_t>(degrees / kTallyDegrees), m_tally.size() - 1);
    }

    std::size_t pixels(const ViewCamera& view) const
    {
        NoProgress progress;
        return 16 * viewQueries(m_surface, view, {4, 0}, Threads{1}, progress)->size();
    }

    static constexpr double kFarthest = 1e6;

    const Surface& m_surface;
    const SceneViews& m_scene;
    std::mt19937 m_random;
    std::uniform_real_distribution<double> m_unit{0, 1};
    std::array<Tally, 6> m_tally{};
};

} // namespace trixel::test
