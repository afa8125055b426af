// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/resample/transfer_paint.h"
#include "tests/core/cancel_after.h"
#include "tests/core/filter/test_scenes.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>

using namespace trixel;
using namespace trixel::test;

namespace {

struct Painted
{
    std::shared_ptr<const Surface> surface;
    TexelStore texels;

    Painted(const TriangleMesh& mesh, Level level, const Content& content, int channels = 1)
        : texels(filledStore(mesh, FaceMap<Level>(mesh.faceCount(), level), content, channels))
    {
        NoProgress progress;
        surface = *Surface::build(mesh, progress);
    }
    TransferScene scene() const
    {
        NoProgress progress;
        return {*FilterScene::build(std::make_shared<const FilterSurface>(FilterSurface::fromMesh(
                                        surface->mesh(), surface->adjacency())),
                                    texels,
                                    Threads{1},
                                    progress)};
    }
};

double valueAt(const TexelStore& texels, FaceId face, std::uint32_t k)
{

    float value = 0;
    decode(texels.format().type, texels.face(face).texel(k), std::span(&value, 1));
    return double(value);
}

TransferOptions within(float distance)
{
    TransferOptions options;
    options.maxDistance = distance;
    return options;
}

/// From a fine mesh to a coarse one of other faces over the same square: paint that is affine in
/// space arrives as it was, to within the texels' own blur at borders.
TEST(TransferPaint, affinePaintArrivesOnOtherFaces)
{
    const Content slope = affineContent({0.3, 0.5, 0}, 0.1);
    const Painted from(jittered(gridMesh(9), 0.02F, 3, true), Level(3), slope);
    const Painted to(gridMesh(4), Level(3), constantContent(0));
    NoProgress progress;
    const auto transfer =
        transferPaint(*from.surface, from.scene(), *to.surface, to.texels, within(1), progress);
    ASSERT_TRUE(transfer);
    EXPECT_EQ(transfer->reached, transfer->total);
    int compared = 0;
    for (std::uint32_t f = 0; f < to.texels.faceCount(); ++f) {
        const auto corners = to.surface->mesh().corners(faceId(f));
        for (std::uint32_t k = 0; k < 64; ++k) {
            const glm::vec2 uv(centroid(Level(3), texelAt(Level(3), TexelIndex(k))));
            const glm::vec3 at = pointAt(corners, uv.x, uv.y);
            if (std::min(at.x, at.y) > 0.1F && std::max(at.x, at.y) < 0.9F) {
                ++compared;
                EXPECT_NEAR(valueAt(transfer->texels, faceId(f), k),
                            0.1 + 0.3 * double(at.x) + 0.5 * double(at.y),
                            2e-3);
            }
        }
    }
    EXPECT_GT(compared, 1000);
}

/// Fine checks under large texels average out: the footprint is the texel's own.
TEST(TransferPaint, largeTexelsAverageWhatLiesUnderThem)
{
    const Painted from(gridMesh(8), Level(4), checkerContent(1.0 / 64));
    const Painted to(gridMesh(2), Level(1), constantContent(0));
    NoProgress progress;
    const auto transfer =
        transferPaint(*from.surface, from.scene(), *to.surface, to.texels, within(1), progress);
    ASSERT_TRUE(transfer);
    for (std::uint32_t f = 0; f < to.texels.faceCount(); ++f) {
        for (std::uint32_t k = 0; k < 4; ++k) {
            EXPECT_NEAR(valueAt(transfer->texels, faceId(f), k), 0.5, 0.06);
        }
    }
}

/// White paint on the left of the square, grey that nothing shows on the right: means stay white.
TEST(TransferPaint, whatNothingShowsLendsNoColour)
{
    const TexelFormat format{TexelType::UInt8, 2, std::uint16_t{1}};
    const TriangleMesh fine = gridMesh(16);
    const std::array unseen{std::byte{77}, std::byte{0}};
    TexelStore paint(format, FaceMap<Level>(fine.faceCount(), Level(0)), unseen);
    for (std::uint32_t f = 0; f < fine.faceCount(); ++f) {
        const auto corners = fine.corners(faceId(f));
        if (corners[0].x + corners[1].x + corners[2].x < 1.4F) {
            paint.exchange(faceId(f),
                           FaceTexels::constant(Level(0), std::vector(2, std::byte{255})));
        }
    }
    NoProgress progress;
    const auto from = *Surface::build(fine, progress);
    const Painted to(gridMesh(3), Level(2), constantContent(0), 2);
    const auto scene = transferScene(*from, paint, {}, Threads{1}, progress);
    ASSERT_TRUE(scene);
    const auto transfer = transferPaint(*from, *scene, *to.surface, to.texels, within(1), progress);
    ASSERT_TRUE(transfer);
    int mixed = 0;
    for (std::uint32_t f = 0; f < to.texels.faceCount(); ++f) {
        for (std::uint32_t k = 0; k < 16; ++k) {
            std::array<float, 2> value{};
            decode(
                transfer->texels.format().type, transfer->texels.face(faceId(f)).texel(k), value);
            EXPECT_NEAR(value[0], value[1] > 0 ? 1 : 0, 1e-5) << f << ", " << k;
            mixed += value[1] > 0.05F && value[1] < 0.95F ? 1 : 0;
        }
    }
    EXPECT_GT(mixed, 5);
}

TEST(TransferPaint, whatIsTooFarKeepsItsTexelsAndItsBytes)
{
    const Painted from(gridMesh(2), Level(2), constantContent(1));
    TriangleMesh mesh = gridMesh(2);
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        mesh.positions[v].z = mesh.positions[v].x > 0.9F ? 5.0F : 0.1F; // the right side is far
    }
    const Painted to(mesh, Level(2), noiseContent(3));
    NoProgress progress;
    const auto transfer =
        transferPaint(*from.surface, from.scene(), *to.surface, to.texels, within(0.2F), progress);
    ASSERT_TRUE(transfer);
    EXPECT_GT(transfer->reached, 0U);
    EXPECT_LT(transfer->reached, transfer->total);
    std::uint64_t changed = 0;
    for (std::uint32_t f = 0; f < to.texels.faceCount(); ++f) {
        const auto corners = to.surface->mesh().corners(faceId(f));
        for (std::uint32_t k = 0; k < 16; ++k) {
            const glm::vec2 uv(centroid(Level(2), texelAt(Level(2), TexelIndex(k))));
            const bool isNear = pointAt(corners, uv.x, uv.y).z <= 0.2F;
            changed += isNear ? 1 : 0;
            EXPECT_EQ(valueAt(transfer->texels, faceId(f), k),
                      isNear ? 1.0 : valueAt(to.texels, faceId(f), k));
        }
    }
    EXPECT_EQ(changed, transfer->reached);
    const auto none =
        transferPaint(*from.surface, from.scene(), *to.surface, to.texels, within(0.01F), progress);
    EXPECT_EQ(none->reached, 0U);
    EXPECT_TRUE(none->texels.face(faceId(0)).sharesBytesWith(to.texels.face(faceId(0))));
}

TEST(TransferPaint, channelsThatThePaintLacksStay)
{
    const Painted from(gridMesh(2), Level(1), constantContent(1), 1);
    const Painted to(gridMesh(2), Level(1), constantContent(0.25F), 3);
    NoProgress progress;
    const auto transfer = transferPaint(*from.surface,
                                        from.scene(),
                                        *to.surface,
                                        to.texels,
                                        within(std::numeric_limits<float>::infinity()),
                                        progress);
    ASSERT_TRUE(transfer);
    const FaceTexels& face = transfer->texels.face(faceId(3));
    EXPECT_TRUE(face.isConstant());
    std::array<float, 3> value{};
    decode(TexelType::Float, face.texel(0), value);
    EXPECT_EQ(value, (std::array{1.0F, 0.25F, 0.25F}));
}

TEST(TransferPaint, whatIsTooFarTakesAValueWhereThatIsWanted)
{
    // Half of the square is covered.
    TriangleMesh half = gridMesh(4);
    for (glm::vec3& position : half.positions) {
        position.x *= 0.5F;
    }
    const Painted from(half, Level(3), constantContent(0.75));
    const Painted to(gridMesh(3), Level(3), constantContent(0.25));
    TransferOptions options = within(0.01F);
    options.outOfReach = OutOfReach::Fill;
    const float white = 1;
    const auto bytes = std::as_bytes(std::span(&white, 1));
    options.fill.assign(bytes.begin(), bytes.end());
    NoProgress progress;
    const auto transfer =
        transferPaint(*from.surface, from.scene(), *to.surface, to.texels, options, progress);
    ASSERT_TRUE(transfer);
    int painted = 0;
    for (std::uint32_t f = 0; f < to.texels.faceCount(); ++f) {
        const auto corners = to.surface->mesh().corners(faceId(f));
        bool isOfOneValue = true;
        for (std::uint32_t k = 0; k < 64; ++k) {
            const glm::vec2 uv(centroid(Level(3), texelAt(Level(3), TexelIndex(k))));
            const float x = pointAt(corners, uv.x, uv.y).x;
            const double value = valueAt(transfer->texels, faceId(f), k);
            if (std::abs(x - 0.51F) > 1e-4F) {
                ASSERT_NEAR(value, x < 0.51F ? 0.75 : 1, 1e-6) << f << " " << k;
            }
            painted += value < 0.9 ? 1 : 0;
            isOfOneValue = isOfOneValue && value == valueAt(transfer->texels, faceId(f), 0);
        }
        EXPECT_EQ(transfer->texels.face(faceId(f)).isConstant(), isOfOneValue)
            << "a face of one value keeps one";
    }
    EXPECT_EQ(static_cast<std::uint64_t>(painted), transfer->reached);
}

TEST(TransferPaint, onlyTheFacesThatAreWantedTakePaint)
{
    const Painted from(gridMesh(4), Level(2), constantContent(0.75));
    const Painted to(gridMesh(3), Level(2), constantContent(0.25));
    TransferOptions options = within(1);
    options.faces = {FaceId{7}, FaceId{2}};
    NoProgress progress;
    const auto transfer =
        transferPaint(*from.surface, from.scene(), *to.surface, to.texels, options, progress);
    ASSERT_TRUE(transfer);
    EXPECT_EQ(transfer->total, 32U);
    EXPECT_EQ(transfer->reached, 32U);
    for (std::uint32_t f = 0; f < to.texels.faceCount(); ++f) {
        EXPECT_NEAR(valueAt(transfer->texels, faceId(f), 3), f == 7 || f == 2 ? 0.75 : 0.25, 1e-6);
    }
}

TEST(TransferPaint, distancesAreThoseOfTexelsSpreadOverAllFaces)
{
    TriangleMesh raised = gridMesh(4);
    for (glm::vec3& position : raised.positions) {
        position.z += 0.25F;
    }
    const Painted from(raised, Level(0), constantContent(0));
    const Painted to(gridMesh(3), Level(3), constantContent(0));
    const auto some = sampleDistances(*from.surface, *to.surface, to.texels, 100);
    EXPECT_GT(some.size(), 90U);
    EXPECT_LE(some.size(), 100U);
    for (const float distance : some) {
        EXPECT_NEAR(double{distance}, 0.25, 1e-6);
    }
    const auto all = sampleDistances(*from.surface, *to.surface, to.texels, 1'000'000);
    EXPECT_EQ(all.size(), to.texels.texelCount());
    const Painted nothing({}, Level(0), constantContent(0));
    EXPECT_TRUE(sampleDistances(*nothing.surface, *to.surface, to.texels, 10).empty());
}

TEST(TransferPaint, givesUpWhenCancelled)
{
    const Painted from(gridMesh(2), Level(1), constantContent(1));
    for (int reports = 0; reports < 2; ++reports) {
        CancelAfter progress(reports);
        const auto transfer = transferPaint(
            *from.surface, from.scene(), *from.surface, from.texels, within(1), progress);
        ASSERT_FALSE(transfer);
        EXPECT_EQ(transfer.error().kind, ErrorKind::Cancelled);
    }
}

/// Checks of which half are lit, under large texels.
TEST(TransferPaint, paintIsAveragedAsLightAndStoredAsTheTexelsMean)
{
    const Painted from(gridMesh(8), Level(4), checkerContent(1.0 / 64));
    const Painted to(gridMesh(2), Level(1), constantContent(0));
    const auto brought = [&](std::optional<std::vector<ColorSpace>> paint,
                             std::optional<std::vector<ColorSpace>> texels) {
        NoProgress progress;
        const TransferColors colors =
            transferColors(paint, from.texels.format(), texels, to.texels.format());
        const auto scene =
            transferScene(*from.surface, from.texels, colors.paint, Threads{2}, progress);
        TransferOptions options = within(1);
        options.colors = colors.texels;
        const auto transfer =
            transferPaint(*from.surface, *scene, *to.surface, to.texels, options, progress);
        double sum = 0;
        for (std::uint32_t f = 0; f < to.texels.faceCount(); ++f) {
            for (std::uint32_t k = 0; k < 4; ++k) {
                sum += valueAt(transfer->texels, faceId(f), k) / (4 * to.texels.faceCount());
            }
        }
        return sum;
    };
    using Colors = std::vector<ColorSpace>;
    const Colors sRgb = {ColorSpace::SRgb};
    const Colors linear = {ColorSpace::Linear};
    const double half = double(fromLinear(ColorSpace::SRgb, 0.5F));
    EXPECT_NEAR(brought(sRgb, sRgb), half, 0.02); // not 0.5
    EXPECT_NEAR(brought(sRgb, linear), 0.5, 0.02);
    EXPECT_NEAR(brought(linear, sRgb), half, 0.02);
    EXPECT_NEAR(brought(sRgb, {}), half, 0.02); // as the other's
    EXPECT_NEAR(brought({}, linear), 0.5, 0.02);
    EXPECT_NEAR(brought({}, {}), 0.5, 0.02);
}

TEST(TransferPaint, channelsThatOneSideLacksAreRaw)
{
    using enum ColorSpace;
    const std::vector<ColorSpace> three = {SRgb, SRgb, Linear};
    const TexelFormat two{TexelType::UInt8, 2, std::nullopt};
    const TexelFormat four{TexelType::UInt8, 4, 3};
    const TransferColors colors =
        transferColors(std::nullopt, four, three, {TexelType::UInt8, 3, std::nullopt});
    EXPECT_EQ(colors.paint, (std::vector{SRgb, SRgb, Linear, Raw}));
    EXPECT_EQ(colors.texels, three);
    const TransferColors fewer =
        transferColors(three, {TexelType::UInt8, 3, std::nullopt}, std::nullopt, two);
    EXPECT_EQ(fewer.texels, (std::vector{SRgb, SRgb}));
    EXPECT_TRUE(transferColors({}, two, {}, four).paint.empty());
}

TEST(TransferPaint, twoLargeFacesAreLeftSoonAfterItWasCancelled)
{
    const Painted from(gridMesh(1), Level(1), noiseContent(2));
    const Painted to(gridMesh(1), Level(7), constantContent(0));
    ASSERT_EQ(to.texels.faceCount(), 2U);
    CancelAfter progress(4); // of eight pieces
    const auto transfer =
        transferPaint(*from.surface, from.scene(), *to.surface, to.texels, within(1), progress);
    ASSERT_FALSE(transfer);
    EXPECT_EQ(transfer.error().kind, ErrorKind::Cancelled);
}

/// However faces are cut into pieces.
TEST(TransferPaint, threadsDoNotChangeTheResult)
{
    const Painted from(gridMesh(3), Level(4), noiseContent(2));
    const Painted to(gridMesh(1), Level(7), constantContent(0.5F));
    std::vector<TexelStore> results;
    for (const unsigned threads : {1U, 3U}) {
        TransferOptions options = within(1);
        options.threads = Threads{threads};
        NoProgress progress;
        results.push_back(
            transferPaint(*from.surface, from.scene(), *to.surface, to.texels, options, progress)
                ->texels);
    }
    for (std::uint32_t f = 0; f < 2; ++f) {
        EXPECT_EQ(results[0].face(faceId(f)), results[1].face(faceId(f)));
    }
}

} // namespace
