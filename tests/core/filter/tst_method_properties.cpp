// SPDX-License-Identifier: GPL-3.0-or-later
//
// The table of properties: every method is held to what it claims, and seen to fail what it does
// not, so that the table is neither too proud nor too modest.
#include "tests/core/filter/filter_footprints.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <gmock/gmock.h>
#include <limits>

namespace trixel::test {
namespace {

/// How far results are off.
struct Deviation
{
    double worst = 0;
    double squares = 0;
    std::size_t count = 0;

    void add(double error)
    {
        // Whatever is not a number is the worst.
        worst = std::isnan(error) ? std::numeric_limits<double>::infinity()
                                  : std::max(worst, std::abs(error));
        squares += error * error;
        ++count;
    }
    double rms() const { return std::sqrt(squares / static_cast<double>(count)); }
};

/// What "in the mean" means: with its parameter at its most, a method's rms deviation is at most
/// this (fraction of the value range).
constexpr double kInTheMean = 0.01;

void compare(const ResultArrays& a, const ResultArrays& b, Deviation& deviation)
{
    for (std::size_t k = 0; k < a.values.size(); ++k) {
        deviation.add(double{a.values[k]} - double{b.values[k]});
    }
}

/// Closed meshes of valence 3 to 10, levels 0 to 6 at random, noise.
const std::vector<TestScene>& irregularScenes()
{
    static const std::vector<TestScene> kScenes = [] {
        std::vector<TestScene> scenes;
        for (std::uint32_t valence = 3; valence <= 10; ++valence) {
            TriangleMesh mesh = closedIrregular(valence, valence);
            const auto levels = mixedLevels(mesh.faceCount(), 0, 6, valence);
            scenes.push_back(makeScene(std::move(mesh), levels, noiseContent(valence)));
        }
        return scenes;
    }();
    return kScenes;
}

/// The same with the vertices of every face in another order.
const std::vector<RotatedScene>& rotatedScenes()
{
    static const std::vector<RotatedScene> kScenes = [] {
        std::vector<RotatedScene> scenes;
        for (const TestScene& scene : irregularScenes()) {
            scenes.push_back(rotatedScene(scene, 4));
        }
        return scenes;
    }();
    return kScenes;
}

constexpr std::array<float, 4> kConstants = {1.0F, 1.0F / 3, -123456.7F, 3e-20F};

const std::vector<TestScene>& constantScenes()
{
    static const std::vector<TestScene> kScenes = [] {
        std::vector<TestScene> scenes;
        for (const float value : kConstants) {
            TriangleMesh mesh = closedIrregular(5, 1);
            const auto levels = mixedLevels(mesh.faceCount(), 0, 6, 1);
            scenes.push_back(makeScene(std::move(mesh), levels, constantContent(value)));
        }
        return scenes;
    }();
    return kScenes;
}

class MethodProperties : public testing::TestWithParam<std::string>
{
protected:
    MethodChoice choice() const { return *parseMethod(GetParam()); }
    const MethodEntry& entry() const { return *findMethod(choice().name); }
    const MethodClaims& claims() const { return entry().claims; }

    /// With the standard parameter, or the most where the claim is about the mean.
    std::unique_ptr<const FilterMethod> method(Claim claim) const
    {
        if (claim == Claim::InTheMean) {
            return makeMethod({choice().name, entry().parameter->most});
        }
        return makeMethod(choice());
    }

    /// So many queries, or an eighth where each is that much work.
    static std::size_t queriesFor(Claim claim, std::size_t count)
    {
        return claim == Claim::InTheMean ? count / 8 : count;
    }

    /// The claim, whichever it is, must be what was measured. With another parameter than the
    /// standard one a method may well keep what it does not claim.
    void expectClaim(Claim claim, const Deviation& deviation, double bound) const
    {
        ASSERT_GT(deviation.count, 0U);
        // Figures for those who ask with --gtest_output=xml:FILE.
        RecordProperty("worst", std::to_string(deviation.worst * 1e6) + " ppm");
        RecordProperty("rms", std::to_string(deviation.rms() * 1e6) + " ppm");
        switch (claim) {
        case Claim::Yes:
            EXPECT_LE(deviation.worst, bound) << "claimed";
            break;
        case Claim::No:
            EXPECT_TRUE(deviation.worst > bound || choice().parameter)
                << "not claimed, but " << deviation.worst << " is within " << bound;
            break;
        case Claim::InTheMean:
            EXPECT_LE(deviation.rms(), kInTheMean) << "claimed in the mean";
            EXPECT_GT(deviation.worst, bound) << "claimed in the mean only, but it holds";
            break;
        }
    }
};

TEST_P(MethodProperties, constantKept)
{
    Deviation deviation; // fraction of the value
    const auto filter = method(claims().constantKept);
    for (std::size_t k = 0; k < kConstants.size(); ++k) {
        const float value = kConstants[k];
        const TestScene& scene = constantScenes()[k];
        const ResultArrays results = filtered(*filter, scene.filter, randomQueries(scene, 300, 2));
        for (const float result : results.values) {
            deviation.add(double{result} / double{value} - 1);
        }
    }
    expectClaim(claims().constantKept, deviation, 1e-6);
}

TEST_P(MethodProperties, affineKeptAtTheCentre)
{
    // A gradient of 1 over the width of the patch; footprints stay off its border.
    const std::uint32_t n = 8;
    static const TestScene scene =
        makeScene(flatPatch(n), Level(5), affineContent({1.0 / 12, 1.0 / 12, 0}, 0));
    QueryArrays queries;
    Dice dice(7);
    while (queries.size() < queriesFor(claims().affineKept, 400)) {
        const FaceId face = faceId(2 * n * 3 + dice.below(4 * n));
        const glm::dvec2 uv = randomPoint(dice);
        const std::size_t column = indexOf(face) / 2 % n;
        if (column >= 3 && column <= 4) {
            add(queries, face, uv, randomFootprint(scene, face, dice, {0.25, 8, 4}));
        }
    }
    Deviation deviation;
    const ResultArrays results = filtered(*method(claims().affineKept), scene.filter, queries);
    for (std::size_t k = 0; k < queries.size(); ++k) {
        const glm::dvec3 p = positionOf(scene, queries, k);
        deviation.add(double{results.values[k]} - (p.x + p.y) / 12);
    }
    // A Gaussian narrower than a texel of its level is sampled too coarsely for that: ewa with a
    // parameter below 1.
    const double sigma = choice().name.starts_with("ewa") ? choice().parameter.value_or(1) : 1;
    const double bound = sigma < 0.5 ? 1e-3 : sigma < 1 ? 5e-4 : 1e-5;
    expectClaim(claims().affineKept, deviation, bound);
}

/// Points that are on no texel's border and footprints that rotate without rounding.
QueryArrays exactlyRotatable(const QueryArrays& queries)
{
    // Odd multiples of 2^-13, also of w = 1 - u - v when the sum is even; and 2^-20.
    const auto point = [](float x) { return (2 * std::floor(x * 4095) + 1) / 8192; };
    const auto vector = [](float x) { return std::round(x * 1048576) / 1048576; };
    QueryArrays result;
    for (std::size_t k = 0; k < queries.size(); ++k) {
        const glm::vec2 uv(point(queries.u[k]), point(queries.v[k]));
        // w is an even multiple of 2^-13: kept off the borders of 1/64ths.
        const float w = 1 - uv.x - uv.y;
        if (!(w > 0) || w * 64 == std::floor(w * 64)) {
            continue;
        }
        result.add(queries.face[k],
                   uv,
                   {vector(queries.uw1[k]), vector(queries.vw1[k])},
                   {vector(queries.uw2[k]), vector(queries.vw2[k])});
    }
    return result;
}

TEST_P(MethodProperties, rotationOfVertexOrderChangesNothing)
{
    Deviation deviation;
    const auto filter = method(claims().rotationFree);
    for (std::size_t k = 0; k < irregularScenes().size(); ++k) {
        const TestScene& scene = irregularScenes()[k];
        const RotatedScene& rotated = rotatedScenes()[k];
        const QueryArrays queries =
            exactlyRotatable(randomQueries(scene, queriesFor(claims().rotationFree, 60), 3));
        compare(filtered(*filter, scene.filter, queries),
                filtered(*filter, rotated.scene.filter, rotated.rotated(queries)),
                deviation);
    }
    expectClaim(claims().rotationFree, deviation, 1e-6);
}

TEST_P(MethodProperties, sameFromBothSidesOfAnEdge)
{
    Deviation deviation;
    const auto filter = method(claims().edgeContinuous);
    for (const TestScene& scene : irregularScenes()) {
        const EdgePairs pairs = edgePairs(scene, queriesFor(claims().edgeContinuous, 100), 5);
        compare(filtered(*filter, scene.filter, pairs.here),
                filtered(*filter, scene.filter, pairs.there),
                deviation);
    }
    expectClaim(claims().edgeContinuous, deviation, 1e-5);
}

TEST_P(MethodProperties, sameForEveryPairOfVectorsOfAnEllipse)
{
    using Change = QueryArrays (*)(const QueryArrays&);
    const Change swapped = [](const QueryArrays& queries) {
        QueryArrays result = queries;
        std::swap(result.uw1, result.uw2);
        std::swap(result.vw1, result.vw2);
        return result;
    };
    const Change negated = [](const QueryArrays& queries) {
        QueryArrays result = queries;
        for (std::size_t k = 0; k < queries.size(); ++k) {
            result.uw1[k] = -result.uw1[k];
            result.vw1[k] = -result.vw1[k];
        }
        return result;
    };
    // Any rotation of the two among themselves leaves W1 W1ᵀ + W2 W2ᵀ.
    const Change turned = [](const QueryArrays& queries) {
        QueryArrays result = queries;
        for (std::size_t k = 0; k < queries.size(); ++k) {
            const double angle = 0.1 + static_cast<double>(k);
            const glm::dvec2 w1(queries.uw1[k], queries.vw1[k]);
            const glm::dvec2 w2(queries.uw2[k], queries.vw2[k]);
            const glm::vec2 a(std::cos(angle) * w1 + std::sin(angle) * w2);
            const glm::vec2 b(std::cos(angle) * w2 - std::sin(angle) * w1);
            result.uw1[k] = a.x;
            result.vw1[k] = a.y;
            result.uw2[k] = b.x;
            result.vw2[k] = b.y;
        }
        return result;
    };
    Deviation deviation;
    const auto filter = method(claims().footprintFree);
    for (const TestScene& scene : irregularScenes()) {
        const QueryArrays queries = randomQueries(scene, queriesFor(claims().footprintFree, 40), 6);
        const ResultArrays results = filtered(*filter, scene.filter, queries);
        for (const Change change : {swapped, negated, turned}) {
            compare(results, filtered(*filter, scene.filter, change(queries)), deviation);
        }
    }
    expectClaim(claims().footprintFree, deviation, 1e-5);
}

/// Follows a result over a sweep of one number and finds the largest change over a step of 0.02 %:
/// where it changes by more than the bound over a longer step, that step is halved.
class PoppingSweep
{
public:
    PoppingSweep(const FilterMethod& method,
                 bool isRandom,
                 const TestScene& scene,
                 FaceId face,
                 glm::dvec2 uv)
        : m_method(method)
        , m_isRandom(isRandom)
        , m_scene(scene)
        , m_face(face)
        , m_uv(uv)
    {
    }

    /// At one anisotropy, until the footprint is as long as an edge of the mesh. A longer one
    /// reaches around these closed meshes, where an unfolding has to lay a face on this side or
    /// on that.
    void overWidths(double anisotropy, Deviation& deviation)
    {
        sweep(1.0 / 256, 1 / anisotropy, deviation, [=](double x) {
            return std::pair(x, anisotropy);
        });
    }
    void overAnisotropies(double across, Deviation& deviation)
    {
        sweep(1, 1 / across, deviation, [=](double x) { return std::pair(across, x); });
    }

private:
    static constexpr double kStep = 2e-4; // in the logarithm
    static constexpr double kBound = 1e-3;

    template <class Shape>
    void sweep(double low, double high, Deviation& deviation, const Shape& shape)
    {
        if (m_isRandom) {
            sample(low, high, deviation, shape);
            return;
        }
        const auto at = [&](double logarithm) {
            const auto [across, anisotropy] = shape(std::exp(logarithm));
            return value(across, anisotropy);
        };
        constexpr double kLongStep = kStep * 256;
        double begin = std::log(low);
        double from = at(begin);
        while (begin < std::log(high)) {
            const double to = at(begin + kLongStep);
            narrow(at, begin, kLongStep, from, to, deviation);
            from = to;
            begin += kLongStep;
        }
    }

    /// Steps of 0.02 % here and there, for what is random.
    template <class Shape>
    void sample(double low, double high, Deviation& deviation, const Shape& shape)
    {
        for (double x = std::log(low); x < std::log(high); x += 0.3) {
            const auto [across, anisotropy] = shape(std::exp(x));
            const auto [across2, anisotropy2] = shape(std::exp(x + kStep));
            deviation.add(value(across2, anisotropy2) - value(across, anisotropy));
        }
    }

    template <class At>
    void
    narrow(const At& at, double begin, double step, double from, double to, Deviation& deviation)
    {
        if (std::abs(to - from) <= kBound) {
            deviation.add(0);
            return;
        }
        if (step < 1.5 * kStep) {
            deviation.add(to - from);
            return;
        }
        const double middle = at(begin + step / 2);
        narrow(at, begin, step / 2, from, middle, deviation);
        narrow(at, begin + step / 2, step / 2, middle, to, deviation);
    }

    /// \param across  in edges of the mesh
    double value(double across, double anisotropy) const
    {
        const double edge = std::exp2(m_scene.surface->log2Length(m_face, m_uv));
        QueryArrays query;
        add(query,
            m_face,
            m_uv,
            planeFootprint(m_scene.surface->shape(m_face), across * edge, anisotropy, 0.4));
        return double{filtered(m_method, m_scene.filter, query).values[0]};
    }

    const FilterMethod& m_method;
    bool m_isRandom;
    const TestScene& m_scene;
    FaceId m_face;
    glm::dvec2 m_uv;
};

TEST_P(MethodProperties, noPoppingWhenTheFootprintChanges)
{
    // On the finest faces, where there are most levels to pop between.
    Deviation deviation;
    const auto filter = method(claims().levelContinuous);
    Dice dice(8);
    for (const std::size_t valence : {3U, 5U, 8U}) {
        const TestScene& scene = irregularScenes()[valence - 3];
        FaceId face{};
        for (std::uint32_t f = 0; f < scene.mesh.faceCount(); ++f) {
            face = scene.filter.level(faceId(f)) > scene.filter.level(face) ? faceId(f) : face;
        }
        const bool isRandom = claims().levelContinuous == Claim::InTheMean;
        PoppingSweep sweep(*filter, isRandom, scene, face, randomPoint(dice));
        sweep.overWidths(1, deviation);
        sweep.overWidths(1.5, deviation);
        sweep.overWidths(6, deviation);
        sweep.overAnisotropies(1.0 / 32, deviation);
    }
    expectClaim(claims().levelContinuous, deviation, 1e-3);
}

/// Noise in bytes on a flat patch of 512 texels a side, all of it one value on average.
const TestScene& byteNoise()
{
    static const TestScene kScene = [] {
        TriangleMesh mesh = flatPatch(4);
        const FaceMap<Level> levels(mesh.faceCount(), Level(7));
        const TexelFormat bytes{TexelType::UInt8, 1, std::nullopt};
        const std::byte zero{};
        TexelStore texels(bytes, levels, std::span(&zero, 1));
        for (std::uint32_t f = 0; f < mesh.faceCount(); ++f) {
            std::uint64_t k = f * 65536;
            for (std::byte& texel : texels.writable(faceId(f))) {
                texel = static_cast<std::byte>(mixed(k++) & 0xFFU);
            }
        }
        return makeScene(std::move(mesh), std::move(texels));
    }();
    return kScene;
}

/// 64 texels wide, about the middle of the patch; fewer are the first of more.
QueryArrays wideQueries(std::size_t count)
{
    Dice dice(5);
    QueryArrays queries;
    while (queries.size() < count) {
        const FaceId face = faceId(10 + dice.below(2) + 8 * dice.below(2));
        add(queries, face, randomPoint(dice), planeFootprint(FaceShape(), 0.5, 1, 0));
    }
    return queries;
}

TEST_P(MethodProperties, theMeanOfBytesDoesNotDrift)
{
    // On average within half a unit of the last place: rounding once a level would lose one to two.
    if (choice().name == "point") {
        return; // has no mean
    }
    const TestScene& scene = byteNoise();
    constexpr std::size_t kCount = 120;
    static const ResultArrays kExact =
        filtered(*makeMethod({"exact", std::nullopt}), scene.filter, wideQueries(kCount));
    const std::size_t count = queriesFor(claims().footprintFree, kCount);
    const auto filter = method(claims().footprintFree);
    const ResultArrays results = filtered(*filter, scene.filter, wideQueries(count));
    double drift = 0;
    for (std::size_t k = 0; k < count; ++k) {
        drift += double{results.values[k]} - double{kExact.values[k]};
    }
    EXPECT_NEAR(255 * drift / static_cast<double>(count), 0, 0.5);
}

/// Every method, and with it every parameter that the chart measures; where a claim is about the
/// mean, the parameter is chosen by the test.
std::vector<std::string> allMethods()
{
    std::vector<std::string> names;
    for (const MethodEntry& method : filterMethods()) {
        const std::string name(method.name);
        names.push_back(name);
        if (!method.parameter || method.claims.footprintFree == Claim::InTheMean) {
            continue;
        }
        for (const double value : method.parameter->curve) {
            names.push_back(toText({name, value}));
        }
    }
    return names;
}

INSTANTIATE_TEST_SUITE_P(All,
                         MethodProperties,
                         testing::ValuesIn(allMethods()),
                         [](const testing::TestParamInfo<std::string>& method) {
                             std::string name = method.param;
                             std::ranges::replace(name, '-', '_');
                             std::ranges::replace(name, ':', '_');
                             std::ranges::replace(name, '.', '_');
                             return name;
                         });

} // namespace
} // namespace trixel::test
