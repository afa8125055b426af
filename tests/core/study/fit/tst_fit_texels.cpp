// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lattice/texel.h"
#include "core/study/fit/fit_equations.h"
#include "core/study/fit/fit_patches.h"
#include "core/study/fit/fitted_texels.h"
#include "core/texture/level_change.h"
#include "tests/core/test_meshes.h"

#include <cmath>
#include <cstring>
#include <gmock/gmock.h>
#include <random>

namespace trixel {
namespace {

/// A sphere of 80 faces, levels 1 to 3 mixed, noise of one channel.
struct Scene
{
    std::shared_ptr<const Surface> surface;
    std::shared_ptr<const FilterSurface> shapes;
    TexelStore texels;
    FilterScene filters;
};

TexelFormat oneFloat()
{
    TexelFormat format;
    format.type = TexelType::Float;
    format.channels = 1;
    return format;
}

FaceTexels noise(Level level, std::mt19937& random)
{
    std::uniform_real_distribution<float> unit(0.2F, 0.8F);
    std::vector<float> values(level.texelCount());
    for (float& value : values) {
        value = unit(random);
    }
    return FaceTexels::full(level, sizeof(float), std::as_bytes(std::span(values)));
}

const Scene& scene()
{
    static const Scene made = [] {
        NoProgress progress;
        Scene s;
        s.surface = Surface::build(test::sphereMesh(1), progress).value();
        const TriangleMesh& mesh = s.surface->mesh();
        s.shapes =
            std::make_shared<FilterSurface>(FilterSurface::fromMesh(mesh, s.surface->adjacency()));
        const float grey = 0.5F;
        s.texels = TexelStore(static_cast<std::uint32_t>(mesh.faceCount()),
                              oneFloat(),
                              Level(2),
                              std::as_bytes(std::span(&grey, 1)));
        std::mt19937 random(3);
        for (std::uint32_t f = 0; f < mesh.faceCount(); ++f) {
            s.texels.exchange(faceId(f), noise(Level(1 + static_cast<int>(f % 3)), random));
        }
        s.filters = FilterScene::build(s.shapes, s.texels, Threads{1}, progress).value();
        return s;
    }();
    return made;
}

/// Four points a face and more, seen with footprints of a fifth of an edge.
struct Looks
{
    QueryArrays points;
    std::vector<PointRange> ranges;
};

Looks looksAt(Level level)
{
    Looks looks;
    for (std::uint32_t f = 0; f < scene().texels.faceCount(); ++f) {
        const auto [w1, w2] = roundFootprint(scene().shapes->shape(faceId(f)), 0.1);
        for (std::uint32_t t = 0; t < level.texelCount(); ++t) {
            const glm::dvec2 uv = centroid(level, texelAt(level, static_cast<TexelIndex>(t)));
            looks.points.add(faceId(f), glm::vec2(uv), w1, w2);
        }
        looks.ranges.push_back({faceId(f), level.texelCount(), 1.0F + static_cast<float>(f % 2)});
    }
    return looks;
}

FitEquations equationsOf(const Looks& looks, unsigned threads = 2)
{
    NoProgress progress;
    return FitEquations::make(
               scene().filters, looks.points, looks.ranges, Threads{threads}, progress)
        .value();
}

std::vector<Quad> texelsOf(const FitEquations& equations)
{
    std::vector<Quad> texels(equations.texelCount(), Quad(0));
    for (const FaceId face : equations.faces()) {
        const FaceTexels& from = scene().texels.face(face);
        for (std::uint32_t t = 0; t < from.level().texelCount(); ++t) {
            std::memcpy(
                &texels[*equations.firstTexel(face) + t][0], from.texel(t).data(), sizeof(float));
        }
    }
    return texels;
}

std::vector<Quad> wantedOf(const Looks& looks)
{
    NoProgress progress;
    const auto values =
        seenThroughExact(scene().filters, looks.points, Threads{2}, progress).value();
    std::vector<Quad> wanted;
    for (const float value : values) {
        wanted.emplace_back(value, 0, 0, 0);
    }
    return wanted;
}

double rmsOf(std::span<const Quad> missing)
{
    double sum = 0;
    for (const Quad& value : missing) {
        sum += value[0] * value[0];
    }
    return std::sqrt(sum / static_cast<double>(missing.size()));
}

FaceMap<char> everyFace(char isFree = 1)
{
    return FaceMap<char>(scene().texels.faceCount(), isFree);
}

std::vector<Quad> solved(const Looks& looks,
                         std::vector<Quad>& texels,
                         const FaceMap<char>& isFree,
                         FitEquations::Bounds bounds,
                         int steps,
                         unsigned threads = 2)
{
    NoProgress progress;
    return equationsOf(looks, threads)
        .solve(wantedOf(looks), isFree, bounds, steps, texels, Threads{threads}, progress)
        .value();
}

/// What is left after the cut at 3.5 standard deviations.
constexpr double kCutError = 3e-3;

TEST(WeightBlock, seesWhatExactSees)
{
    const Looks looks = looksAt(Level(2));
    const WeightBlock block(scene().filters, looks.points.queries());
    std::vector<Quad> texels(block.texelCount());
    for (const TexelRange& range : block.ranges()) {
        for (std::uint32_t t = 0; t < range.count; ++t) {
            float value = 0;
            std::memcpy(&value, scene().texels.face(range.face).texel(t).data(), sizeof(float));
            texels[range.first + t] = Quad(value, 1, 0, 0);
        }
    }
    std::vector<Quad> seen(block.pointCount());
    block.look(texels, seen);
    const std::vector<Quad> wanted = wantedOf(looks);
    for (std::size_t p = 0; p < seen.size(); ++p) {
        EXPECT_NEAR(seen[p][0], wanted[p][0], kCutError);
        EXPECT_NEAR(seen[p][1], 1, 1e-5) << "weights add up to 1";
    }
}

TEST(WeightBlock, spreadingIsLookingTransposed)
{
    const Looks looks = looksAt(Level(1));
    const WeightBlock block(scene().filters, looks.points.queries());
    std::mt19937 random(5);
    std::uniform_real_distribution<float> unit(-1, 1);
    const auto fill = [&](std::vector<Quad>& values) {
        for (Quad& value : values) {
            value = {unit(random), unit(random), unit(random), unit(random)};
        }
    };
    std::vector<Quad> texels(block.texelCount());
    std::vector<Quad> points(block.pointCount());
    fill(texels);
    fill(points);
    std::vector<Quad> seen(block.pointCount());
    block.look(texels, seen);
    std::vector<Quad> back(block.texelCount(), Quad(0));
    block.spread(points, back);
    for (int c = 0; c < 4; ++c) {
        double there = 0;
        double here = 0;
        for (std::size_t p = 0; p < seen.size(); ++p) {
            there += static_cast<double>(seen[p][c]) * points[p][c];
        }
        for (std::size_t t = 0; t < back.size(); ++t) {
            here += static_cast<double>(back[t][c]) * texels[t][c];
        }
        EXPECT_NEAR(there, here, 1e-3);
    }
}

TEST(FitEquations, findTexelsThatLookAsWanted)
{
    const Looks looks = looksAt(Level(3));
    const FitEquations equations = equationsOf(looks);
    std::vector<Quad> texels(equations.texelCount(), Quad(0.5F, 0, 0, 0));
    const double before = rmsOf(solved(looks, texels, everyFace(), {0, 1}, 0));
    const double after = rmsOf(solved(looks, texels, everyFace(), {0, 1}, 40));
    EXPECT_GT(before, 0.02);
    EXPECT_LT(after, 0.05 * before);
}

TEST(FitEquations, keepTheBoundsAndWhatIsNotFree)
{
    const Looks looks = looksAt(Level(3));
    const FitEquations equations = equationsOf(looks);
    FaceMap<char> isFree = everyFace();
    isFree[faceId(7)] = 0;
    std::vector<Quad> texels(equations.texelCount(), Quad(0.5F, 0, 0, 0));
    const FitEquations::Bounds bounds{0.45F, 0.55F};
    solved(looks, texels, isFree, bounds, 10);
    std::size_t atBounds = 0;
    for (const Quad& texel : texels) {
        EXPECT_GE(texel[0], bounds.least);
        EXPECT_LE(texel[0], bounds.most);
        atBounds += texel[0] == bounds.least || texel[0] == bounds.most ? 1 : 0;
    }
    EXPECT_GT(atBounds, 100U) << "they matter";
    const std::size_t first = *equations.firstTexel(faceId(7));
    for (std::size_t t = 0; t < scene().texels.face(faceId(7)).level().texelCount(); ++t) {
        EXPECT_EQ(texels[first + t][0], 0.5F);
    }
}

TEST(FitEquations, leaveOutWhatIsNotFinite)
{
    const Looks looks = looksAt(Level(2));
    const FitEquations equations = equationsOf(looks);
    std::vector<Quad> texels = texelsOf(equations);
    const std::size_t bad = *equations.firstTexel(faceId(4));
    texels[bad][0] = NAN;
    std::vector<Quad> wanted = wantedOf(looks);
    wanted[100][0] = NAN;
    NoProgress progress;
    const auto missing =
        equations.solve(wanted, everyFace(), {0, 1}, 8, texels, Threads{2}, progress).value();
    EXPECT_TRUE(std::isnan(missing[100][0]));
    std::size_t leftOut = 0;
    for (const Quad& value : missing) {
        leftOut += std::isnan(value[0]) ? 1 : 0;
    }
    EXPECT_LT(leftOut, missing.size() / 4) << "only what sees the texel";
    for (std::size_t t = 0; t < texels.size(); ++t) {
        EXPECT_EQ(std::isnan(texels[t][0]), t == bad);
    }
}

TEST(FitEquations, doNotDependOnThreads)
{
    const Looks looks = looksAt(Level(2));
    std::vector<Quad> one(equationsOf(looks).texelCount(), Quad(0.5F, 0, 0, 0));
    std::vector<Quad> many = one;
    solved(looks, one, everyFace(), {0, 1}, 6, 1);
    solved(looks, many, everyFace(), {0, 1}, 6, 4);
    EXPECT_EQ(one, many);
}

FitSource sourceOf(const SceneViews& views)
{
    NoProgress progress;
    return FitSource::make(
               *scene().surface, scene().texels, views, UnseenFaces::OneTexel, Threads{2}, progress)
        .value();
}

SceneViews nearViews()
{
    return {{}, {{"any", 3, 40, 100, 100}}};
}

TEST(Coarsener, movesOnlyFacesAboutCoarserOnes)
{
    const FitSource source = sourceOf(nearViews());
    FaceMap<Level> levels = levelsOf(scene().texels);
    const FaceId coarser = faceId(2);
    ASSERT_EQ(levels[coarser], Level(3));
    levels[coarser] = Level(2);
    NoProgress progress;
    const FittedTexels fitted = Coarsener(source).fitted(levels, 4, Threads{2}, progress).value();
    const VertexRings& rings = scene().shapes->rings();
    std::size_t moved = 0;
    for (std::uint32_t f = 0; f < levels.size(); ++f) {
        bool isNear = false;
        for (std::uint8_t corner = 0; corner < 3; ++corner) {
            for (const Corner& near : rings.corners(rings.ring({faceId(f), corner}))) {
                isNear = isNear || near.face == coarser;
            }
        }
        EXPECT_EQ(fitted.isMoved[faceId(f)] != 0, isNear);
        EXPECT_EQ(fitted.texels.face(faceId(f)) == scene().texels.face(faceId(f)), !isNear);
        moved += isNear ? 1 : 0;
    }
    EXPECT_GT(moved, 6U);
    EXPECT_LT(moved, levels.size());
}

TEST(FitPatches, holdEveryFaceAndKeepWithinTheirRoom)
{
    const FitSource source = sourceOf({{}, {{"any", 3, 40, 400, 400}}});
    const FitPatches patches = fitPatches(scene().surface->adjacency(), source.samples);
    std::vector<bool> isIn(scene().texels.faceCount());
    EXPECT_GT(patches.size(), 4U);
    for (std::size_t p = 0; p < patches.size(); ++p) {
        double pixels = 0;
        for (const FaceId face : patches.patch(p)) {
            isIn[indexOf(face)] = true;
            pixels += source.samples.pixels[face];
        }
        EXPECT_GE(pixels, kPatchPixels);
    }
    EXPECT_THAT(isIn, testing::Each(true));

    FitOptions options;
    const double most = 1;
    for (const double error : {0.0, 0.7, 2.0, 30.0}) {
        options.errors.emplace_back(scene().texels.faceCount(), error);
    }
    FaceMap<int> steps(scene().texels.faceCount(), 0);
    chooseSteps(patches, source.samples, options, levelsOf(scene().texels), most, 1, steps);
    FaceMap<double> squares(steps.size());
    int given = 0;
    for (std::uint32_t f = 0; f < steps.size(); ++f) {
        EXPECT_LT(steps[faceId(f)], 3) << "worse than any face may be";
        given += steps[faceId(f)];
        squares[faceId(f)] = options.errors[static_cast<std::size_t>(steps[faceId(f)])][faceId(f)];
    }
    EXPECT_GT(given, 40);
    for (std::size_t p = 0; p < patches.size(); ++p) {
        EXPECT_LE(patchMeanSquare(patches.patch(p), source.samples, squares), most * (1 + 1e-9));
    }
}

} // namespace
} // namespace trixel
