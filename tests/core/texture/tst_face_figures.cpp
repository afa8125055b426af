// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texture/face_figures.h"
#include "core/texture/level_plan.h"
#include "tests/core/test_meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>

using namespace trixel;

namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

FaceTexels faceOf(const TexelFormat& format, Level level, std::span<const float> values)
{
    std::vector<std::byte> bytes(values.size() * byteSize(format.type));
    encode(format.type, values, bytes);
    return FaceTexels::full(level, format.texelBytes(), bytes);
}

TexelStore storeOf(const TexelFormat& format, std::uint32_t faces, Level level)
{
    const std::vector<std::byte> fill(format.texelBytes(), std::byte{1});
    return {faces, format, level, fill};
}

FaceFigures measured(const TriangleMesh& mesh, const TexelStore& store, ChannelChoice channel = {})
{
    NoProgress progress;
    return FaceFigures::measure(mesh, store, channel, Threads::all(), progress).value();
}

/// Says no at its n-th question.
class Impatient final : public Progress
{
public:
    explicit Impatient(int patience)
        : m_patience(patience)
    {
    }
    bool report(double /*fraction*/) override { return --m_patience >= 0; }

private:
    int m_patience;
};

} // namespace

TEST(FaceFigures, valuesAreThoseOfDecodedTexelsInEveryType)
{
    std::mt19937 random(7);
    std::uniform_real_distribution<float> any(0, 1);
    for (const TexelType type :
         {TexelType::UInt8, TexelType::UInt16, TexelType::Half, TexelType::Float}) {
        const TexelFormat format{type, 3, {}};
        std::vector<float> values(std::size_t{3} * 64);
        for (float& value : values) {
            value = any(random);
        }
        const FaceTexels face = faceOf(format, Level(3), values);
        std::vector<float> decoded(values.size());
        decode(type, face.bytes(), decoded);
        double sum = 0;
        for (const float value : decoded) {
            sum += static_cast<double>(value);
        }
        const FaceValues found = valuesOf(face, format, {});
        EXPECT_EQ(found.lowest, *std::ranges::min_element(decoded));
        EXPECT_EQ(found.highest, *std::ranges::max_element(decoded));
        EXPECT_NEAR(found.mean, sum / static_cast<double>(decoded.size()), 1e-6);
        EXPECT_FALSE(found.holdsNan);
    }
}

TEST(FaceFigures, oneChannelIsToldAloneAndOpacityOnlyWhenAskedFor)
{
    const TexelFormat format{TexelType::Float, 4, std::uint16_t{3}};
    const std::array<float, 16> values{
        1, 5, 3, 90, 2, 5, 3, 91, 3, 5, 3, 92, 4, 5, 3, 93}; // level 1
    const FaceTexels face = faceOf(format, Level(1), values);
    EXPECT_EQ(valuesOf(face, format, {}), (FaceValues{1, 5, (10 + 20 + 12) / 12.0F, false}));
    EXPECT_EQ(valuesOf(face, format, std::uint16_t{0}), (FaceValues{1, 4, 2.5F, false}));
    EXPECT_EQ(valuesOf(face, format, std::uint16_t{1}), (FaceValues{5, 5, 5, false}));
    EXPECT_EQ(valuesOf(face, format, std::uint16_t{3}), (FaceValues{90, 93, 91.5F, false}));
    const TexelFormat opacity{TexelType::Float, 1, std::uint16_t{0}};
    EXPECT_EQ(valuesOf(faceOf(opacity, Level(0), std::array{0.5F}), opacity, {}),
              (FaceValues{0.5F, 0.5F, 0.5F, false}));
}

TEST(FaceFigures, nanIsToldAndCountsForNothing)
{
    for (const TexelType type : {TexelType::Half, TexelType::Float}) {
        const TexelFormat format{type, 1, {}};
        const FaceValues some =
            valuesOf(faceOf(format, Level(1), std::array{kNan, -2.0F, 4.0F, kNan}), format, {});
        EXPECT_EQ(some, (FaceValues{-2, 4, 1, true}));
        const FaceValues none = valuesOf(faceOf(format, Level(0), std::array{kNan}), format, {});
        EXPECT_TRUE(std::isnan(none.lowest) && std::isnan(none.highest) && std::isnan(none.mean));
        EXPECT_TRUE(none.holdsNan);
        constexpr float kInfinite = std::numeric_limits<float>::infinity();
        const FaceValues infinite =
            valuesOf(faceOf(format, Level(1), std::array{kInfinite, 1.0F, 1.0F, 1.0F}), format, {});
        EXPECT_EQ(infinite.highest, kInfinite);
        EXPECT_EQ(infinite.mean, kInfinite);
        EXPECT_FALSE(infinite.holdsNan);
    }
}

TEST(FaceFigures, densityIsThatOfThePlan)
{
    TriangleMesh mesh = test::gridMesh(4);
    mesh.triangles.push_back({3, 3, 3}); // of no extent
    const LevelPlan plan = planByDensity(mesh, 100).value();
    for (std::size_t k = 0; k + 1 < mesh.faceCount(); ++k) {
        const float density = densityOf(mesh, faceId(k), plan.levels[faceId(k)]);
        EXPECT_GT(density, 100 / std::sqrt(2.0));
        EXPECT_LE(density, 100 * std::sqrt(2.0));
    }
    EXPECT_TRUE(std::isnan(densityOf(mesh, faceId(mesh.faceCount() - 1), Level(2))));
}

TEST(FaceFigures, measuringAllTellsOfEachFaceWhatItAloneTells)
{
    const TriangleMesh mesh = test::gridMesh(40); // 3200 faces, several blocks
    const TexelFormat format{TexelType::UInt8, 3, {}};
    TexelStore store = storeOf(format, static_cast<std::uint32_t>(mesh.faceCount()), Level(2));
    std::mt19937 random(11);
    for (int k = 0; k < 300; ++k) {
        const FaceId face = faceId(random() % mesh.faceCount());
        for (std::byte& byte : store.writable(face)) {
            byte = static_cast<std::byte>(random());
        }
    }
    const std::array<std::byte, 3> red{std::byte{255}, std::byte{0}, std::byte{0}};
    static_cast<void>(store.exchange(faceId(5), FaceTexels::constant(Level(7), red)));
    const FaceFigures figures = measured(mesh, store);
    ASSERT_EQ(figures.faceCount(), mesh.faceCount());
    for (std::size_t k = 0; k < mesh.faceCount(); ++k) {
        const FaceId face = faceId(k);
        const FaceFigure one = figureOf(mesh, face, store.face(face), format, {});
        EXPECT_EQ(figures.level(face), one.level);
        EXPECT_EQ(figures.isConstant(face), one.isConstant);
        EXPECT_EQ(figures.density(face), one.density);
        EXPECT_EQ(figures.lowest(face), one.values.lowest) << k;
        EXPECT_EQ(figures.highest(face), one.values.highest) << k;
        EXPECT_EQ(figures.mean(face), one.values.mean) << k;
        EXPECT_EQ(figures.bytes(face), store.face(face).bytes().size());
    }
}

TEST(FaceFigures, oneFaceIsBroughtUpToDateAlone)
{
    const TriangleMesh mesh = test::gridMesh(4);
    const TexelFormat format{TexelType::UInt8, 1, {}};
    TexelStore store = storeOf(format, static_cast<std::uint32_t>(mesh.faceCount()), Level(2));
    FaceFigures figures = measured(mesh, store);
    store.writable(faceId(3))[0] = std::byte{255};
    figures.set(faceId(3), figureOf(mesh, faceId(3), store.face(faceId(3)), format, {}));
    EXPECT_EQ(figures.highest(faceId(3)), 1.0F);
    EXPECT_FALSE(figures.isConstant(faceId(3)));
    EXPECT_EQ(figures.bytes(faceId(3)), 16U);
    EXPECT_TRUE(figures.isConstant(faceId(2)));
    EXPECT_EQ(figures.bytes(faceId(2)), 1U);
}

TEST(FaceFigures, cancellingEndsTheWork)
{
    const TriangleMesh mesh = test::gridMesh(300); // 180,000 faces: three parts
    const TexelStore store = storeOf({}, static_cast<std::uint32_t>(mesh.faceCount()), Level(1));
    for (int patience = 0; patience < 3; ++patience) {
        Impatient progress(patience);
        const auto figures = FaceFigures::measure(mesh, store, {}, Threads::all(), progress);
        ASSERT_FALSE(figures);
        EXPECT_EQ(figures.error().kind, ErrorKind::Cancelled);
    }
}
