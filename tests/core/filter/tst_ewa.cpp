// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filter/gaussian_window.h"
#include "tests/core/filter/golden_queries.h"
#include "tests/core/filter/irregular_mesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace trixel;
using namespace trixel::test;

namespace {

std::unique_ptr<const FilterMethod> method(std::string_view text)
{
    return makeMethod(*parseMethod(text));
}

double rms(const std::vector<Answer>& answers, const std::vector<Answer>& expected)
{
    double squares = 0;
    for (std::size_t i = 0; i < answers.size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
            const double error = answers[i].value[c] - expected[i].value[c];
            squares += error * error;
        }
    }
    return std::sqrt(squares / static_cast<double>(3 * answers.size()));
}

/// 8 by 8 cells of equilateral faces, all of one level.
FilterScene flatScene(int level, const TexelFunction& value)
{
    const TriangleMesh mesh = gridMesh(8);
    return sceneOf(FilterSurface::equilateral(buildAdjacency(mesh.triangles)),
                   storeOf(FaceMap<Level>(mesh.faceCount(), Level(level)), value));
}

/// An ellipse in a face near the middle, half axes in edges.
Query ellipseAt(std::mt19937& random, double major, double minor)
{
    std::uniform_real_distribution<double> unit(0, 1);
    const double angle = 6.283185307179586 * unit(random);
    const auto toUv = [](glm::dvec2 p) {
        const double v = p.y / std::sqrt(0.75);
        return glm::vec2(glm::dvec2(p.x - v / 2, v));
    };
    const glm::dvec2 along(std::cos(angle), std::sin(angle));
    const double u = unit(random);
    const std::size_t face = 2 * (8 * (3 + random() % 2) + 3 + random() % 2) + random() % 2;
    return {faceId(face),
            glm::vec2(glm::dvec2(u, (1 - u) * unit(random))),
            toUv(major * along),
            toUv(minor * glm::dvec2(-along.y, along.x))};
}

std::vector<Query> mixedEllipses(int level, std::size_t count)
{
    std::mt19937 random(11);
    std::uniform_real_distribution<double> unit(0, 1);
    std::vector<Query> queries;
    while (queries.size() < count) {
        const double minor = std::exp2(-2 + 5 * unit(random) - level);
        queries.push_back(ellipseAt(random, minor * std::exp2(3 * unit(random)), minor));
    }
    return queries;
}

} // namespace

TEST(GaussianWindow, isTheGaussianButForItsRim)
{
    double worst = 0;
    for (double x = 0; x <= 8; x += 1.0 / 512) {
        const float e = GaussianWindow::negativeExponential(static_cast<float>(x));
        worst = std::max(worst, std::abs(static_cast<double>(e) - std::exp(-x)));
    }
    EXPECT_LE(worst, 2e-6);
    const GaussianWindow window(3);
    for (double q = 0; q <= 9; q += 0.25) {
        EXPECT_NEAR(static_cast<double>(window.weight(static_cast<float>(q))),
                    std::exp(-q / 2) - std::exp(-4.5) * std::pow(q / 9, 4),
                    3e-6);
    }
    EXPECT_EQ(window.weight(9.1F), 0.0F);
}

TEST(GaussianWindow, hasTheVarianceThatItStates)
{
    for (const double cut : {2.5, 3.0, 3.5, 4.0}) {
        const GaussianWindow window(cut);
        // Radial sums of weight and of weight times half the squared distance.
        double mass = 0;
        double second = 0;
        constexpr double kStep = 1.0 / 4096;
        for (double r = kStep / 2; r < cut; r += kStep) {
            const double weight = static_cast<double>(window.weight(static_cast<float>(r * r)));
            mass += weight * r;
            second += weight * r * r * r / 2;
        }
        EXPECT_NEAR(second / mass, window.variance(), 4e-5) << cut;
    }
}

TEST(Ewa, comesNearerToExactTheMoreItReads)
{
    const FilterScene scene = flatScene(6, noise(3));
    const auto queries = mixedEllipses(6, 150);
    const auto expected = ask(*method("exact"), scene, queries);
    // Of white noise, the hardest content there is; bounds are about 1.3 times what was measured.
    const std::array<std::pair<std::string_view, double>, 6> bounds = {{{"ewa:0.5", 6e-3},
                                                                        {"ewa:0.7", 3e-3},
                                                                        {"ewa:1", 1e-3},
                                                                        {"ewa:2", 1e-3},
                                                                        {"ewa-blended:1", 2e-3},
                                                                        {"ewa-base", 2.5e-4}}};
    for (const auto& [name, bound] : bounds) {
        EXPECT_LE(rms(ask(*method(name), scene, queries), expected), bound) << name;
    }
}

TEST(Ewa, comesAsNearToExactOnCurvedMeshesOfMixedLevels)
{
    const TriangleMesh mesh = irregularSphere(2, 3);
    const FilterScene scene =
        sceneOf(surfaceOf(mesh), storeOf(randomLevels(mesh.faceCount(), 3, 5, 3), noise(3)));
    std::mt19937 random(3);
    std::uniform_real_distribution<double> unit(0, 1);
    std::vector<Query> queries;
    for (int k = 0; k < 300; ++k) {
        Query query = ellipseAt(random, 1, 1);
        const auto size = static_cast<float>(std::exp2(-4 * unit(random)));
        query.face = faceId(random() % mesh.faceCount());
        query.w1 *= size;
        query.w2 *= size * static_cast<float>(std::exp2(-4 * unit(random)));
        queries.push_back(query);
    }
    const auto expected = ask(*method("exact"), scene, queries);
    const std::array<std::pair<std::string_view, double>, 2> bounds = {
        {{"ewa:1", 3e-3}, {"ewa-base", 5e-4}}};
    for (const auto& [name, bound] : bounds) {
        const auto answers = ask(*method(name), scene, queries);
        EXPECT_LE(rms(answers, expected), bound) << name;
        for (std::size_t i = 0; i < answers.size(); ++i) {
            EXPECT_LE(difference(answers[i], expected[i]), 10 * bound) << name << " query " << i;
        }
    }
}

TEST(Ewa, takesTheVarianceOfMipsOff)
{
    // On v² a filter answers the centre's square plus its own variance: what mips add must be gone.
    const auto square = [](FaceId, glm::dvec2 uv, int) { return static_cast<float>(uv.y * uv.y); };
    const TriangleMesh mesh = gridMesh(1);
    const FilterScene scene = sceneOf(FilterSurface::equilateral(buildAdjacency(mesh.triangles)),
                                      storeOf(FaceMap<Level>(mesh.faceCount(), Level(8)), square));
    const Query query{faceId(0), {1.0F / 3, 1.0F / 3}, {0.09F, 0}, {0, 0.09F}};
    const Answer exact = ask(*method("exact"), scene, query);
    const Answer ewa = ask(*method("ewa:1"), scene, query);
    EXPECT_EQ(ewa.level, 5.0F);
    // Σ is 0.002; what a mip of level 5 adds to v² is 5e-5.
    EXPECT_NEAR(ewa.value[0], exact.value[0], 8e-6);
}

TEST(Ewa, keepsNaNsOutBeyondTheEndOfARow)
{
    // Texels are read four at a time, also where the next is no longer under the window.
    const auto value = [](FaceId, glm::dvec2 uv, int) {
        return uv.x < 0.5 && uv.y < 0.5 ? 0.5F : std::numeric_limits<float>::quiet_NaN();
    };
    const FilterScene scene = flatScene(6, value);
    std::size_t clean = 0;
    for (int k = 0; k < 200; ++k) {
        const float u = 0.05F + 0.4F * static_cast<float>(k) / 200;
        const Query query{faceId(60), {u, 0.25F}, {0.02F, -0.01F}, {0, 0.02F}};
        // What `exact` finds within six standard deviations the window has long left.
        if (std::isfinite(ask(*method("exact"), scene, query).value[0])) {
            EXPECT_NEAR(ask(*method("ewa-base"), scene, query).value[0], 0.5, 1e-6) << u;
            ++clean;
        }
    }
    EXPECT_GT(clean, 100U);
}

TEST(Ewa, keepsNaNsOutOfFacesOfFewTexels)
{
    // One in the middle of every face; the query is at a corner.
    const auto value = [](FaceId, glm::dvec2 uv, int) {
        return glm::length(uv - 1.0 / 3) > 0.01 ? 0.5F : std::numeric_limits<float>::quiet_NaN();
    };
    for (const int level : {2, 3}) {
        const FilterScene scene = flatScene(level, value);
        const Query query{faceId(60), {0.01F, 0.01F}, {}, {}};
        const Answer answer = ask(*method("ewa-base"), scene, query);
        EXPECT_NEAR(answer.value[0], 0.5, 1e-6) << "level " << level;
        EXPECT_GT(answer.taps, 6U);
        const Answer middle = ask(*method("ewa-base"), scene, {faceId(60), {0.3F, 0.3F}, {}, {}});
        EXPECT_TRUE(std::isnan(middle.value[0])) << "level " << level;
    }
}

TEST(Ewa, readsNoMoreThanItsCap)
{
    // Needles hold more texels than the lengths of their edges let expect.
    TriangleMesh mesh = gridMesh(24);
    for (glm::vec3& p : mesh.positions) {
        p.x *= 30.0F;
    }
    const FilterScene scene =
        sceneOf(surfaceOf(mesh), storeOf(randomLevels(mesh.faceCount(), 0, 3, 5), noise(5)));
    std::mt19937 random(5);
    for (const std::string_view name : {"ewa:0.5", "ewa:2", "ewa-blended:0.7", "ewa-blended:2"}) {
        for (int k = 0; k < 40; ++k) {
            const float size = std::exp2(-6.0F + static_cast<float>(random() % 17));
            const Query query{faceId(random() % mesh.faceCount()),
                              {0.3F, 0.3F},
                              {size, size},
                              {-size / static_cast<float>(1U << random() % 8U), 0}};
            EXPECT_LE(ask(*method(name), scene, query).taps, kMostTaps) << name;
        }
    }
}

TEST(EwaBlended, doesNotPop)
{
    // Noise shows a pop best: levels of it are least alike.
    const FilterScene scene = flatScene(7, noise(6));
    std::mt19937 random(6);
    for (const std::string_view name : {"ewa-blended:0.7", "ewa-blended"}) {
        double worst = 0;
        for (int place = 0; place < 2; ++place) {
            const std::mt19937 here = random;
            std::vector<Query> queries;
            for (double width = 1.0 / 128; width < 1; width *= 1.0002) {
                random = here;
                queries.push_back(ellipseAt(random, 2 * width, width));
            }
            const auto answers = ask(*method(name), scene, queries);
            for (std::size_t i = 1; i < answers.size(); ++i) {
                worst = std::max(worst, difference(answers[i - 1], answers[i]));
            }
        }
        EXPECT_LE(worst, 1e-3) << name;
    }
}

TEST(Ewa, keepsTheMeanOfBytes)
{
    // 64 texels wide: six reductions, of which the reference library truncates each and loses up
    // to 1.9 of 255.
    const TriangleMesh mesh = gridMesh(4);
    const TexelFormat format{TexelType::UInt8, 3, std::nullopt};
    const std::array<std::byte, 3> zero{};
    TexelStore store(static_cast<std::uint32_t>(mesh.faceCount()), format, Level(7), zero);
    std::mt19937 random(8);
    for (std::uint32_t f = 0; f < store.faceCount(); ++f) {
        for (std::byte& byte : store.writable(faceId(f))) {
            byte = static_cast<std::byte>(random() & 255U);
        }
    }
    const FilterScene scene =
        sceneOf(FilterSurface::equilateral(buildAdjacency(mesh.triangles)), store);
    std::vector<Query> queries;
    for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
        queries.push_back({faceId(f), {0.3F, 0.3F}, {0.5F, 0}, {-0.25F, 0.5F}});
    }
    const auto expected = ask(*method("exact"), scene, queries);
    for (const std::string_view name : {"ewa", "ewa-blended"}) {
        const auto answers = ask(*method(name), scene, queries);
        double drift = 0;
        for (std::size_t i = 0; i < answers.size(); ++i) {
            drift += (answers[i].value[0] - expected[i].value[0]) * 255;
            EXPECT_NEAR(answers[i].value[0] * 255, expected[i].value[0] * 255, 0.5) << name;
        }
        EXPECT_LE(std::abs(drift) / static_cast<double>(answers.size()), 0.1) << name;
    }
}
