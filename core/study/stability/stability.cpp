// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/stability/stability.h"

#include "core/base/check.h"
#include "core/study/stability/sweeps.h"

#include <algorithm>

namespace trixel {

double StabilitySweep::worst(bool naive) const
{
    double worst = 0;
    for (const StabilityCurve& curve : curves) {
        if (curve.naive == naive) {
            for (const double error : curve.errors) {
                worst = std::max(worst, error);
            }
        }
    }
    return worst;
}

bool StabilitySweep::holds() const
{
    return worst(false) <= bound;
}

std::size_t StabilitySweep::naiveFailures() const
{
    std::size_t count = 0;
    for (std::size_t k = 0; k < values.size(); ++k) {
        count += std::ranges::any_of(curves, [&](const StabilityCurve& curve) {
            return curve.naive && !(curve.errors[k] <= bound);
        });
    }
    return count;
}

bool StabilityReport::holds() const
{
    return std::ranges::all_of(sweeps, &StabilitySweep::holds) &&
           std::ranges::all_of(findings, &AssetFinding::holds);
}

std::span<const SweepEntry> stabilitySweeps()
{
    static constexpr SweepEntry kSweeps[] = {
        {"parallel-vectors", sweeps::parallelVectors},
        {"minor-axis", sweeps::minorAxis},
        {"near-circle", sweeps::nearCircle},
        {"vector-length", sweeps::vectorLength},
        {"silhouette", sweeps::silhouette},
        {"camera-plane", sweeps::cameraPlane},
        {"atlas-seam", sweeps::atlasSeam},
        {"sphere-seam", sweeps::sphereSeam},
        {"sphere-quadrants", sweeps::sphereQuadrants},
        {"sphere-pole", sweeps::spherePole},
        {"parallelogram", sweeps::parallelogram},
        {"flat-quad", sweeps::flatQuad},
        {"bow-tie", sweeps::bowTie},
        {"texel-precision", sweeps::texelPrecision},
        {"texel-borders", sweeps::texelBorders},
        {"gaussian-runs", sweeps::gaussianRuns},
        {"stored-textures", sweeps::storedTextures},
        {"narrow-footprints", sweeps::narrowFootprints},
        {"long-footprints", sweeps::longFootprints},
        {"constant-texels", sweeps::constantTexels},
        {"nan-texels", sweeps::nanTexels},
        {"needle-faces", sweeps::needleFaces},
        {"valence", sweeps::valence},
        {"level-step", sweeps::levelStep},
    };
    return kSweeps;
}

StabilitySweep runSweep(std::string_view name)
{
    const auto found = std::ranges::find(stabilitySweeps(), name, &SweepEntry::name);
    check(found != stabilitySweeps().end(), "a sweep of the table");
    return found->run();
}

Result<StabilityReport>
runStability(const StabilityAsset* asset, Threads threads, StabilityWatcher& watcher)
{
    StabilityReport report;
    report.subject = asset != nullptr ? asset->name() : "no asset";
    report.conditions = "Deterministic; truth in long double from the rounded numbers.";
    const double sweepShare = asset != nullptr ? 0.7 : 1.0;
    const auto count = static_cast<double>(stabilitySweeps().size());
    for (const SweepEntry& entry : stabilitySweeps()) {
        if (!watcher.report(sweepShare * static_cast<double>(report.sweeps.size()) / count)) {
            return cancelled();
        }
        report.sweeps.push_back(entry.run());
        watcher.swept(report.sweeps.back());
    }
    if (asset != nullptr) {
        StageProgress progress(watcher, sweepShare, 1);
        auto findings = findHazards(*asset, threads, progress);
        if (!findings) {
            return tl::unexpected(findings.error());
        }
        report.findings = std::move(*findings);
    }
    return report;
}

} // namespace trixel
