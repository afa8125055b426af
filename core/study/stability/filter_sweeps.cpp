// SPDX-License-Identifier: GPL-3.0-or-later
//
// What every filter has to keep wherever it is asked: constants, its taps, and NaN where it is.
#include "core/filter/filter_method.h"
#include "core/filter/query_ellipse.h"
#include "core/study/stability/filter_cases.h"
#include "core/study/stability/naive_forms.h"
#include "core/study/stability/scenes.h"

#include <array>
#include <glm/geometric.hpp>
#include <numbers>

namespace trixel::sweeps {

namespace {

/// Two units in the last place of a float.
constexpr double kTwoUlp = 0x1p-22;

bool keepsConstants(const MethodEntry& entry)
{
    return entry.claims.constantKept == Claim::Yes;
}

/// Methods that promise at most `kMostTaps`; the exact and the base-level ones refuse instead.
bool limitsTaps(const MethodEntry& entry)
{
    return entry.name != "exact" && entry.name != "ewa-base";
}

/// Relative deviation of every answer from the constant that all texels have.
double constantError(const FilterCase& filterCase, const FilterMethod& method, float constant)
{
    const ResultArrays results = answersOf(filterCase, method);
    double error = 0;
    for (const float value : results.values) {
        error = worse(error, relativeError(static_cast<double>(value), constant));
    }
    return error;
}

FilterCase flatCase(Level level, const TexelValue& value)
{
    TriangleMesh mesh = pairOfFaces();
    const std::array<Level, 2> levels{level, level};
    return {sceneOf(mesh, levels, value), {}};
}

FilterCase constantCase(float constant)
{
    return flatCase(Level(4), [=](FaceId, Level, TexelIndex) { return constant; });
}

/// Queries at a few places of a face, W round and of a width given in edges.
void addRound(FilterCase& filterCase, FaceId face, double width)
{
    for (const glm::vec2 uv : {glm::vec2(0.3F, 0.3F), {0.01F, 0.7F}, {0.5F, 0.5F}, {0, 0}}) {
        const auto w = static_cast<float>(width);
        const auto across = static_cast<float>(2 * width / std::numbers::sqrt3);
        filterCase.queries.add(face, uv, {w, 0}, {-across / 2, across});
    }
}

/// Largest distance between (u,v) and what it becomes through the plane and back.
double roundTripError(const FaceShape& shape)
{
    double error = 0;
    for (const glm::dvec2 uv : {glm::dvec2(0.3, 0.3), {1, 0}, {0, 1}, {0.1, 0.8}}) {
        const double off = glm::length(shape.toUv(shape.toPlane(uv)) - uv);
        error = worse(error, std::isfinite(off) ? off : kNoAnswer);
    }
    return error;
}

/// A needle between three ordinary faces; its height may be 0.
TriangleMesh needleMesh(double height)
{
    TriangleMesh mesh;
    mesh.positions = {{0, 0, 0},
                      {1, 0, 0},
                      {0.5F, static_cast<float>(height), 0},
                      {0.5F, -0.9F, 0},
                      {0.5F, 1.9F, 0}};
    mesh.triangles = {{0, 1, 2}, {0, 3, 1}, {2, 1, 4}, {0, 2, 4}};
    return mesh;
}

} // namespace

StabilitySweep narrowFootprints()
{
    StabilitySweep sweep{.name = "narrow-footprints",
                         .title = "Footprints far below a texel",
                         .hazard = "All weights underflow and their sum is 0: 0/0.",
                         .property = "Constant in, constant out, within 2 ulp.",
                         .axisTitle = "width of W (texels)",
                         .errorTitle = "relative error",
                         .bound = kTwoUlp,
                         .values = geometric(4, 1e-3, 0.5, {1e-6, 1e-12, 1e-30, 1e-44, 0})};
    FilterCase filterCase = constantCase(0.7F);
    addFilterCurves(sweep, "no floor under the variance", keepsConstants, [&](double width) {
        filterCase.queries = {};
        addRound(filterCase, FaceId{0}, width / 16);
        const float textbook = naive::rowAverage(0.7F, static_cast<float>(width / 2));
        return FilterErrors{
            relativeError(static_cast<double>(textbook), 0.7F),
            [&](const FilterMethod& method) { return constantError(filterCase, method, 0.7F); }};
    });
    return sweep;
}

StabilitySweep longFootprints()
{
    StabilitySweep sweep{.name = "long-footprints",
                         .title = "Anisotropy to a million",
                         .hazard = "One probe for each width of the minor axis takes millions of "
                                   "taps.",
                         .property = "At most 4,096 taps, and constants are kept within 2 ulp.",
                         .axisTitle = "anisotropy",
                         .errorTitle = "taps over 4,096",
                         .bound = 1,
                         .values = geometric(1, 1e6, std::sqrt(10.0))};
    FilterCase filterCase{pillowScene(0.7F), {}};
    addFilterCurves(sweep, "a probe every minor \u03C3", limitsTaps, [&](double anisotropy) {
        constexpr float kLongest = 64;
        filterCase.queries = {};
        for (int k = 0; k < 3; ++k) {
            const double turn = std::numbers::pi * k / 3;
            const glm::vec2 along(std::cos(turn), std::sin(turn));
            const auto shorter = static_cast<float>(static_cast<double>(kLongest) / anisotropy);
            filterCase.queries.add(
                FaceId{0}, {0.3F, 0.3F}, kLongest * along, shorter * glm::vec2(-along.y, along.x));
        }
        // Three standard deviations to both sides, three vertices a probe.
        const double textbookTaps = 3 * 6 * anisotropy;
        return FilterErrors{textbookTaps / kMostTaps, [&](const FilterMethod& method) {
                                const ResultArrays results = answersOf(filterCase, method);
                                double error = constantError(filterCase, method, 0.7F) <= kTwoUlp
                                                   ? 0
                                                   : kNoAnswer;
                                for (const std::uint32_t taps : results.taps) {
                                    error = worse(error, static_cast<double>(taps) / kMostTaps);
                                }
                                return error;
                            }};
    });
    return sweep;
}

StabilitySweep constantTexels()
{
    StabilitySweep sweep{.name = "constant-texels",
                         .title = "Constant textures",
                         .hazard = "Weights whose sum is taken from calculus do not add up to 1.",
                         .property = "Constant in, constant out, within 2 ulp.",
                         .axisTitle = "value of every texel",
                         .errorTitle = "relative error",
                         .bound = kTwoUlp,
                         .values = geometric(1e-30, 1e30, 1e6)};
    addFilterCurves(sweep, "not normalised", keepsConstants, [&](double value) {
        const auto constant = static_cast<float>(value);
        FilterCase filterCase = constantCase(constant);
        for (const double width : {0.01, 0.1, 0.6, 3.0}) {
            addRound(filterCase, FaceId{0}, width);
        }
        const float textbook = naive::rowAverageUnnormalised(constant, 0.4F);
        return FilterErrors{
            relativeError(static_cast<double>(textbook), constant),
            [filterCase = std::move(filterCase), constant](const FilterMethod& method) {
                return constantError(filterCase, method, constant);
            }};
    });
    return sweep;
}

StabilitySweep nanTexels()
{
    StabilitySweep sweep{.name = "nan-texels",
                         .title = "A NaN texel near the footprint",
                         .hazard = "0 \u00B7 NaN is NaN: a texel without weight spoils the sum.",
                         .property = "A NaN farther away than 16 texels does not come out of a "
                                     "footprint 2 texels wide.",
                         .axisTitle = "distance of the NaN (texels)",
                         .axis = SweepAxis::Linear,
                         .errorTitle = "NaN out where none is under",
                         .bound = 0};
    for (const int distance : {0, 2, 4, 8, 12, 16, 20, 24, 28, 32, 36}) {
        sweep.values.push_back(sweepValue(distance));
    }
    addFilterCurves(
        sweep,
        "every weight counts",
        [](const MethodEntry&) { return true; },
        [](double distance) {
            const Level level(6);
            const auto column = static_cast<std::uint16_t>(12 + std::lround(distance));
            const TexelIndex bad = texelIndex(level, TexelCoord{column, 12, TexelHalf::Lower});
            FilterCase filterCase = flatCase(level, [&](FaceId face, Level, TexelIndex texel) {
                return face == FaceId{0} && texel == bad ? std::numeric_limits<float>::quiet_NaN()
                                                         : 0.5F;
            });
            const float w = 2.0F / 64;
            filterCase.queries.add(FaceId{0}, {0.2F, 0.2F}, {w, 0}, {-w / 2, w});
            const bool isUnder = distance < 16;
            const auto verdict = [=](float value) {
                return isUnder || std::isfinite(value) ? 0.0 : kNoAnswer;
            };
            return FilterErrors{
                verdict(naive::rowAverageWithNaN(static_cast<int>(distance), 1.0F)),
                [filterCase = std::move(filterCase), verdict](const FilterMethod& method) {
                    return verdict(answersOf(filterCase, method).values.front());
                }};
        });
    return sweep;
}

StabilitySweep needleFaces()
{
    StabilitySweep sweep{.name = "needle-faces",
                         .title = "Needles and faces without area",
                         .hazard = "A face without area has no plane: its shape cannot be "
                                   "inverted.",
                         .property = "Every shape leads back to its (u,v), and constants are kept "
                                     "on it and about it.",
                         .axisTitle = "height over length",
                         .errorTitle = "error of (u,v), or relative error",
                         .bound = 1e-6,
                         .values = geometric(1, 1e-12, 0.1, {1e-20, 1e-40, 0})};
    std::vector<double> shapeErrors;
    addFilterCurves(sweep, "shape as it comes", keepsConstants, [&](double height) {
        const TriangleMesh mesh = needleMesh(height);
        const std::vector<Level> levels(mesh.faceCount(), Level(3));
        FilterCase filterCase{sceneOf(mesh, levels, [](FaceId, Level, TexelIndex) { return 0.7F; }),
                              {}};
        for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
            addRound(filterCase, faceId(f), 0.1);
            addRound(filterCase, faceId(f), 1.5);
        }
        ErrorPair shapes;
        auto corners = mesh.corners(FaceId{0});
        for (int turn = 0; turn < 3; ++turn) {
            std::ranges::rotate(corners, corners.begin() + 1);
            shapes.add(roundTripError(naive::faceShapeOf(corners)),
                       roundTripError(faceShapeOf(corners)));
        }
        shapeErrors.push_back(shapes.robust);
        return FilterErrors{shapes.naive,
                            [filterCase = std::move(filterCase)](const FilterMethod& method) {
                                return constantError(filterCase, method, 0.7F);
                            }};
    });
    sweep.curves.insert(sweep.curves.begin() + 1, {"shape of a face", false, shapeErrors});
    return sweep;
}

} // namespace trixel::sweeps
