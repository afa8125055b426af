// SPDX-License-Identifier: GPL-3.0-or-later
//
// How far a filter jumps where two faces meet: every edge of a mesh, measured from both sides.
#pragma once

#include "core/base/parallel.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/filter/filter_method.h"
#include "core/footprint/footprint.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace trixel {

/// A footprint that means the same on every edge, because it is counted in the texels there.
struct SeamFootprint
{
    double width = 1;      ///< |W| across, in base-level texels (`FilterScene::log2TexelSize`)
    double anisotropy = 1; ///< its length over its width; the long axis at 45° to the edge

    bool operator==(const SeamFootprint&) const = default;
};

/// The footprint that a view gives a point of a face; nothing where it does not see the point.
using FootprintAt = std::function<std::optional<Footprint>(FaceId, glm::dvec2 uv)>;

struct SeamSettings
{
    /// Points along each edge, evenly, none of them on a border between texels. At least 1
    /// (checked).
    int samples = 6;
    /// The two ends of the edge as well. A method that lays the faces about a vertex flat cannot
    /// agree there with itself where their angles do not add up to a full turn.
    bool ends = false;
    std::vector<SeamFootprint> footprints = {{1, 1}, {4, 1}, {4, 4}};
    /// Where given, this one footprint instead; edges that the view does not see are left out.
    /// Called from several threads.
    FootprintAt view;
};

/// What was found on one edge. Jumps are fractions of the value range.
struct SeamJump
{
    FaceId face{}; ///< the lower of the two
    FaceId neighbour{};
    LocalEdge edge{};          ///< as `face` numbers it
    LocalEdge neighbourEdge{}; ///< as `neighbour` numbers it
    Level level, neighbourLevel;
    float jump = 0;  ///< the largest of all samples, footprints and channels
    float mean = 0;  ///< over samples and footprints, of the largest channel's
    float along = 0; ///< where the largest is, from the edge's start in `face` (0) to its end (1)

    bool operator==(const SeamJump&) const = default;
};

struct SeamReport
{
    std::vector<SeamJump> jumps; ///< the largest first; equal ones by face and edge
    double range = 0;            ///< the value range, in the texels' own unit
    std::uint64_t samples = 0;   ///< compared pairs of values
    std::uint64_t refused = 0;   ///< pairs left out because the method refused a side
};

/// Compares the method's answers from both sides of every edge between two faces. The footprint is
/// given in one face and brought to the other by `FilterSurface::crossing`, so both sides are asked
/// the same. A NaN on one side only is an infinite jump. Fails only when cancelled.
Result<SeamReport> measureSeams(const FilterScene& scene,
                                const FilterMethod& method,
                                const SeamSettings& settings,
                                Threads threads,
                                Progress& progress);

/// Figures of a whole report.
struct SeamSummary
{
    std::size_t edges = 0;
    double worst = 0, p99 = 0, p90 = 0, median = 0; ///< of the edges' largest jumps
    double mean = 0;                                ///< of the edges' means
    /// Edges with a jump of more than 1e-5 of the range, which no continuous method has.
    std::size_t broken = 0;
};

/// Largest jump across an edge that still counts as none, in fractions of the value range.
inline constexpr double kSeamless = 1e-5;

/// \param jumps  the largest first, as a report has them
SeamSummary summarize(std::span<const SeamJump> jumps);

/// The largest jump over the edges of each face; NaN for a face none of whose edges was measured.
/// \param jumps  of faces below `faceCount` (checked)
std::vector<float> jumpsOfFaces(std::span<const SeamJump> jumps, std::size_t faceCount);

/// One line an edge, a header line first.
std::string toCsv(const SeamReport& report);

} // namespace trixel
