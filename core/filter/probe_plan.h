// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>

namespace trixel {

/// Probes lie at (k + ½) steps, k = 0, 1, …, from the centre either way along the major axis, while
/// that is below the support, with weights exp(-c x²) - exp(-c), x = steps / support.
///
/// A probe blurs alike in all directions; what the footprint is longer than that along its major
/// axis is left to the weights. Everything changes continuously with the footprint, and weights are
/// 0 where the number of probes changes: nothing pops.
inline constexpr double kProbeFalloff = 3.1; ///< c
/// Support in sigmas: the weights' variance is (support / this)².
inline constexpr double kProbeSupport = 2.79445;
/// Probes a query may have, and room for as many.
inline constexpr int kMostProbes = 128;
/// Longest support to a side, in edges of faces about the centre: hostile footprints end there.
inline constexpr double kMostProbedEdges = 128.0;

/// What tells the probe methods apart.
struct ProbeSettings
{
    double spacing = 1.8;   ///< largest distance of two probes, in sigmas of one probe's blur
    double band = 1;        ///< of `levelBlend`
    int most = kMostProbes; ///< probes, even
};

/// How the number of probes is kept to `most`.
struct ProbeCap
{
    /// Smallest variance of a probe, as a fraction of that of the major axis: thinner footprints
    /// are blurred to it.
    double thinnest = 0;
    /// Smallest step, as a fraction of the support: (most + 1)/2 steps span it.
    double shortestStep = 0;
};
ProbeCap probeCap(const ProbeSettings& settings);

/// Where to probe for some queries: structure of arrays, one place a query.
struct ProbePlans
{
    static constexpr std::size_t kSize = 32;

    alignas(64) double u[kSize]; ///< centre, inside the face; its middle where not finite
    alignas(64) double v[kSize];
    alignas(64) double stepU[kSize]; ///< in (u,v) of the face
    alignas(64) double stepV[kSize];
    alignas(64) double support[kSize]; ///< in steps
    alignas(64) double fine[kSize];    ///< number of the finer level
    alignas(64) double coarse[kSize];  ///< weight of the coarser level, in [0, 1]
};

} // namespace trixel
