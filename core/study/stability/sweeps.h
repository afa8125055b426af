// SPDX-License-Identifier: GPL-3.0-or-later
//
// The sweeps themselves, and what they have in common.
#pragma once

#include "core/study/stability/stability.h"

#include <cmath>
#include <limits>
#include <random>

namespace trixel::sweeps {

// Footprints
StabilitySweep parallelVectors();
StabilitySweep minorAxis();
StabilitySweep nearCircle();
StabilitySweep vectorLength();
// Cameras
StabilitySweep silhouette();
StabilitySweep cameraPlane();
StabilitySweep atlasSeam();
// Mappings
StabilitySweep sphereSeam();
StabilitySweep sphereQuadrants();
StabilitySweep spherePole();
StabilitySweep parallelogram();
StabilitySweep flatQuad();
StabilitySweep bowTie();
// Lattice and weights
StabilitySweep texelPrecision();
StabilitySweep texelBorders();
StabilitySweep gaussianRuns();
StabilitySweep storedTextures();
// Filters, every method of the table
StabilitySweep narrowFootprints();
StabilitySweep longFootprints();
StabilitySweep constantTexels();
StabilitySweep nanTexels();
StabilitySweep needleFaces();
StabilitySweep valence();
StabilitySweep levelStep();

/// Sum of the weights of one row of a face's texels, as the kernel of `exact` adds them:
/// exp((offset - |start + k step|²) / 2), k from 0 below the resolution.
/// \param start, step  in standard deviations
double exactRowWeight(Level level, glm::dvec2 start, glm::dvec2 step, double offset);

inline constexpr double kNoAnswer = std::numeric_limits<double>::infinity();

/// |found - expected| / |expected|, infinite where `found` is not a number.
inline double relativeError(double found, long double expected)
{
    if (!std::isfinite(found)) {
        return kNoAnswer;
    }
    const long double off = std::abs(static_cast<long double>(found) - expected);
    return off == 0 ? 0.0 : static_cast<double>(off / std::abs(expected));
}

/// The larger error, where NaN is the largest.
inline double worse(double a, double b)
{
    return std::isnan(a) || std::isnan(b) ? kNoAnswer : std::max(a, b);
}

/// A value as people write it: "0.25", "1e-6", "Inf", "NaN".
SweepValue sweepValue(double value);

/// from, from·ratio, … while not beyond `to`, then whatever `further` lists.
std::vector<SweepValue>
geometric(double from, double to, double ratio, std::initializer_list<double> further = {});

/// Numbers that are the same on every machine.
class SweepRandom
{
public:
    /// Uniform in [low, high).
    double in(double low, double high)
    {
        return low + (high - low) * (static_cast<double>(m_engine()) * 0x1p-32);
    }

private:
    std::mt19937 m_engine{20};
};

/// Fills a naive curve and a robust one: errors of one value by measure(value, robust).
template <class Measure>
void addCurves(StabilitySweep& sweep,
               std::string naiveForm,
               std::string robustForm,
               const Measure& measure)
{
    StabilityCurve naive{std::move(naiveForm), true, {}};
    StabilityCurve robust{std::move(robustForm), false, {}};
    for (const SweepValue& value : sweep.values) {
        const auto [naiveError, robustError] = measure(value.at);
        naive.errors.push_back(std::isnan(naiveError) ? kNoAnswer : naiveError);
        robust.errors.push_back(std::isnan(robustError) ? kNoAnswer : robustError);
    }
    sweep.curves.push_back(std::move(naive));
    sweep.curves.push_back(std::move(robust));
}

/// Errors of the two forms at one value, the worst of several trials.
struct ErrorPair
{
    double naive = 0;
    double robust = 0;

    void add(double naiveError, double robustError)
    {
        naive = worse(naive, naiveError);
        robust = worse(robust, robustError);
    }
};

} // namespace trixel::sweeps
