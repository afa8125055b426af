// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lattice/texel.h"
#include "core/mapping/bake.h"
#include "core/mapping/bake_channels.h"
#include "core/mapping/faces_in_reach.h"
#include "core/mapping/projection.h"
#include "core/texture/stored_faces.h"
#include "tests/core/cancel_after.h"
#include "tests/core/test_meshes.h"

#include <cmath>
#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <gmock/gmock.h>

namespace trixel {
namespace {

using testing::HasSubstr;

template <class Value>
Image imageOf(int size,
              const Value& value,
              TexelType type = TexelType::Float,
              ColorSpace space = ColorSpace::Linear)
{
    Image image(size, size, {type, 3, std::nullopt}, std::vector<ColorSpace>(3, space));
    std::vector<float> values;
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            for (int c = 0; c < 3; ++c) {
                values.push_back(static_cast<float>(value(x, y, c)));
            }
        }
    }
    encode(type, values, image.writable());
    return image;
}

ImageTiles tilesOf(Image image, ImageLookup lookup = ImageLookup::Bilinear)
{
    SamplerOptions options;
    options.lookup = lookup;
    return ImageTiles::make({{UdimTile{}, std::move(image), "image"}}, options, Threads{2}).value();
}

std::vector<FaceId> allFaces(const TexelStore& store)
{
    std::vector<FaceId> faces;
    for (std::uint32_t k = 0; k < store.faceCount(); ++k) {
        faces.push_back(faceId(k));
    }
    return faces;
}

TexelStore storeOf(std::size_t faces, const TexelFormat& format, int mostLevel, float fill)
{
    FaceMap<Level> levels(faces);
    for (std::size_t k = 0; k < faces; ++k) {
        levels[faceId(k)] = Level(static_cast<int>(k) % (mostLevel + 1));
    }
    std::vector<std::byte> texel(format.texelBytes());
    encode(format.type, std::vector<float>(format.channels, fill), texel);
    return {format, levels, texel};
}

std::vector<float> texelOf(const TexelStore& store, FaceId face, std::uint32_t texel)
{
    std::vector<float> values(store.format().channels);
    decode(store.format().type, store.face(face).texel(texel), values);
    return values;
}

Projection wholeGrid()
{
    return planarProjection({0, 0, 1}, {1, 0, 0}, {0, 1, 0}).value();
}

bool sameStores(const TexelStore& a, const TexelStore& b)
{
    for (std::uint32_t k = 0; k < a.faceCount(); ++k) {
        if (!(a.face(faceId(k)) == b.face(faceId(k)))) {
            return false;
        }
    }
    return true;
}

TEST(BakeTest, everyTexelTakesTheImageAtItsCentroid)
{
    // An affine image, which bilinear lookups keep; texels of both halves and of many levels.
    const TriangleMesh mesh = test::gridMesh(3);
    const auto value = [](double x, double y, int c) { return 0.01 * x + 0.02 * y + 0.1 * c; };
    TexelStore store = storeOf(mesh.faceCount(), {TexelType::Float, 3, std::nullopt}, 5, 9.0F);
    const ProjectionMapping mapping(mesh, wholeGrid(), nullptr);
    NoProgress progress;
    const auto patch =
        bake(store, allFaces(store), mapping, tilesOf(imageOf(64, value)), {}, progress);
    ASSERT_TRUE(patch) << patch.error().message;
    EXPECT_EQ(patch->faces().size(), mesh.faceCount());
    for (std::uint32_t k = 0; k < mesh.faceCount(); ++k) {
        const Level level = store.face(faceId(k)).level();
        for (std::uint32_t t = 0; t < level.texelCount(); ++t) {
            const glm::dvec2 uv = centroid(level, texelAt(level, TexelIndex{t}));
            const glm::vec3 p = pointAt(
                mesh.corners(faceId(k)), static_cast<float>(uv.x), static_cast<float>(uv.y));
            const auto texel = texelOf(store, faceId(k), t);
            const double x = std::clamp(64.0 * p.x - 0.5, 0.0, 63.0);
            const double y = std::clamp(64.0 * (1 - p.y) - 0.5, 0.0, 63.0);
            for (int c = 0; c < 3; ++c) {
                EXPECT_NEAR(texel[static_cast<std::size_t>(c)], value(x, y, c), 2e-5);
            }
        }
    }
}

TEST(BakeTest, swappingThePatchUndoesAndRedoes)
{
    const TriangleMesh mesh = test::gridMesh(4);
    TexelStore store = storeOf(mesh.faceCount(), {TexelType::UInt8, 3, std::nullopt}, 4, 0.5F);
    const TexelStore before = store;
    const ProjectionMapping mapping(mesh, wholeGrid(), nullptr);
    NoProgress progress;
    const auto image =
        imageOf(32, [](int x, int y, int c) { return (x * 5 + y * 3 + c) % 7 / 7.0; });
    auto patch = bake(store, allFaces(store), mapping, tilesOf(image), {}, progress);
    ASSERT_TRUE(patch);
    const TexelStore after = store;
    EXPECT_FALSE(sameStores(before, after));
    patch->swap(store);
    EXPECT_TRUE(sameStores(store, before));
    patch->swap(store);
    EXPECT_TRUE(sameStores(store, after));
}

TEST(BakeTest, threadsDoNotChangeTheResult)
{
    const TriangleMesh mesh = test::gridMesh(5);
    const auto image = imageOf(128, [](int x, int y, int c) { return (x * y + c) % 11 / 11.0; });
    const ProjectionMapping mapping(mesh, wholeGrid(), nullptr);
    std::vector<TexelStore> stores;
    for (const unsigned count : {1U, 2U, 5U}) {
        stores.push_back(storeOf(mesh.faceCount(), {TexelType::Half, 3, std::nullopt}, 7, 0));
        BakeOptions options;
        options.threads = Threads{count};
        NoProgress progress;
        ASSERT_TRUE(bake(stores.back(),
                         allFaces(stores.back()),
                         mapping,
                         tilesOf(image, ImageLookup::Footprint),
                         options,
                         progress));
        EXPECT_TRUE(sameStores(stores.front(), stores.back())) << count;
    }
}

TEST(BakeTest, cancellingLeavesEverythingAsItWas)
{
    const TriangleMesh mesh = test::gridMesh(4);
    TexelStore store = storeOf(mesh.faceCount(), {TexelType::UInt8, 3, std::nullopt}, 7, 0.5F);
    const TexelStore before = store;
    const ProjectionMapping mapping(mesh, wholeGrid(), nullptr);
    const auto image = tilesOf(imageOf(16, [](int, int, int) { return 1.0; }));
    for (const int reports : {0, 1, 3}) {
        CancelAfter progress(reports);
        const auto patch = bake(store, allFaces(store), mapping, image, {}, progress);
        ASSERT_FALSE(patch);
        EXPECT_EQ(patch.error().kind, ErrorKind::Cancelled);
        EXPECT_TRUE(sameStores(store, before));
    }
}

TEST(BakeTest, onlyWhatTheImageReachesChanges)
{
    const TriangleMesh mesh = test::gridMesh(4);
    TexelStore store = storeOf(mesh.faceCount(), {TexelType::UInt8, 3, std::nullopt}, 4, 0.5F);
    const TexelStore before = store;
    const auto quarter = planarProjection({0, 0, 1}, {0.5, 0, 0}, {0, 0.5, 0});
    const ProjectionMapping mapping(mesh, *quarter, nullptr);
    const auto image = tilesOf(imageOf(16, [](int, int, int) { return 1.0; }));
    NoProgress progress;
    const auto patch = bake(store, allFaces(store), mapping, image, {}, progress);
    ASSERT_TRUE(patch);
    EXPECT_EQ(patch->faces().size(), mesh.faceCount() / 4);
    for (std::uint32_t k = 0; k < mesh.faceCount(); ++k) {
        const glm::vec3 p = pointAt(mesh.corners(faceId(k)), 0.3F, 0.3F);
        const bool reached = p.x < 0.5F && p.y < 0.5F;
        EXPECT_EQ(!(store.face(faceId(k)) == before.face(faceId(k))), reached) << k;
        EXPECT_TRUE(store.face(faceId(k)).isConstant()); // of one colour either way
    }
    const auto nowhere = planarProjection({5, 5, 1}, {1, 0, 0}, {0, 1, 0});
    const ProjectionMapping off(mesh, *nowhere, nullptr);
    const auto none = bake(store, allFaces(store), off, image, {}, progress);
    ASSERT_FALSE(none);
    EXPECT_EQ(none.error().message, "the image reaches no texel");
}

/// A file whose faces are of one value, but for some that cannot be read.
class PartlyDamaged final : public FaceReader
{
public:
    explicit PartlyDamaged(FaceId from)
        : m_from(from)
    {
    }
    Result<bool> read(FaceId face, Level, std::span<std::byte> texels) const override
    {
        if (face >= m_from) {
            return contentsError("cannot be read");
        }
        std::fill(texels.begin(), texels.end(), std::byte{7});
        return true;
    }
    bool stores(FaceId, Level) const override { return false; }
    std::span<const std::byte> mean(FaceId) const override { return m_mean; }

private:
    FaceId m_from;
    std::array<std::byte, 3> m_mean{};
};

TEST(BakeTest, facesInAFileAreReadWhereTheImageLandsAndNowhereElse)
{
    const TriangleMesh mesh = test::gridMesh(8); // the last of 128 faces have y > 7/8
    const TexelFormat format{TexelType::UInt8, 3, std::nullopt};
    const Level level(8);
    const auto image = tilesOf(imageOf(16, [](int, int, int) { return 1.0; }));
    for (const std::uint32_t readable : {32U, 2U}) {
        const auto stored =
            StoredFaces::make(format, std::make_unique<PartlyDamaged>(faceId(readable)));
        TexelStore store(128, format, level, std::vector<std::byte>(3));
        for (std::uint32_t k = 0; k < 128; ++k) {
            store.exchange(faceId(k), stored->face(faceId(k), level));
        }
        // A corner of the grid: faces 0 to 3 and 16 to 19.
        const ProjectionMapping mapping(
            mesh, planarProjection({0, 0, 1}, {0.2, 0, 0}, {0, 0.2, 0}).value(), nullptr);
        NoProgress progress;
        const auto patch = bake(store, allFaces(store), mapping, image, {}, progress);
        if (readable == 32U) {
            ASSERT_TRUE(patch) << patch.error().message;
            EXPECT_EQ(store.face(faceId(0)).texel(0)[0], std::byte{255});
            EXPECT_EQ(store.face(faceId(19)).texel(level.texelCount() - 1)[0], std::byte{7});
            EXPECT_LE(stored->readBytes(), 20U * 3U * level.texelCount());
            EXPECT_EQ(stored->heldBytes(), 0U);
            EXPECT_EQ(stored->faultCount(), 0U);
        } else {
            ASSERT_FALSE(patch);
            EXPECT_THAT(patch.error().message, HasSubstr("face 2 could not be read"));
            EXPECT_FALSE(store.face(faceId(0)).isLoaded());
        }
    }
}

TEST(BakeTest, facesThatWereNotChosenStay)
{
    const TriangleMesh mesh = test::gridMesh(2);
    TexelStore store = storeOf(mesh.faceCount(), {TexelType::UInt8, 3, std::nullopt}, 3, 0.5F);
    const std::vector<FaceId> some = {faceId(1), faceId(6)};
    const ProjectionMapping mapping(mesh, wholeGrid(), nullptr);
    NoProgress progress;
    const auto patch = bake(
        store, some, mapping, tilesOf(imageOf(4, [](int, int, int) { return 1.0; })), {}, progress);
    ASSERT_TRUE(patch);
    EXPECT_THAT(patch->faces(), testing::ElementsAreArray(some));
}

TEST(BakeTest, numbersPassWhereNothingIsDeclaredAndBecomeLightWhereItIs)
{
    const TriangleMesh mesh = test::gridMesh(1);
    const ProjectionMapping mapping(mesh, wholeGrid(), nullptr);
    const auto image = imageOf(
        8, [](int, int, int) { return 0.5; }, TexelType::UInt8, ColorSpace::SRgb);
    NoProgress progress;
    TexelStore same = storeOf(2, {TexelType::UInt8, 3, std::nullopt}, 2, 0);
    ASSERT_TRUE(bake(same, allFaces(same), mapping, tilesOf(image), {}, progress));
    EXPECT_NEAR(texelOf(same, faceId(0), 0)[0], 128 / 255.0, 1e-6);
    TexelStore linear = storeOf(2, {TexelType::Float, 3, std::nullopt}, 2, 0);
    BakeOptions options;
    options.colors.assign(3, ColorSpace::Linear);
    ASSERT_TRUE(bake(linear, allFaces(linear), mapping, tilesOf(image), options, progress));
    EXPECT_NEAR(texelOf(linear, faceId(0), 0)[0], 0.21586, 1e-4);
}

TEST(BakeTest, whatIsTransparentLetsThePaintThrough)
{
    const TexelFormat withOpacity{TexelType::Float, 4, 3};
    Image image(2, 2, withOpacity, uniformColors(ColorSpace::Linear, 4, 3));
    const std::vector<float> pixels = {
        1, 0, 0, 0.25F, 1, 0, 0, 0.25F, 1, 0, 0, 0.25F, 1, 0, 0, 0.25F};
    encode(TexelType::Float, pixels, image.writable());
    const TriangleMesh mesh = test::gridMesh(1);
    const ProjectionMapping mapping(mesh, wholeGrid(), nullptr);
    NoProgress progress;
    TexelStore opaque = storeOf(2, {TexelType::Float, 3, std::nullopt}, 0, 0.4F);
    ASSERT_TRUE(bake(opaque, allFaces(opaque), mapping, tilesOf(image), {}, progress));
    const auto mixed = texelOf(opaque, faceId(0), 0);
    EXPECT_NEAR(mixed[0], 0.25 + 0.75 * 0.4, 1e-6);
    EXPECT_NEAR(mixed[1], 0.75 * 0.4, 1e-6);
    // Over a texel that is half transparent itself.
    TexelStore half = storeOf(2, withOpacity, 0, 0.5F);
    ASSERT_TRUE(bake(half, allFaces(half), mapping, tilesOf(image), {}, progress));
    const auto over = texelOf(half, faceId(0), 0);
    EXPECT_NEAR(over[3], 0.25 + 0.75 * 0.5, 1e-6);
    EXPECT_NEAR(over[0], (0.25 + 0.75 * 0.5 * 0.5) / over[3], 1e-6);
    // Half of it all.
    BakeOptions options;
    options.opacity = 0.5F;
    TexelStore faint = storeOf(2, {TexelType::Float, 3, std::nullopt}, 0, 0.4F);
    ASSERT_TRUE(bake(faint, allFaces(faint), mapping, tilesOf(image), options, progress));
    EXPECT_NEAR(texelOf(faint, faceId(0), 0)[0], 0.125 + 0.875 * 0.4, 1e-6);
}

TEST(BakeTest, channelsMeetInTheirOrder)
{
    const std::vector<ColorSpace> grey = {ColorSpace::Linear};
    const std::vector<ColorSpace> rgb(3, ColorSpace::Linear);
    const auto laid = [](const TexelFormat& format,
                         const std::vector<ColorSpace>& image,
                         std::vector<float> colors) {
        std::vector<float> values(format.channels, 9.0F);
        BakeChannels(format, {}, image).lay(colors, 1, values);
        return values;
    };
    using testing::ElementsAre;
    EXPECT_THAT(laid({TexelType::Float, 3, {}}, grey, {0.5F}), ElementsAre(0.5F, 0.5F, 0.5F));
    EXPECT_THAT(laid({TexelType::Float, 4, 3}, rgb, {1, 2, 3}), ElementsAre(1, 2, 3, 1));
    EXPECT_THAT(laid({TexelType::Float, 5, 0}, rgb, {1, 2, 3}), ElementsAre(1, 1, 2, 3, 9));
    EXPECT_THAT(laid({TexelType::Float, 1, {}}, rgb, {1, 2, 3}), ElementsAre(1));
}

TEST(BakeTest, tilesTakeTheirOwnImage)
{
    TriangleMesh mesh = test::gridMesh(2);
    for (const Triangle& triangle : mesh.triangles) {
        for (const std::uint32_t vertex : triangle) {
            mesh.cornerUvs.push_back(2.0F * glm::vec2(mesh.positions[vertex]));
        }
    }
    const auto plain = [](float value) {
        return imageOf(4, [value](int, int, int) { return value; });
    };
    std::vector<TileImage> images;
    for (const int number : {1012, 1001, 1011, 1002}) {
        images.push_back(
            {*udimTile(number), plain(static_cast<float>(number)), std::to_string(number)});
    }
    const auto tiles = ImageTiles::make(images, {}, Threads{1});
    ASSERT_TRUE(tiles);
    TexelStore store = storeOf(mesh.faceCount(), {TexelType::Float, 3, std::nullopt}, 3, 0);
    NoProgress progress;
    ASSERT_TRUE(bake(store, allFaces(store), UvMapping(mesh), *tiles, {}, progress));
    for (std::uint32_t k = 0; k < mesh.faceCount(); ++k) {
        const glm::vec3 p = pointAt(mesh.corners(faceId(k)), 0.3F, 0.3F);
        const float expected = 1001.0F + (p.x > 0.5F ? 1 : 0) + (p.y > 0.5F ? 10 : 0);
        EXPECT_FLOAT_EQ(texelOf(store, faceId(k), 0)[1], expected);
    }
    images.push_back({*udimTile(1002), plain(0), "again"});
    const auto twice = ImageTiles::make(images, {}, Threads{1});
    ASSERT_FALSE(twice);
    EXPECT_THAT(twice.error().message, HasSubstr("again: there is another image for tile 1002"));
    images.pop_back();
    images.push_back(
        {*udimTile(1003), Image(1, 1, {TexelType::UInt8, 1, {}}, {ColorSpace::Raw}), "grey"});
    const auto mixed = ImageTiles::make(images, {}, Threads{1});
    ASSERT_FALSE(mixed);
    EXPECT_THAT(mixed.error().message, HasSubstr("grey: its channels differ"));
}

TEST(FacesInReachTest, leavesOutWhatTheBakeLeavesOut)
{
    // Half of a grid of 8 x 8, seen straight and from a camera that some of it lies behind.
    const TriangleMesh mesh = test::gridMesh(8);
    const TexelStore store =
        storeOf(mesh.faceCount(), {TexelType::Float, 3, std::nullopt}, 3, 9.0F);
    const ImageTiles image = tilesOf(imageOf(4, [](int x, int y, int) { return x + y; }));
    Projection half = planarProjection({0.3, 0.2, 0}, {0.4, 0, 0}, {0, 0.5, 0}).value();
    Projection camera =
        cameraProjection(glm::perspective(1.0, 1.0, 0.1, 10.0) *
                         glm::lookAt(glm::dvec3(0.5, 0.5, 0.3), glm::dvec3(0.5, 1, 0), {0, 0, 1}))
            .value();
    camera.visibleOnly = false;
    for (const Projection& projection : {half, camera}) {
        for (const bool frontOnly : {false, true}) {
            Projection one = projection;
            one.frontOnly = frontOnly;
            const std::vector<FaceId> reached =
                facesInReach(one, mesh, allFaces(store), Threads{2});
            EXPECT_LT(reached.size(), mesh.faceCount());
            EXPECT_GT(reached.size(), 4U);
            const ProjectionMapping mapping(mesh, one, nullptr);
            TexelStore all = store;
            TexelStore some = store;
            NoProgress progress;
            ASSERT_TRUE(bake(all, allFaces(store), mapping, image, {}, progress));
            ASSERT_TRUE(bake(some, reached, mapping, image, {}, progress));
            EXPECT_TRUE(sameStores(all, some));
        }
    }
}

TEST(FacesInReachTest, keepsFacesThatBeginBehindTheEye)
{
    const TriangleMesh mesh = test::gridMesh(1);
    const TexelStore store = storeOf(2, {TexelType::Float, 3, std::nullopt}, 0, 0);
    const Projection camera =
        cameraProjection(glm::perspective(1.0, 1.0, 0.1, 10.0) *
                         glm::lookAt(glm::dvec3(0.5, 0.5, 0.3), glm::dvec3(0.5, 1, 0), {0, 0, 1}))
            .value();
    EXPECT_EQ(facesInReach(camera, mesh, allFaces(store), Threads{1}).size(), 2U);
}

/// A large image is told of level by level and can be left at each.
TEST(ImageTilesTest, makingLevelsIsLeftWhenCancelled)
{
    const TexelFormat format{TexelType::Half, 4, std::nullopt};
    const auto colors = uniformColors(ColorSpace::Linear, 4, {});
    const auto images = [&] {
        return std::vector<TileImage>{{UdimTile{0, 0}, Image(40, 24, format, colors), "a"},
                                      {UdimTile{1, 0}, Image(8, 8, format, colors), "b"}};
    };
    int reports = 0;
    for (bool isDone = false; !isDone; ++reports) {
        CancelAfter progress(reports);
        const auto tiles = ImageTiles::make(images(), {}, Threads{2}, progress);
        isDone = tiles.has_value();
        ASSERT_TRUE(isDone || tiles.error().kind == ErrorKind::Cancelled);
    }
    EXPECT_GT(reports, 2 * (6 + 4)); // levels of both images, of two groups of channels each
}

TEST(FacesInReachTest, leavesOutFacesThatTurnTheirBack)
{
    const TriangleMesh mesh = test::gridMesh(4);
    const TexelStore store = storeOf(mesh.faceCount(), {TexelType::Float, 3, std::nullopt}, 0, 0);
    Projection behind = planarProjection({1, 0, 0}, {-1, 0, 0}, {0, 1, 0}).value();
    EXPECT_EQ(facesInReach(behind, mesh, allFaces(store), Threads{1}).size(), mesh.faceCount());
    behind.frontOnly = true;
    EXPECT_TRUE(facesInReach(behind, mesh, allFaces(store), Threads{1}).empty());
}

} // namespace
} // namespace trixel
