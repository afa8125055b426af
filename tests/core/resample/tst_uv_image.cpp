// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/image_levels.h"
#include "core/lattice/texel.h"
#include "core/mapping/bake.h"
#include "core/mesh/triangle_geometry.h"
#include "core/resample/uv_image.h"
#include "core/resample/uv_raster.h"
#include "tests/core/cancel_after.h"
#include "tests/core/test_meshes.h"

#include <cmath>
#include <gmock/gmock.h>
#include <limits>
#include <random>

namespace trixel {
namespace {

using testing::HasSubstr;

/// A grid whose uvs are its positions, shrunk about the middle.
TriangleMesh gridWithUvs(std::uint32_t n, float scale = 1)
{
    TriangleMesh mesh = test::gridMesh(n);
    for (const Triangle& triangle : mesh.triangles) {
        for (const std::uint32_t vertex : triangle) {
            mesh.cornerUvs.push_back(scale * (glm::vec2(mesh.positions[vertex]) - 0.5F) + 0.5F);
        }
    }
    return mesh;
}

FilterScene sceneOf(const TriangleMesh& mesh, const TexelStore& store)
{
    NoProgress progress;
    const auto surface = std::make_shared<const FilterSurface>(
        FilterSurface::fromMesh(mesh, buildAdjacency(mesh.triangles)));
    return FilterScene::build(surface, store, Threads{2}, progress).value();
}

/// Texels of one channel, by position.
template <class Value>
TexelStore storeOf(const TriangleMesh& mesh, Level level, const Value& value)
{
    const TexelFormat format{TexelType::Float, 1, std::nullopt};
    TexelStore store(static_cast<std::uint32_t>(mesh.faceCount()),
                     format,
                     level,
                     std::vector<std::byte>(sizeof(float)));
    for (std::uint32_t k = 0; k < mesh.faceCount(); ++k) {
        std::vector<float> texels(level.texelCount());
        for (std::uint32_t t = 0; t < texels.size(); ++t) {
            const glm::dvec2 uv = centroid(level, texelAt(level, TexelIndex{t}));
            texels[t] = static_cast<float>(value(pointAt(
                mesh.corners(faceId(k)), static_cast<float>(uv.x), static_cast<float>(uv.y))));
        }
        std::vector<std::byte> bytes(texels.size() * sizeof(float));
        encode(TexelType::Float, texels, bytes);
        store.exchange(faceId(k), FaceTexels::full(level, sizeof(float), bytes));
    }
    return store;
}

UvImageOptions optionsOf(int size, int gutter)
{
    UvImageOptions options;
    options.width = options.height = size;
    options.gutter = gutter;
    options.type = TexelType::Float;
    options.colors = {ColorSpace::Linear};
    options.threads = Threads{2};
    return options;
}

Result<UvImage> imageOf(const TriangleMesh& mesh, const TexelStore& store, UvImageOptions options)
{
    NoProgress progress;
    return makeUvImage(sceneOf(mesh, store), mesh, store.format(), options, progress);
}

std::vector<float> valuesOf(const Image& image)
{
    std::vector<float> values(image.byteCount() / byteSize(image.format().type));
    decode(image.format().type, image.pixels(), values);
    return values;
}

TEST(UvRasterTest, everyPixelOfACoveredImageBelongsToTheFaceUnderIt)
{
    const TriangleMesh mesh = gridWithUvs(5);
    NoProgress progress;
    const UvRaster raster = *rasterUvs(mesh, 64, 48, {}, Threads{2}, progress);
    for (int y = 0; y < 48; ++y) {
        for (int x = 0; x < 64; ++x) {
            const std::uint32_t owner = raster.owners[static_cast<std::size_t>(y * 64 + x)];
            ASSERT_GT(owner, 0U);
            const auto in = PixelsInFace::of(mesh.uvs(faceId(owner - 1)), PixelPlane(64, 48, {}));
            const glm::dvec2 uv = in->uv({x + 0.5, y + 0.5});
            const glm::vec3 p = pointAt(mesh.corners(faceId(owner - 1)),
                                        static_cast<float>(uv.x),
                                        static_cast<float>(uv.y));
            EXPECT_NEAR(p.x, (x + 0.5) / 64, 1e-6);
            EXPECT_NEAR(p.y, 1 - (y + 0.5) / 48, 1e-6);
        }
    }
}

TEST(UvRasterTest, growingReachesSoManyPixelsAndNoMore)
{
    const TriangleMesh mesh = gridWithUvs(2, 0.25F);
    NoProgress progress;
    UvRaster raster = *rasterUvs(mesh, 64, 64, {}, Threads{1}, progress);
    const auto owned = [&] {
        return raster.owners.size() -
               static_cast<std::size_t>(std::count(raster.owners.begin(), raster.owners.end(), 0U));
    };
    EXPECT_EQ(owned(), 16U * 16U);
    ASSERT_TRUE(growRaster(raster, mesh, {}, 3, Threads{2}, progress));
    EXPECT_EQ(owned(), 22U * 22U);
}

/// Charts of one face each, scattered over the image and beyond it, some over others.
TriangleMesh scatteredCharts(unsigned seed, float size)
{
    TriangleMesh mesh = test::gridMesh(3);
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> any(-0.1F, 1.1F);
    std::uniform_real_distribution<float> off(-size, size);
    for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
        const glm::vec2 at(any(random), any(random));
        for (int k = 0; k < 3; ++k) {
            mesh.cornerUvs.push_back(at + glm::vec2(off(random), off(random)));
        }
    }
    return mesh;
}

/// One step of growing as it is told: every pixel is looked at, as all were before the step.
void growByOne(UvRaster& raster, const TriangleMesh& mesh)
{
    const UvRaster before = raster;
    const PixelPlane plane(raster.width, raster.height, {});
    const auto number = [&](int x, int y) {
        return static_cast<std::size_t>(y * raster.width + x);
    };
    for (int y = 0; y < raster.height; ++y) {
        for (int x = 0; x < raster.width; ++x) {
            double least = std::numeric_limits<double>::infinity();
            for (int k = 0; k < 9 && before.owners[number(x, y)] == 0; ++k) {
                const int bx = x + k % 3 - 1;
                const int by = y + k / 3 - 1;
                const bool inside = bx >= 0 && by >= 0 && bx < raster.width && by < raster.height;
                const std::uint32_t owner = inside ? before.owners[number(bx, by)] : 0;
                if (owner == 0) {
                    continue;
                }
                std::array<glm::vec3, 3> corners{};
                for (std::size_t c = 0; c < 3; ++c) {
                    const glm::dvec2 uv(mesh.uvs(faceId(owner - 1))[c]);
                    corners[c] =
                        glm::vec3(glm::vec2(plane.pixels(uv) - glm::dvec2(x + 0.5, y + 0.5)), 0);
                }
                const double apart = nearestOnTriangle(corners, glm::dvec3(0)).distanceSquared;
                std::uint32_t& best = raster.owners[number(x, y)];
                if (apart < least || (apart == least && owner < best)) {
                    best = owner;
                    least = apart;
                }
            }
        }
    }
}

TEST(UvRasterTest, growingGivesWhatALookAtEveryPixelGives)
{
    NoProgress progress;
    for (const auto& [seed, size] : {std::pair(1U, 0.05F), {2U, 0.2F}, {3U, 0.02F}, {4U, 0.6F}}) {
        const TriangleMesh mesh = scatteredCharts(seed, size);
        UvRaster slow = *rasterUvs(mesh, 97, 61, {}, Threads{1}, progress);
        const UvRaster start = slow;
        for (int pixels = 0; pixels <= 40; ++pixels) {
            if (pixels % 8 < 2) {
                UvRaster quick = start;
                ASSERT_TRUE(growRaster(quick, mesh, {}, pixels, Threads{2}, progress));
                ASSERT_EQ(quick.owners, slow.owners) << seed << ' ' << pixels;
                EXPECT_EQ(quick.inside, start.inside);
            }
            growByOne(slow, mesh);
        }
        UvRaster all = start; // more than there is room for
        ASSERT_TRUE(growRaster(all, mesh, {}, 500, Threads{2}, progress));
        EXPECT_EQ(std::count(all.owners.begin(), all.owners.end(), 0U), 0);
    }
}

TEST(UvRasterTest, drawingAndGrowingAreLeftWhenCancelled)
{
    const TriangleMesh mesh = scatteredCharts(1, 0.05F);
    NoProgress progress;
    CancelAfter none(0);
    EXPECT_EQ(rasterUvs(mesh, 64, 64, {}, Threads{2}, none).error().kind, ErrorKind::Cancelled);
    const UvRaster start = *rasterUvs(mesh, 64, 64, {}, Threads{2}, progress);
    for (const int reports : {0, 5, 9}) { // of ten steps and the end
        CancelAfter steps(reports);
        UvRaster raster = start;
        EXPECT_EQ(growRaster(raster, mesh, {}, 10, Threads{2}, steps).error().kind,
                  ErrorKind::Cancelled);
    }
}

TEST(UvImageTest, anAffineFieldComesThroughExactly)
{
    const TriangleMesh mesh = gridWithUvs(4);
    const auto field = [](glm::vec3 p) { return 0.25 * p.x + 0.5 * p.y; };
    const auto made = imageOf(mesh, storeOf(mesh, Level(5), field), optionsOf(100, 4));
    ASSERT_TRUE(made) << made.error().message;
    EXPECT_EQ(made->insidePixels, 10000U);
    EXPECT_EQ(made->facesWithoutPixel, 0U);
    const auto values = valuesOf(made->image);
    for (int y = 10; y < 90; ++y) { // border vertices have only one side to average
        for (int x = 10; x < 90; ++x) {
            EXPECT_NEAR(values[static_cast<std::size_t>(100 * y + x)],
                        0.25 * (x + 0.5) / 100 + 0.5 * (1 - (y + 0.5) / 100),
                        1e-5);
        }
    }
}

/// Two charts: the left and right half of a grid, pulled apart in the image.
TriangleMesh twoCharts(std::uint32_t n)
{
    TriangleMesh mesh = test::gridMesh(n);
    for (const Triangle& triangle : mesh.triangles) {
        float middle = 0;
        for (const std::uint32_t vertex : triangle) {
            middle += mesh.positions[vertex].x / 3;
        }
        for (const std::uint32_t vertex : triangle) {
            const glm::vec2 p(mesh.positions[vertex]);
            mesh.cornerUvs.push_back(0.5F * p + glm::vec2(middle < 0.5F ? 0.1F : 0.4F, 0.25F));
        }
    }
    return mesh;
}

TEST(UvImageTest, gutterPixelsHoldWhatLiesBeyondTheSeamOnTheSurface)
{
    // An affine field over the whole: beyond the seam a chart's gutter goes on with it, which a
    // copy of the chart's last pixels would not.
    const TriangleMesh mesh = twoCharts(4);
    const auto field = [](glm::vec3 p) { return p.x + 0.1 * p.y; };
    const auto made = imageOf(mesh, storeOf(mesh, Level(4), field), optionsOf(200, 8));
    ASSERT_TRUE(made) << made.error().message;
    EXPECT_GT(made->gutterPixels, 2000U);
    const auto values = valuesOf(made->image);
    // The left chart's seam is at s = 0.1 + 0.25, the right one's at 0.4 + 0.25.
    for (int y = 70; y < 130; ++y) {
        for (const auto& [seam, chart] : {std::pair(70, 0.1), {130, 0.4}}) {
            for (int x = seam - 7; x < seam + 7; ++x) {
                const double px = ((x + 0.5) / 200 - chart) / 0.5;
                const double py = ((1 - (y + 0.5) / 200) - 0.25) / 0.5;
                EXPECT_NEAR(values[static_cast<std::size_t>(200 * y + x)], px + 0.1 * py, 1e-4)
                    << x << ' ' << y;
            }
        }
    }
}

TEST(UvImageTest, guttersSurviveMips)
{
    // Faces of one value: whatever coarser level is looked at within the charts shows it.
    const TriangleMesh mesh = twoCharts(4);
    const auto made =
        imageOf(mesh, storeOf(mesh, Level(2), [](glm::vec3) { return 0.7; }), optionsOf(128, 2));
    ASSERT_TRUE(made);
    for (const Image& level : imageLevels(made->image, Threads{1})) {
        for (const float value : valuesOf(level)) {
            EXPECT_NEAR(value, 0.7, 1e-5); // holes too: nothing foreign is mixed in
        }
    }
}

TEST(UvImageTest, smallImagesAverageWhatTheyCannotHold)
{
    const TriangleMesh mesh = gridWithUvs(2);
    std::mt19937 random(1);
    std::uniform_real_distribution<double> any(0, 1);
    const auto noise = storeOf(mesh, Level(7), [&](glm::vec3) { return any(random); });
    const auto made = imageOf(mesh, noise, optionsOf(12, 0));
    ASSERT_TRUE(made);
    for (const float value : valuesOf(made->image)) {
        EXPECT_NEAR(value, 0.5, 0.08);
    }
}

TEST(UvImageTest, threadsDoNotChangeTheResult)
{
    const TriangleMesh mesh = twoCharts(4);
    const auto store = storeOf(
        mesh, Level(5), [](glm::vec3 p) { return std::sin(40 * p.x) * std::cos(30 * p.y); });
    UvImageOptions options = optionsOf(150, 5);
    options.threads = Threads{1};
    const auto one = imageOf(mesh, store, options);
    options.threads = Threads{3};
    const auto three = imageOf(mesh, store, options);
    ASSERT_TRUE(one && three);
    EXPECT_EQ(valuesOf(one->image), valuesOf(three->image));
}

TEST(UvImageTest, cancellingEndsIt)
{
    const TriangleMesh mesh = gridWithUvs(2);
    const auto store = storeOf(mesh, Level(2), [](glm::vec3) { return 0.5; });
    const FilterScene scene = sceneOf(mesh, store);
    const TriangleMesh shrunk = gridWithUvs(2, 0.5F); // with holes
    for (const TriangleMesh& of : {mesh, shrunk}) {
        for (int reports = 0; reports < 128; reports += reports < 32 ? 1 : 11) { // rows alone: 128
            CancelAfter progress(reports);
            const auto made = makeUvImage(scene, of, store.format(), optionsOf(128, 2), progress);
            ASSERT_FALSE(made);
            EXPECT_EQ(made.error().kind, ErrorKind::Cancelled);
        }
    }
}

TEST(UvImageTest, unusableUvsAndImagesTooSmallAreRefusedInASentence)
{
    const auto refusal = [](const TriangleMesh& mesh, int size) {
        const auto made = imageOf(
            mesh, storeOf(mesh, Level(1), [](glm::vec3) { return 0.5; }), optionsOf(size, 1));
        return made ? std::string("accepted") : made.error().message;
    };
    EXPECT_EQ(refusal(test::gridMesh(1), 16), "the mesh has no uvs");
    EXPECT_THAT(refusal(gridWithUvs(1, 0), 16), HasSubstr("without area"));
    EXPECT_THAT(refusal(gridWithUvs(2, 1e-3F), 16), HasSubstr("16 × 16 pixels is too small"));
    TriangleMesh elsewhere = gridWithUvs(2);
    for (glm::vec2& uv : elsewhere.cornerUvs) {
        uv.x += 1;
    }
    EXPECT_THAT(refusal(elsewhere, 16), HasSubstr("no face of tile 1001"));
    EXPECT_THAT(*uvTiles(elsewhere), testing::ElementsAre(UdimTile{1, 0}));
    // A few faces that hold no pixel are told of, not refused.
    const auto coarse = imageOf(gridWithUvs(8),
                                storeOf(gridWithUvs(8), Level(1), [](glm::vec3) { return 0.5; }),
                                optionsOf(5, 1));
    ASSERT_TRUE(coarse);
    EXPECT_GT(coarse->facesWithoutPixel, 64U);
}

/// Noise of octaves down to a few pixels, equally strong each as photographs have them, but for the
/// last two, which lens and sensor damp.
double natural(double x, double y)
{
    const auto hash = [](int i, int j, int octave) {
        std::uint32_t h = static_cast<std::uint32_t>(i) * 0x9E3779B1U ^
                          static_cast<std::uint32_t>(j) * 0x85EBCA77U ^
                          static_cast<std::uint32_t>(octave) * 0xC2B2AE3DU;
        h = (h ^ h >> 15U) * 0x2C1B3C6DU;
        h = (h ^ h >> 12U) * 0x297A2D39U;
        return static_cast<double>(h ^ h >> 15U) / 4294967296.0 - 0.5;
    };
    double sum = 0.5;
    for (int cell = 128; cell >= 4; cell /= 2) {
        const double amplitude = cell >= 16 ? 0.25 : cell == 8 ? 0.15 : 0.06;
        const double gx = x / cell;
        const double gy = y / cell;
        const int i = static_cast<int>(std::floor(gx));
        const int j = static_cast<int>(std::floor(gy));
        const auto eased = [](double t) { return t * t * (3 - 2 * t); };
        const double tx = eased(gx - i);
        const double ty = eased(gy - j);
        sum += amplitude * std::lerp(std::lerp(hash(i, j, cell), hash(i + 1, j, cell), tx),
                                     std::lerp(hash(i, j + 1, cell), hash(i + 1, j + 1, cell), tx),
                                     ty);
    }
    return sum;
}

TEST(UvImageTest, anImageComesBackThroughTheFacesAtTheSameDensity)
{
    // 2 n² faces of 4^5 texels for as many pixels: n 2^5.5 across.
    constexpr std::uint32_t kCells = 8;
    const auto size = static_cast<int>(std::lround(kCells * std::exp2(5.5)));
    const TriangleMesh mesh = gridWithUvs(kCells);
    const TexelFormat format{TexelType::UInt8, 1, std::nullopt};
    Image image(size, size, format, {ColorSpace::Linear});
    std::vector<float> pixels;
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            pixels.push_back(static_cast<float>(natural(x, y)));
        }
    }
    encode(TexelType::UInt8, pixels, image.writable());
    decode(TexelType::UInt8, image.pixels(), pixels);
    for (const auto& [lookup, least] :
         {std::pair(ImageLookup::Bilinear, 45.0), {ImageLookup::Footprint, 45.0}}) {
        TexelStore store(static_cast<std::uint32_t>(mesh.faceCount()),
                         format,
                         Level(5),
                         std::vector<std::byte>(1));
        std::vector<FaceId> faces;
        for (std::uint32_t k = 0; k < mesh.faceCount(); ++k) {
            faces.push_back(faceId(k));
        }
        SamplerOptions options;
        options.lookup = lookup;
        const auto tiles = ImageTiles::make({{UdimTile{}, image, ""}}, options, Threads{2});
        NoProgress progress;
        ASSERT_TRUE(bake(store, faces, UvMapping(mesh), *tiles, {}, progress));
        UvImageOptions out = optionsOf(size, 4);
        out.type = TexelType::UInt8;
        const auto made = imageOf(mesh, store, out);
        ASSERT_TRUE(made);
        const auto back = valuesOf(made->image);
        double squares = 0;
        int count = 0;
        for (int y = 3; y < size - 3; ++y) { // away from the seam that the image's border is
            for (int x = 3; x < size - 3; ++x) {
                const auto k = static_cast<std::size_t>(y * size + x);
                squares += std::pow(static_cast<double>(back[k]) - pixels[k], 2);
                ++count;
            }
        }
        const double psnr = -10 * std::log10(squares / count);
        RecordProperty("psnr", std::to_string(psnr));
        std::cout << "PSNR of lookup " << static_cast<int>(lookup) << ": " << psnr << " dB\n";
        EXPECT_GE(psnr, least);
    }
}

} // namespace
} // namespace trixel
