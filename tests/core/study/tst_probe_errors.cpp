// SPDX-License-Identifier: GPL-3.0-or-later
//
// How far the probe methods are off on the stored distribution: what the figures of
// tests/bench/README.md say must stay true.
#include "core/filter/filter_method.h"
#include "core/filter/query_ellipse.h"
#include "core/study/test_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace trixel {
namespace {

class ProbeErrors : public testing::Test
{
protected:
    /// Both contents on large faces, which are quicker to build.
    static const std::array<TestScene, 2>& scenes()
    {
        static const std::array<TestScene, 2> kScenes = [] {
            const TestData data = parseTestData(storedTestFiles()).value();
            NoProgress progress;
            const auto scene = [&](TestContent content) {
                const TestPatch patch(kAllQueriesTiles, TestFaces::Large);
                return buildTestScene(data, content, patch, Threads{2}, progress).value();
            };
            return std::array{scene(TestContent::Natural), scene(TestContent::HardEdged)};
        }();
        return kScenes;
    }

    /// RMS over both contents, of queries below a width in texels, fraction of the value range.
    static double rmsOf(const MethodChoice& choice, double below = 1e9)
    {
        double squares = 0;
        std::size_t count = 0;
        for (const TestScene& scene : scenes()) {
            ResultArrays results(scene.queries.size(), 3);
            const FilterQueries queries = scene.queries.queries();
            makeMethod(choice)->filter(scene.scene, queries, results.results());
            for (std::size_t k = 0; k < results.values.size(); ++k) {
                const auto ellipse = queryEllipse(scene.scene, queries, k % scene.queries.size());
                if (2 * ellipse.minorSigma < below * std::exp2(ellipse.log2Texel)) {
                    const double error = double(results.values[k]) - double(scene.exact[k]);
                    squares += error * error;
                    ++count;
                }
            }
        }
        return std::sqrt(squares / static_cast<double>(count));
    }
};

TEST_F(ProbeErrors, fewProbesAreWithinAPercent)
{
    EXPECT_LT(rmsOf({"probes-1", 24}), 0.01);
    EXPECT_LT(rmsOf({"probes-2", 32}), 0.0078);
}

TEST_F(ProbeErrors, manyProbesAreCloserThanTheReferenceLoopThatSeesTheWholeFootprint)
{
    EXPECT_LT(rmsOf({"probes-2", 128}), rmsOf({"reference-loop", 26}));
    EXPECT_LT(rmsOf({"probes-2", 128}), 0.0054);
}

TEST_F(ProbeErrors, moreProbesAreNeverWorse)
{
    for (const char* name : {"probes-1", "probes-2"}) {
        double before = 1;
        for (const double probes : findMethod(name)->parameter->curve) {
            const double rms = rmsOf({name, probes});
            EXPECT_LT(rms, before) << name << ' ' << probes;
            before = rms;
        }
    }
}

TEST_F(ProbeErrors, magnifiedTexelsAreSharp)
{
    // Vertex averages alone are 1.2 % off there.
    EXPECT_LT(rmsOf({"probes-2", 128}, 1.2), 0.006);
}

} // namespace
} // namespace trixel
