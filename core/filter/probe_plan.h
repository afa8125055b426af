// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>

namespace trixel {

// Probes lie at (k + ½) steps, k = 0, 1, …, from the centre either way along a line, while that is
// below the support, with weights exp(-c x²) - exp(-c), x = steps / support.
//
// A probe blurs alike in all directions; what the footprint is longer than that along its major
// axis is left to the weights. One blur of its width would do across, too, but it would be a poor
// Gaussian: it depends on where in a texel it lies, and midway between two levels it has too sharp
// a peak and too wide a foot. So footprints that are not much longer than wide get sharper probes,
// and a second, short line of them along the minor axis that makes up for what each lacks. Its
// share falls as they get longer, where the sum along the line evens all that out.
//
// Everything changes continuously with the footprint, and weights are 0 where the number of probes
// changes: nothing pops. Lines run along the axes, so that they stay where they are when only the
// lengths of the axes change, and do not sweep over vertices, where a surface that is not flat
// tears.

/// Share that the line across has of the answer for round footprints.
inline constexpr double kAcrossShare = 0.4;
/// Variance of its weights, as a fraction of that of the minor axis.
inline constexpr double kAcrossVariance = 0.8;
/// Anisotropy from which on one line is enough.
inline constexpr double kOneLine = 3.0;
/// A circle has no axes for lines: below this anisotropy they shrink to its centre.
inline constexpr double kDirected = 1.09;
/// Fewer probes than this are not worth a second line.
inline constexpr int kLeastOfTwoLines = 8;
/// Spacing goes with this power of the anisotropy: of many probes each matters less.
inline constexpr double kWidening = 0.3;

/// Probes that a line is planned to have, rounding aside, and room for more.
inline constexpr int kMostProbes = 128;
inline constexpr int kRoomPerLine = 1024;
/// Longest support to a side, in edges of faces about the centre: hostile footprints end there.
inline constexpr double kMostProbedEdges = 128.0;

/// What tells the probe methods apart.
struct ProbeSettings
{
    double band = 1;    ///< of `levelBlend`
    int most = 0;       ///< probes of a line, even
    double spacing = 0; ///< largest distance of two probes of round footprints, in sigmas of
                        ///< one probe's blur
    double falloff = 0; ///< c
    double support = 0; ///< in sigmas of the weights
    double across = 0;  ///< kAcrossShare; 0: always one line
};

/// Few probes are spent best far apart and with weights that end while they are still large, many
/// probes close together and with weights that reach further; both chosen by the least error on the
/// stored distribution.
/// \param most  even, in [2, kMostProbes]
ProbeSettings probeSettings(int most, double band);

/// How the number of probes is kept to `most`.
struct ProbeCap
{
    /// Smallest variance of a probe, as a fraction of that of the major axis: thinner footprints
    /// are blurred to it, and shortened by the 16th root of how much they would need to be.
    double thinnest = 0;
    /// Smallest step, as a fraction of the support: (most + 1)/2 steps span it.
    double shortestStep = 0;
};
ProbeCap probeCap(const ProbeSettings& settings);

/// Where to probe for some queries: structure of arrays, one place a query.
struct ProbePlans
{
    static constexpr std::size_t kSize = 128;

    alignas(64) double u[kSize]; ///< centre, inside the face; its middle where not finite
    alignas(64) double v[kSize];
    alignas(64) double stepU[kSize]; ///< in (u,v) of the face
    alignas(64) double stepV[kSize];
    alignas(64) double support[kSize]; ///< in steps
    alignas(64) double crossU[kSize];  ///< the same of the line across
    alignas(64) double crossV[kSize];
    alignas(64) double crossSupport[kSize];
    alignas(64) double crossShare[kSize]; ///< of the answer; 0: there is no such line
    alignas(64) double fine[kSize];       ///< number of the finer level; one beyond a face's own
                                          ///< means the detail of its texels
    alignas(64) double coarse[kSize];     ///< weight of the coarser level, in [0, 1]
};

} // namespace trixel
