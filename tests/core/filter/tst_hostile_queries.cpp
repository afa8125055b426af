// SPDX-License-Identifier: GPL-3.0-or-later
//
// Queries of any bit pattern on surfaces of any shape: every method answers each with a number and
// within its taps. The test asks a few thousand a method; TRIXEL_SOAK_QUERIES=10000000 and
// TRIXEL_SOAK_SEED=2 in the environment ask so many in all, others with each seed.
#include "core/filter/query_ellipse.h"
#include "tests/core/filter/filter_footprints.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cstdlib>
#include <gmock/gmock.h>
#include <iostream>
#include <limits>

namespace trixel::test {
namespace {

constexpr std::uint64_t kQuickQueries = 1000; // a method

std::uint64_t fromEnvironment(const char* name, std::uint64_t otherwise)
{
    const char* text = std::getenv(name);
    return text != nullptr ? std::strtoull(text, nullptr, 10) : otherwise;
}

std::uint64_t queriesPerMethod()
{
    return fromEnvironment("TRIXEL_SOAK_QUERIES", kQuickQueries * filterMethods().size()) /
           filterMethods().size();
}

/// Half of them any bit pattern, the others numbers at which something may happen.
float hostileFloat(Dice& dice)
{
    using Limits = std::numeric_limits<float>;
    static constexpr std::array<float, 16> kNumbers = {0,
                                                       -0.0F,
                                                       1,
                                                       0.5F,
                                                       1.0F / 3,
                                                       Limits::denorm_min(),
                                                       Limits::min(),
                                                       -1e-30F,
                                                       1e10F,
                                                       1e19F,
                                                       -1e30F,
                                                       Limits::max(),
                                                       Limits::lowest(),
                                                       Limits::infinity(),
                                                       -Limits::infinity(),
                                                       Limits::quiet_NaN()};
    switch (dice.below(4)) {
    case 0:
        return kNumbers[dice.below(kNumbers.size())];
    case 1:
        return static_cast<float>(dice.between(-0.1, 1.1));
    default:
        return std::bit_cast<float>(static_cast<std::uint32_t>(dice.bits()));
    }
}

QueryArrays hostileQueries(std::size_t faceCount, std::size_t count, Dice& dice)
{
    QueryArrays queries;
    for (std::size_t k = 0; k < count; ++k) {
        const FaceId face = faceId(dice.below(faceCount));
        std::array<float, 6> f{};
        for (float& number : f) {
            number = hostileFloat(dice);
        }
        queries.add(face, {f[0], f[1]}, {f[2], f[3]}, {f[4], f[5]});
    }
    return queries;
}

/// Two corners in one place make faces without area, one almost there makes needles.
TriangleMesh degenerateMesh()
{
    TriangleMesh mesh = subdivided(bipyramid(5));
    mesh.positions[2] = mesh.positions[7];
    mesh.positions[8] = mesh.positions[1] + glm::vec3(1e-6F, 0, 0);
    return mesh;
}

FilterScene sceneOnEquilateral(Adjacency adjacency, const FaceMap<Level>& levels)
{
    TriangleMesh anywhere; // positions only feed the content
    anywhere.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    anywhere.triangles.assign(adjacency.faceCount(), {0, 1, 2});
    NoProgress progress;
    auto scene = FilterScene::build(
        std::make_shared<FilterSurface>(FilterSurface::equilateral(std::move(adjacency))),
        filledStore(anywhere, levels, noiseContent(3), 3),
        Threads{1},
        progress);
    return std::move(*scene);
}

/// A face whose edges meet each other: a cone of one triangle, as a .ptx may have it.
FilterScene coneScene()
{
    Adjacency adjacency(1);
    adjacency.connect(faceId(0), LocalEdge::E0, faceId(0), LocalEdge::E2);
    return sceneOnEquilateral(std::move(adjacency), FaceMap<Level>(1, Level(3)));
}

/// Two faces, one the back of the other.
FilterScene pillowScene()
{
    Adjacency adjacency(2);
    adjacency.connect(faceId(0), LocalEdge::E0, faceId(1), LocalEdge::E0);
    adjacency.connect(faceId(0), LocalEdge::E1, faceId(1), LocalEdge::E2);
    adjacency.connect(faceId(0), LocalEdge::E2, faceId(1), LocalEdge::E1);
    FaceMap<Level> levels(2, Level(4));
    levels[faceId(1)] = Level(0);
    return sceneOnEquilateral(std::move(adjacency), levels);
}

FilterScene meshScene(TriangleMesh mesh, int low, int high, int channels)
{
    const auto levels = mixedLevels(mesh.faceCount(), low, high, 11);
    return makeScene(std::move(mesh), levels, noiseContent(5), channels).filter;
}

/// All with values from 0 to 1.
const std::vector<FilterScene>& hostileScenes()
{
    static const std::vector<FilterScene> kScenes = [] {
        std::vector<FilterScene> scenes;
        scenes.push_back(meshScene(closedIrregular(3, 1), 0, 4, 3));
        scenes.push_back(meshScene(closedIrregular(10, 2), 0, 3, 5));
        scenes.push_back(meshScene(bipyramid(40), 0, 3, 1));
        scenes.push_back(meshScene(degenerateMesh(), 0, 4, 1));
        scenes.push_back(meshScene(soupMesh(48, 3), 0, 5, 1)); // no neighbours at all
        scenes.push_back(meshScene(flatPatch(3), 2, 4, 4));
        scenes.push_back(coneScene());
        scenes.push_back(pillowScene());
        return scenes;
    }();
    return kScenes;
}

/// Methods that may read more than kMostTaps, or refuse.
bool readsAllOfTheBase(std::string_view method)
{
    return method == "exact" || method == "ewa-base";
}

struct Faults
{
    std::uint64_t notNumbers = 0;
    std::uint64_t beyondTheTexels = 0;
    std::uint64_t tooManyTaps = 0;
    std::uint64_t refused = 0;
    std::uint32_t mostTaps = 0;
};

void judge(std::string_view method, const ResultArrays& results, Faults& faults)
{
    for (const float value : results.values) {
        faults.notNumbers += std::isfinite(value) ? 0U : 1U;
        faults.beyondTheTexels += value < -1e-3F || value > 1 + 1e-3F ? 1U : 0U;
    }
    for (const std::uint32_t taps : results.taps) {
        if (taps == kRefusedTaps) {
            ++faults.refused;
            continue;
        }
        faults.mostTaps = std::max(faults.mostTaps, taps);
        faults.tooManyTaps += taps > kMostTaps && !readsAllOfTheBase(method) ? 1U : 0U;
    }
}

class HostileQueries : public testing::TestWithParam<std::string>
{
};

TEST_P(HostileQueries, getANumberWithinTheTaps)
{
    const auto method = standardMethod(*findMethod(GetParam()));
    Dice dice(fromEnvironment("TRIXEL_SOAK_SEED", 1));
    Faults faults;
    constexpr std::size_t kAtOnce = 125;
    std::uint64_t asked = 0;
    for (; asked < queriesPerMethod(); asked += kAtOnce) {
        const FilterScene& scene = hostileScenes()[asked / kAtOnce % hostileScenes().size()];
        const QueryArrays queries = hostileQueries(scene.faceCount(), kAtOnce, dice);
        judge(GetParam(), filtered(*method, scene, queries), faults);
    }
    EXPECT_EQ(faults.notNumbers, 0U);
    EXPECT_EQ(faults.beyondTheTexels, 0U);
    EXPECT_EQ(faults.tooManyTaps, 0U);
    EXPECT_TRUE(faults.refused == 0 || readsAllOfTheBase(GetParam()));
    if (std::getenv("TRIXEL_SOAK_QUERIES") != nullptr) {
        std::cout << GetParam() << ": " << asked << " queries, " << faults.refused
                  << " refused, most taps " << faults.mostTaps << '\n';
    }
}

TEST_P(HostileQueries, anyParameterKeepsWithinTheTaps)
{
    const MethodEntry& entry = *findMethod(GetParam());
    if (!entry.parameter) {
        return; // the test above asked all there is
    }
    Dice dice(7);
    Faults faults;
    for (const double parameter : {entry.parameter->least, entry.parameter->most}) {
        const auto method = makeMethod({GetParam(), parameter});
        for (const FilterScene& scene : hostileScenes()) {
            judge(GetParam(),
                  filtered(*method, scene, hostileQueries(scene.faceCount(), 4, dice)),
                  faults);
        }
    }
    EXPECT_EQ(faults.notNumbers + faults.beyondTheTexels + faults.tooManyTaps, 0U);
}

TEST_P(HostileQueries, aCentreThatIsNoNumberGivesTheFacesAverage)
{
    const auto method = standardMethod(*findMethod(GetParam()));
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float inf = std::numeric_limits<float>::infinity();
    for (const FilterScene& scene : hostileScenes()) {
        QueryArrays queries;
        queries.add(faceId(0), {nan, 0.2F}, {0.1F, 0}, {0, 0.1F});
        queries.add(faceId(0), {0.2F, -inf}, {0.1F, nan}, {0, 0.1F});
        const ResultArrays results = filtered(*method, scene, queries);
        for (std::size_t k = 0; k < 2; ++k) {
            EXPECT_FLOAT_EQ(results.values[k], scene.mips().average(faceId(0))[0]);
        }
    }
}

TEST_P(HostileQueries, aWidthThatIsNoNumberCountsAsTheWidest)
{
    const auto method = standardMethod(*findMethod(GetParam()));
    const FilterScene& scene = hostileScenes()[1];
    const float inf = std::numeric_limits<float>::infinity();
    QueryArrays queries;
    queries.add(faceId(2), {0.2F, 0.2F}, {inf, 0}, {0, 0.1F});
    queries.add(faceId(2), {0.2F, 0.2F}, {0.1F, 0}, {0, std::nanf("")});
    const ResultArrays results = filtered(*method, scene, queries);
    EXPECT_EQ(results.values[0], results.values[1]);
}

TEST_P(HostileQueries, aFootprintThatCostsTooMuchIsRefusedOrReadCoarser)
{
    // 302 million texels, stored as one.
    const TriangleMesh mesh = flatPatch(3);
    const TexelFormat format{TexelType::Float, 1, std::nullopt};
    const float value = 0.25F;
    TexelStore texels(static_cast<std::uint32_t>(mesh.faceCount()),
                      format,
                      Level(12),
                      std::as_bytes(std::span(&value, 1)));
    const TestScene scene = makeScene(mesh, std::move(texels));
    QueryArrays queries;
    queries.add(faceId(8), {0.2F, 0.2F}, {1e30F, 0}, {0, 1e30F});
    const ResultArrays results =
        filtered(*standardMethod(*findMethod(GetParam())), scene.filter, queries);
    EXPECT_FLOAT_EQ(results.values[0], value); // of the face's average, where refused
    EXPECT_TRUE(results.taps[0] <= kMostTaps ||
                (results.taps[0] == kRefusedTaps && readsAllOfTheBase(GetParam())))
        << results.taps[0];
}

/// Noise on a large flat patch with NaN in one texel of each level-5 face of its far corner, or in
/// a whole face stored as one value.
FilterScene sceneWithNaN(bool constantFace)
{
    TriangleMesh mesh = flatPatch(10);
    TexelStore texels =
        filledStore(mesh, FaceMap<Level>(mesh.faceCount(), Level(5)), noiseContent(9));
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const auto bytes = std::as_bytes(std::span(&nan, 1));
    if (constantFace) {
        texels.exchange(faceId(0), FaceTexels::constant(Level(5), bytes));
    } else {
        std::memcpy(texels.writable(faceId(0)).data(), &nan, sizeof nan);
    }
    return makeScene(std::move(mesh), std::move(texels)).filter;
}

TEST_P(HostileQueries, aNaNTexelFarAwayDoesNotLeak)
{
    // Its corner of the patch is the origin. Sixteen standard deviations and two level-0 faces are
    // far: there a coarse texel that it spoiled is out of reach of the coarse look-ups, too.
    constexpr double kFarSigmas = 16;
    constexpr double kFarEdges = 2;
    const auto method = standardMethod(*findMethod(GetParam()));
    for (const bool constantFace : {false, true}) {
        const FilterScene scene = sceneWithNaN(constantFace);
        const TriangleMesh mesh = flatPatch(10);
        Dice dice(3);
        QueryArrays queries;
        while (queries.size() < 300) {
            const FaceId face = faceId(dice.below(mesh.faceCount()));
            const glm::dvec2 uv = randomPoint(dice);
            const Footprint footprint = planeFootprint(scene.surface().shape(face),
                                                       dice.logBetween(0.01, 0.3),
                                                       dice.logBetween(1, 8),
                                                       dice.between(0, 3));
            const QueryEllipse ellipse = queryEllipse(scene, face, uv, footprint.w1, footprint.w2);
            const glm::vec3 p =
                pointAt(mesh.corners(face), static_cast<float>(uv.x), static_cast<float>(uv.y));
            if (double{glm::length(p)} > kFarSigmas * ellipse.majorSigma + kFarEdges) {
                add(queries, face, uv, footprint);
            }
        }
        for (const float value : filtered(*method, scene, queries).values) {
            EXPECT_FALSE(std::isnan(value));
        }
    }
}

std::vector<std::string> allMethods()
{
    std::vector<std::string> names;
    for (const MethodEntry& method : filterMethods()) {
        names.emplace_back(method.name);
    }
    return names;
}

INSTANTIATE_TEST_SUITE_P(All,
                         HostileQueries,
                         testing::ValuesIn(allMethods()),
                         [](const testing::TestParamInfo<std::string>& method) {
                             std::string name = method.param;
                             std::ranges::replace(name, '-', '_');
                             return name;
                         });

} // namespace
} // namespace trixel::test
