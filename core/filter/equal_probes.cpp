// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filter/footprint_level.h"
#include "core/filter/methods.h"
#include "core/filter/query_filter.h"
#include "core/filter/rectilinear_rows.h"

namespace trixel {
namespace {

/// How an ellipse is laid out in probes.
struct ProbeLine
{
    int count = 1;
    double spacing = 0; ///< plane units
    double sigma = 0;   ///< that each probe stands for, plane units
};

/// As graphics hardware does: as many probes as the ellipse is long for its width, and wider ones
/// where that is more than there may be. Spaced so that the row's variance, h² (N² - 1) / 12, and
/// the probe's own make up the ellipse's along its major axis.
ProbeLine probeLine(const QueryEllipse& ellipse, int most)
{
    ProbeLine line;
    const double ratio = std::ceil(ellipse.majorSigma / ellipse.minorSigma - 1e-9);
    line.count = ratio < most ? std::max(static_cast<int>(ratio), 1) : most;
    line.sigma = std::max(ellipse.minorSigma, ellipse.majorSigma / line.count);
    if (line.count > 1) {
        const double n = line.count;
        const double rest = (ellipse.majorSigma - line.sigma) * (ellipse.majorSigma + line.sigma);
        line.spacing = std::sqrt(12 * std::max(rest, 0.0) / (n * n - 1));
    }
    return line;
}

QueryCost equalProbesAnswer(int most,
                            const FilterScene& scene,
                            const QueryEllipse& ellipse,
                            FaceId face,
                            int group,
                            GroupValue& value)
{
    const ProbeLine line = probeLine(ellipse, most);
    const FilterSurface& surface = scene.surface();
    const double log2Width = std::log2(kEdgePerSigma * line.sigma);
    const glm::dvec2 step = surface.shape(face).toUv(line.spacing * ellipse.majorAxis);
    TexelSum sum;
    QueryCost cost{finerLevel(scene, face, ellipse.log2Edge - log2Width), 0};
    const auto probe = [&](const SurfacePlace& at) {
        const double level = surface.log2Length(at.face, at.uv) - log2Width;
        cost.taps += addTrilinear(scene, at, level, group, 1, sum);
    };
    const SurfacePlace centre{face, ellipse.uv};
    const bool odd = line.count % 2 != 0;
    if (odd) {
        probe(centre);
    }
    // Outwards from the centre in both directions, each probe a step from the one before.
    for (const double sign : {-1.0, 1.0}) {
        SurfaceWalk walk{centre, {sign * step, glm::dvec2(0)}, false};
        for (int k = 0; k < line.count / 2; ++k) {
            const double steps = k == 0 && !odd ? 0.5 : 1.0;
            walk = walkStraight(surface, walk.end, steps * walk.carried[0], walk.carried);
            probe(walk.end);
        }
    }
    sum.store(value.data());
    return cost;
}

} // namespace

MethodEntry equalProbesMethod()
{
    MethodEntry entry;
    entry.name = "equal-probes";
    entry.title = "Equal probes";
    entry.about = "Trilinear probes of equal weight along the major axis, as graphics hardware "
                  "filters.";
    entry.claims = {.affineKept = Claim::Yes};
    entry.parameter = MethodParameter{.name = "probes",
                                      .meaning = "The most probes that a query may take.",
                                      .least = 1,
                                      .most = 256,
                                      .standard = 16,
                                      .curve = {2, 4, 8, 16},
                                      .whole = true};
    entry.make = [](double parameter) {
        return perQueryMethod([most = static_cast<int>(parameter)](auto&&... query) {
            return equalProbesAnswer(most, query...);
        });
    };
    return entry;
}

} // namespace trixel
