// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/paint/paint_surface.h"

#include "core/mesh/crease_angle.h"

namespace trixel {

namespace {

/// Parts of the surface's size.
constexpr double kError = 1.0 / 4096;

} // namespace

Result<std::shared_ptr<const LimitMesh>>
limitToPaintOn(const Surface& surface, CreaseAngle creases, Threads threads, Progress& progress)
{
    auto limit = LimitSurface::build(surface.mesh(), sharpnessOf(surface, creases));
    if (!limit) {
        return tl::unexpected(limit.error());
    }
    StageProgress measuring(progress, 0.0, 0.5);
    auto bends = LimitBends::measure(std::move(*limit), threads, measuring);
    if (!bends) {
        return tl::unexpected(bends.error());
    }
    LimitDemand demand;
    // A surface of no size has nothing to be off by.
    demand.error = surface.size() > 0 ? kError * double{surface.size()} : 1.0;
    StageProgress cutting(progress, 0.5, 0.9);
    auto cut = LimitTessellation::make(std::move(*bends), demand, nullptr, threads, cutting);
    if (!cut) {
        return tl::unexpected(cut.error());
    }
    if (!progress.report(0.9)) {
        return cancelled();
    }
    return LimitMesh::build(std::move(*cut), threads);
}

} // namespace trixel
