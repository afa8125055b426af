// SPDX-License-Identifier: GPL-3.0-or-later
//
// Every instruction set gives the same answers, the one without registers of many values too.
#include "core/filter/filter_method.h"
#include "core/filter/probe_simd.h"
#include "tests/core/filter/random_scene.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace trixel;
using namespace trixel::test;

TEST(ProbeTargets, agreeWithTheScalarPath)
{
    Random random(23);
    const TriangleMesh mesh = randomClosedMesh(random);
    const FilterScene scene =
        sceneOf(mesh, noiseStore(random, randomLevels(random, mesh.faceCount(), 0, 6), 6));
    QueryArrays queries;
    for (int k = 0; k < 5000; ++k) {
        const auto face = faceId(static_cast<std::size_t>(unit(random) * double(mesh.faceCount())));
        const double length = std::exp2(1 - 12 * unit(random)); // down to magnified texels
        const double angle = 6.3 * unit(random);
        const glm::dvec2 along(std::cos(angle), std::sin(angle));
        const double other = length * std::exp2(-4 * unit(random));
        queries.add(face,
                    glm::dvec2(unit(random), unit(random)) * 0.5,
                    length * along,
                    other * glm::dvec2(-along.y, along.x));
    }
    for (const double band : {0.25, 1.0}) {
        const ProbeSettings settings = probeSettings(64, band);
        std::vector<ResultArrays> results;
        const std::vector<std::int64_t> targets = probeTargets();
        ASSERT_GE(targets.size(), 2U) << "nothing to compare";
        for (const std::int64_t target : targets) {
            results.emplace_back(queries.size(), scene.channels());
            filterByProbesOn(target, scene, queries.queries(), settings, results.back().results());
        }
        for (std::size_t t = 1; t < targets.size(); ++t) {
            for (std::size_t k = 0; k < results[0].values.size(); ++k) {
                ASSERT_NEAR(results[t].values[k], results[0].values[k], 1e-6F) << t;
            }
            EXPECT_EQ(results[t].taps, results[0].taps);
        }
    }
}
