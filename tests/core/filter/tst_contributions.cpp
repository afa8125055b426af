// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the footprint dock colours texels by: the weights that a method gives them.
#include "core/filter/contributions.h"
#include "core/filter/query_filter.h"
#include "core/texture/mips.h"
#include "tests/core/filter/random_scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <tuple>

namespace trixel {
namespace {

using test::Random;
using test::unit;

struct Subject
{
    TriangleMesh mesh;
    TexelStore store;
    std::shared_ptr<const FilterScene> scene;
};

Subject mixedSubject(unsigned seed)
{
    Random random(seed);
    Subject subject;
    subject.mesh = test::randomClosedMesh(random);
    subject.store =
        test::noiseStore(random, test::randomLevels(random, subject.mesh.faceCount(), 0, 4), 3);
    subject.scene = std::make_shared<const FilterScene>(test::sceneOf(subject.mesh, subject.store));
    return subject;
}

QueryArrays randomQuery(Random& random, const FilterScene& scene)
{
    QueryArrays query;
    double a = unit(random);
    double b = unit(random);
    if (a + b > 1) {
        a = 1 - a;
        b = 1 - b;
    }
    const double width = 0.6 * unit(random) * unit(random);
    const double angle = 6.3 * unit(random);
    const double longer = width * (1 + 7 * unit(random));
    query.add(faceId(static_cast<std::size_t>(unit(random) * double(scene.faceCount()))),
              {a, b},
              glm::vec2(longer * std::cos(angle), longer * std::sin(angle)),
              glm::vec2(-width * std::sin(angle), width * std::cos(angle)));
    return query;
}

ContributionMeter meterOf(const std::shared_ptr<const FilterScene>& scene)
{
    NoProgress progress;
    return std::move(*ContributionMeter::build(scene, Threads{1}, progress));
}

/// Σ weight × value, those that stand for several texels by their mean.
std::array<double, 3> weighted(const Contributions& contributions, const TexelStore& store)
{
    std::array<double, 3> sum{};
    for (const Contribution& one : contributions.texels) {
        const FaceTexels& own = store.face(one.face);
        const FaceTexels face = reduced(store.format(), own, own.level().log2() - one.level.log2());
        std::array<float, 3> values{};
        decode(TexelType::Float, face.texel(indexOf(texelIndex(one.level, one.texel))), values);
        for (std::size_t c = 0; c < 3; ++c) {
            sum[c] += one.weight * static_cast<double>(values[c]);
        }
    }
    return sum;
}

/// Reads one texel and nothing else; refuses W1 above 10.
class OneTexel final : public FilterMethod
{
public:
    explicit OneTexel(TexelIndex index)
        : m_index(index)
    {
    }
    void filter(const FilterScene& scene,
                const FilterQueries& queries,
                const FilterResults& results) const override
    {
        filterEach(scene,
                   queries,
                   results,
                   [&](const QueryEllipse&, FaceId face, int group, GroupValue& value) {
                       if (queries.uw1[0] > 10) {
                           return QueryCost{0, kRefusedTaps};
                       }
                       const LevelTexels texels =
                           scene.mips().texels(face, scene.level(face), group);
                       std::copy_n(texels.texel(m_index), kGroupChannels, value.begin());
                       return QueryCost{0, 1};
                   });
    }

private:
    TexelIndex m_index;
};

TEST(Contributions, weightsOfEveryMethodSumToOneAndGiveItsAnswer)
{
    const Subject subject = mixedSubject(7);
    ContributionMeter meter = meterOf(subject.scene);
    NoProgress progress;
    Random random(11);
    for (const MethodEntry& entry : filterMethods()) {
        const auto method = makeMethod({std::string(entry.name), std::nullopt});
        for (int k = 0; k < 4; ++k) {
            const QueryArrays query = randomQuery(random, *subject.scene);
            const auto found = meter.measure(*method, query.queries(), {}, progress);
            ASSERT_TRUE(found) << entry.name << ": " << found.error().message;
            EXPECT_NEAR(found->sum, 1, 1e-5) << entry.name;
            EXPECT_EQ(found->joined, 0) << entry.name;

            ResultArrays results(1, 3);
            method->filter(*subject.scene, query.queries(), results.results());
            const auto sum = weighted(*found, subject.store);
            for (std::size_t c = 0; c < 3; ++c) {
                EXPECT_NEAR(sum[c], static_cast<double>(results.values[c]), 1e-5)
                    << entry.name << " query " << k;
            }
        }
    }
}

TEST(Contributions, heaviestComeFirstAndNoTexelTwice)
{
    const Subject subject = mixedSubject(3);
    ContributionMeter meter = meterOf(subject.scene);
    NoProgress progress;
    Random random(5);
    const auto exact = makeMethod({"exact", std::nullopt});
    const auto found =
        meter.measure(*exact, randomQuery(random, *subject.scene).queries(), {}, progress);
    ASSERT_TRUE(found);
    std::map<std::tuple<std::uint32_t, std::size_t>, int> times;
    for (std::size_t k = 0; k < found->texels.size(); ++k) {
        const Contribution& one = found->texels[k];
        EXPECT_EQ(one.level, subject.scene->level(one.face));
        EXPECT_EQ(++times[std::tuple(static_cast<std::uint32_t>(one.face),
                                     indexOf(texelIndex(one.level, one.texel)))],
                  1);
        EXPECT_TRUE(k == 0 || one.weight <= found->texels[k - 1].weight);
    }
}

TEST(Contributions, methodThatReadsOneTexelHasOneWeight)
{
    const Subject subject = mixedSubject(9);
    ContributionMeter meter = meterOf(subject.scene);
    NoProgress progress;
    for (std::size_t f = 0; f < subject.scene->faceCount(); ++f) {
        const FaceId face = faceId(f);
        const Level level = subject.scene->level(face);
        const auto index = static_cast<TexelIndex>((7 * f) % level.texelCount());
        QueryArrays query;
        query.add(face, {0.3F, 0.3F}, {0.1F, 0}, {0, 0.1F});
        const auto found = meter.measure(OneTexel(index), query.queries(), {}, progress);
        ASSERT_TRUE(found);
        ASSERT_EQ(found->texels.size(), 1U);
        EXPECT_EQ(found->texels[0], (Contribution{face, level, texelAt(level, index), 1.0}));
    }
}

TEST(Contributions, doNotDependOnWhatWasAskedBefore)
{
    const Subject subject = mixedSubject(21);
    NoProgress progress;
    Random random(4);
    const auto method = makeMethod({"probes-2", std::nullopt});
    ContributionMeter meter = meterOf(subject.scene);
    for (int k = 0; k < 8; ++k) {
        const QueryArrays query = randomQuery(random, *subject.scene);
        const auto used = meter.measure(*method, query.queries(), {}, progress);
        const auto fresh = meterOf(subject.scene).measure(*method, query.queries(), {}, progress);
        ASSERT_TRUE(used && fresh);
        EXPECT_EQ(used->texels, fresh->texels);
    }
}

TEST(Contributions, beyondTheLimitTexelsAreJoinedAndTheSumStays)
{
    const Subject subject = mixedSubject(7);
    ContributionMeter meter = meterOf(subject.scene);
    NoProgress progress;
    QueryArrays query;
    query.add(faceId(3), {0.3F, 0.3F}, {0.8F, 0}, {0, 0.8F});
    const auto exact = makeMethod({"exact", std::nullopt});
    const auto all = meter.measure(*exact, query.queries(), {}, progress);
    ASSERT_TRUE(all);
    ASSERT_GT(all->texels.size(), 200U);
    ContributionLimits limits;
    limits.mostTexels = 100;
    const auto few = meter.measure(*exact, query.queries(), limits, progress);
    ASSERT_TRUE(few);
    EXPECT_LE(few->texels.size(), 100U);
    EXPECT_GT(few->joined, 0);
    EXPECT_NEAR(few->sum, 1, 1e-5);
    // A joined weight is that of the texels under it.
    std::map<std::uint32_t, double> byFace;
    for (const Contribution& one : all->texels) {
        byFace[static_cast<std::uint32_t>(one.face)] += one.weight;
    }
    for (const Contribution& one : few->texels) {
        byFace[static_cast<std::uint32_t>(one.face)] -= one.weight;
    }
    for (const auto& [face, left] : byFace) {
        EXPECT_NEAR(left, 0, 1e-5) << face;
    }
}

TEST(Contributions, errorsNameWhatIsTooLarge)
{
    const Subject subject = mixedSubject(7);
    ContributionMeter meter = meterOf(subject.scene);
    NoProgress progress;
    const auto exact = makeMethod({"exact", std::nullopt});
    QueryArrays query;
    query.add(faceId(3), {0.3F, 0.3F}, {0.8F, 0}, {0, 0.8F});
    ContributionLimits limits;
    limits.mostFaces = 2;
    auto refused = meter.measure(*exact, query.queries(), limits, progress);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().message,
              "The footprint reaches more than 2 faces: too many to weigh their texels.");
    limits = {};
    limits.mostAddressed = 10;
    refused = meter.measure(*exact, query.queries(), limits, progress);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().message,
              "The faces under the footprint hold more than 10 texels: too many to weigh them.");

    QueryArrays wide;
    wide.add(faceId(3), {0.3F, 0.3F}, {20.0F, 0}, {0, 20.0F});
    refused = meter.measure(OneTexel(TexelIndex{}), wide.queries(), {}, progress);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().message, "The method refuses a footprint that is so wide.");
}

TEST(Contributions, endWhenCancelled)
{
    class Never final : public Progress
    {
        bool report(double) override { return false; }
    };
    const Subject subject = mixedSubject(7);
    ContributionMeter meter = meterOf(subject.scene);
    Never never;
    QueryArrays query;
    query.add(faceId(3), {0.3F, 0.3F}, {0.8F, 0}, {0, 0.8F});
    const auto found =
        meter.measure(*makeMethod({"exact", std::nullopt}), query.queries(), {}, never);
    ASSERT_FALSE(found);
    EXPECT_EQ(found.error().kind, ErrorKind::Cancelled);
}

TEST(Contributions, fitScenesOfTheSameLevelsWhateverTheirTexels)
{
    const Subject subject = mixedSubject(7);
    const ContributionMeter meter = meterOf(subject.scene);
    EXPECT_TRUE(meter.fits(*subject.scene));
    FilterScene painted = *subject.scene;
    TexelStore store = subject.store;
    store.writable(faceId(0));
    painted.update(store, std::array{TouchedRect{faceId(0), 0, 0, 1, 1, true}});
    EXPECT_TRUE(meter.fits(painted));
    const std::array<float, 3> grey{0.5F, 0.5F, 0.5F};
    const Level other(store.face(faceId(0)).level().log2() == 2 ? 3 : 2);
    store.exchange(faceId(0), FaceTexels::constant(other, std::as_bytes(std::span(grey))));
    painted.update(store, std::array{TouchedRect{faceId(0), 0, 0, 1, 1, true}});
    EXPECT_FALSE(meter.fits(painted));
}

} // namespace
} // namespace trixel
