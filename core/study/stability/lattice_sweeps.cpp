// SPDX-License-Identifier: GPL-3.0-or-later
//
// Texels under points, weights along rows, and textures that are data.
#include "core/filter/exact_kernel.h"
#include "core/lattice/texel.h"
#include "core/study/stability/naive_forms.h"
#include "core/study/stability/sweeps.h"
#include "core/study/test_scene.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <vector>

namespace trixel::sweeps {

namespace {

/// As a file or a query stores it. Not inlined: the vectoriser of GCC 12 takes a pair of doubles
/// that become floats and doubles again for unchanged.
[[gnu::noinline]] float asStored(double coordinate)
{
    return static_cast<float>(coordinate);
}

/// Distance of a point from a texel, in texels; infinite for a texel that does not exist.
double distanceFrom(Level level, TexelCoord texel, long double u, long double v)
{
    if (!isValid(level, texel)) {
        return kNoAnswer;
    }
    const long double x = u * level.resolution() - texel.i;
    const long double y = v * level.resolution() - texel.j;
    const long double beyond = (x + y - 1) / std::numbers::sqrt2_v<long double>;
    const long double distance = texel.half == TexelHalf::Lower
                                     ? std::max({-x, -y, beyond, 0.0L})
                                     : std::max({x - 1, y - 1, -beyond, 0.0L});
    return static_cast<double>(distance);
}

/// A point of the border, and what it is called.
struct BorderPoint
{
    std::string label;
    double u = 0;
    double v = 0;
};

std::vector<BorderPoint> borderPoints()
{
    constexpr double kUlp = 0x1p-24; // of a float just below 1
    constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
    return {{"inside", 0.3, 0.3},
            {"u=v=0", 0, 0},
            {"u=-ulp", -kUlp, 0.25},
            {"v=-ulp", 0.25, -kUlp},
            {"u+v=1-ulp", 0.375, 0.625 - kUlp},
            {"u+v=1", 0.375, 0.625},
            {"u+v=1+ulp", 0.375, 0.625 + kUlp},
            {"u+v=1+ulp, off the lattice", 1.0 / 3, 2.0 / 3 + kUlp},
            {"u=1", 1, 0},
            {"v=1", 0, 1},
            {"u=1+ulp", 1 + kUlp, 0},
            {"v=1+ulp", 0, 1 + kUlp},
            {"NaN", kNaN, kNaN}};
}

/// Of bytes, as FNV-1a.
std::uint64_t hashOf(std::string_view bytes)
{
    std::uint64_t hash = 0xCBF29CE484222325ULL;
    for (const char c : bytes) {
        hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001B3ULL;
    }
    return hash;
}

/// Of the stored textures and queries, as they were when methods were last compared on them.
constexpr std::uint64_t kNaturalHash = 0xEA0B57847B22628BULL;
constexpr std::uint64_t kHardEdgedHash = 0xAD6E1256275B1423ULL;
constexpr std::uint64_t kQueriesHash = 0x5B1B4B811DBC2C53ULL;

} // namespace

StabilitySweep texelPrecision()
{
    StabilitySweep sweep{.name = "texel-precision",
                         .title = "u R in single precision",
                         .hazard = "Positions in an atlas or on a whole mesh leave few digits for "
                                   "the place in a texel.",
                         .property = "The texel found is within 1.5 R 2\u207B\u00B2\u2074 texels "
                                     "of the point.",
                         .axisTitle = "R",
                         .errorTitle = "distance over R 2\u207B\u00B2\u2074",
                         .bound = 1.5};
    for (int level = 0; level <= Level::kMax; ++level) {
        sweep.values.push_back(sweepValue(1U << static_cast<unsigned>(level)));
    }
    addCurves(sweep, "float, origin in an atlas", "cell and fraction of the face", [](double r) {
        const Level level(static_cast<int>(std::lround(std::log2(r))));
        ErrorPair errors;
        SweepRandom random;
        for (int k = 0; k < 2000; ++k) {
            // Inside the face, every other point next to a line between texels.
            const double reach = std::floor(random.in(0, 1) * r) / r;
            const double near = random.in(-1, 1) * 0x1p-23;
            const double u = k % 2 == 0 ? random.in(0.01, 0.99) : std::max(reach + near, 0x1p-20);
            const double v = random.in(0, 1) * (0.999 - u);
            if (v < 0) {
                continue;
            }
            const glm::dvec2 stored(asStored(u), asStored(v));
            const auto error = [&](TexelCoord texel) {
                return distanceFrom(level, texel, u, v) / (r * 0x1p-24);
            };
            errors.add(error(naive::texelInAtlas(level, stored)), error(texelAt(level, stored)));
        }
        return errors;
    });
    return sweep;
}

StabilitySweep texelBorders()
{
    StabilitySweep sweep{.name = "texel-borders",
                         .title = "On the border of the face: u + v = 1 \u00B1 ulp",
                         .hazard = "Unclamped, v = 1 reads out of bounds and u = 1 wraps into the "
                                   "next row.",
                         .property = "The texel exists and is within 1.5 R 2\u207B\u00B2\u2074 "
                                     "texels of the point, at every R.",
                         .axisTitle = "place",
                         .axis = SweepAxis::Listed,
                         .errorTitle = "distance over R 2\u207B\u00B2\u2074",
                         .bound = 1.5};
    const auto points = borderPoints();
    for (std::size_t k = 0; k < points.size(); ++k) {
        sweep.values.push_back({static_cast<double>(k), points[k].label});
    }
    addCurves(sweep, "floor, unclamped", "clamped before the fraction", [&](double index) {
        const BorderPoint& point = points[static_cast<std::size_t>(index)];
        ErrorPair errors;
        for (int n = 0; n <= Level::kMax; ++n) {
            const Level level(n);
            const auto error = [&](TexelCoord texel) {
                const double distance = distanceFrom(level, texel, point.u, point.v);
                // NaN is nowhere: any texel that exists will do.
                return std::isnan(point.u) ? (isValid(level, texel) ? 0 : kNoAnswer)
                                           : distance / (level.resolution() * 0x1p-24);
            };
            errors.add(error(naive::unclampedTexelAt(level, {point.u, point.v})),
                       error(texelAt(level, glm::dvec2(point.u, point.v))));
        }
        return errors;
    });
    return sweep;
}

double exactRowWeight(Level level, glm::dvec2 start, glm::dvec2 step, double offset)
{
    // Other rows lie beyond any cut, and all texels are alike.
    constexpr double kBeyond = 1e9;
    HalfLattice row(TexelHalf::Lower, level, {0, 0}, {1, 0}, {0, 1});
    row.origin = start;
    row.alongRow = step;
    row.perRow = {0, kBeyond};
    const std::array<float, kGroupChannels> one{1, 1, 1, 1};
    ExactSums sums;
    addExactly({one.data(), 0}, row, kBeyond / 1e3, offset, 1, sums);
    return sums.weight;
}

StabilitySweep gaussianRuns()
{
    StabilitySweep sweep{.name = "gaussian-runs",
                         .title = "Gaussian weights along long rows",
                         .hazard = "Products of factors drift, and cannot leave 0 again.",
                         .property = "The weights of a row, as exact adds them, sum to those of "
                                     "exp.",
                         .axisTitle = "texels in the row",
                         .errorTitle = "error over the sum",
                         .bound = 1e-5,
                         .values = geometric(8, Level(Level::kMax).resolution(), 2)};
    addCurves(sweep, "one product, float", "anew from exp", [](double count) {
        ErrorPair errors;
        const Level level(static_cast<int>(std::lround(std::log2(count))));
        // From so many standard deviations on one side to as many on the other.
        for (const double reach : {6.0, 12.0}) {
            const glm::dvec2 start(-reach, 0.3);
            const glm::dvec2 step(2 * reach / count, 1e-3 / count);
            std::vector<double> textbook(level.resolution());
            naive::gaussianWeights(start, step, 0, textbook);
            const double product = std::accumulate(textbook.begin(), textbook.end(), 0.0);
            long double truth = 0;
            for (std::uint32_t k = 0; k < level.resolution(); ++k) {
                const long double x = start.x + static_cast<long double>(k) * step.x;
                const long double y = start.y + static_cast<long double>(k) * step.y;
                truth += std::exp(-(x * x + y * y) / 2);
            }
            const auto error = [&](double sum) {
                return static_cast<double>(std::abs((sum - truth) / truth));
            };
            errors.add(error(product), error(exactRowWeight(level, start, step, 0)));
        }
        return errors;
    });
    return sweep;
}

StabilitySweep storedTextures()
{
    StabilitySweep sweep{.name = "stored-textures",
                         .title = "Test textures: computed or stored",
                         .hazard = "Builds with and without fused multiply-add compute other "
                                   "texels.",
                         .property = "The texels are the same in every build: those that are "
                                     "stored have the hash they had.",
                         .axisTitle = "coordinate of the texel",
                         .errorTitle = "difference between builds",
                         .bound = 0.5 / 255,
                         .values = geometric(1, 1e6, 10)};
    const TestDataFiles files = storedTestFiles();
    const bool unchanged = hashOf(files.natural) == kNaturalHash &&
                           hashOf(files.hardEdged) == kHardEdgedHash &&
                           hashOf(files.queries) == kQueriesHash;
    addCurves(sweep, "noise from coordinates", "data, by hash", [&](double coordinate) {
        ErrorPair errors;
        SweepRandom random;
        for (int k = 0; k < 256; ++k) {
            const auto x = static_cast<float>(coordinate * random.in(0.5, 1));
            const auto y = static_cast<float>(coordinate * random.in(0.5, 1));
            const float with = naive::proceduralNoise(x, y, true);
            const float without = naive::proceduralNoise(x, y, false);
            errors.add(static_cast<double>(std::abs(with - without)), unchanged ? 0 : 1);
        }
        return errors;
    });
    return sweep;
}

} // namespace trixel::sweeps
