// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/seam_meter.h"

#include "core/lattice/edge_transfer.h"
#include "core/mesh/shared_progress.h"
#include "core/study/value_range.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <sstream>
#include <tuple>

namespace trixel {
namespace {

constexpr std::size_t kFacesAtOnce = 256;

/// Where to look along an edge. Thirds lie on the border of no texel. Multiples of 2⁻²⁰, so that
/// the same point counted from the other end is a float as well: a rounded one would be another
/// point, and its difference no jump.
std::vector<double> pointsAlong(const SeamSettings& settings)
{
    constexpr double kSteps = 1 << 20;
    std::vector<double> points;
    if (settings.ends) {
        points = {0, 1};
    }
    for (int k = 0; k < settings.samples; ++k) {
        points.push_back(std::round(kSteps * (k + 1.0 / 3) / settings.samples) / kSteps);
    }
    return points;
}

/// Axes along the edge and across it, as vectors in (u,v), each as long as a unit of the plane.
std::array<glm::dvec2, 2> edgeAxes(const FaceShape& shape, LocalEdge edge)
{
    const glm::dvec2 start = fromEdge(edge, {0, 0});
    const glm::dvec2 along = glm::normalize(shape.toPlane(fromEdge(edge, {1, 0}) - start));
    return {shape.toUv(along), shape.toUv({-along.y, along.x})};
}

Footprint widthInTexels(const FilterScene& scene,
                        FaceId face,
                        LocalEdge edge,
                        glm::dvec2 uv,
                        const SeamFootprint& footprint)
{
    const auto [along, across] = edgeAxes(scene.surface().shape(face), edge);
    const double width = footprint.width * std::exp2(scene.log2TexelSize(face, uv));
    const double half = std::sqrt(0.5);
    return {width * footprint.anisotropy * half * (along + across),
            width * half * (across - along)};
}

/// The edges of a range of faces and what is found on them.
class EdgeBatch
{
public:
    EdgeBatch(const FilterScene& scene,
              const FilterMethod& method,
              const SeamSettings& settings,
              double range)
        : m_scene(scene)
        , m_method(method)
        , m_settings(settings)
        , m_points(pointsAlong(settings))
        , m_perRange(range > 0 ? 1 / range : 0)
    {
    }

    void measure(std::size_t beginFace, std::size_t endFace)
    {
        for (std::size_t f = beginFace; f < endFace; ++f) {
            for (const LocalEdge edge : kLocalEdges) {
                addEdge(faceId(f), edge);
            }
        }
        compare();
    }

    std::vector<SeamJump>& jumps() { return m_jumps; }
    std::uint64_t samples() const { return m_samples; }
    std::uint64_t refused() const { return m_refused; }

private:
    /// Which edge of the batch a pair of queries is about.
    struct Place
    {
        std::uint32_t edge;
        float along;
    };

    void addEdge(FaceId face, LocalEdge edge)
    {
        const auto crossing = m_scene.surface().crossing(face, edge);
        if (!crossing || std::tie(crossing->face, crossing->edge) < std::tie(face, edge)) {
            return; // a border, or the other side's turn
        }
        const std::size_t before = m_places.size();
        for (const double t : m_points) {
            addPoint(face, edge, *crossing, t);
        }
        if (m_places.size() > before) {
            m_jumps.push_back({face,
                               crossing->face,
                               edge,
                               crossing->edge,
                               m_scene.level(face),
                               m_scene.level(crossing->face)});
        }
    }

    void addPoint(FaceId face, LocalEdge edge, const FilterSurface::Crossing& crossing, double t)
    {
        const glm::dvec2 uv = fromEdge(edge, {t, 0});
        if (m_settings.view) {
            if (const auto footprint = m_settings.view(face, uv)) {
                addPair(face, uv, crossing, t, *footprint);
            }
            return;
        }
        for (const SeamFootprint& footprint : m_settings.footprints) {
            addPair(face, uv, crossing, t, widthInTexels(m_scene, face, edge, uv, footprint));
        }
    }

    void addPair(FaceId face,
                 glm::dvec2 uv,
                 const FilterSurface::Crossing& crossing,
                 double t,
                 const Footprint& footprint)
    {
        m_places.push_back({static_cast<std::uint32_t>(m_jumps.size()), static_cast<float>(t)});
        m_own.add(face, uv, footprint.w1, footprint.w2);
        m_other.add(crossing.face,
                    fromEdge(crossing.edge, {1 - t, 0}),
                    crossing.vector(footprint.w1),
                    crossing.vector(footprint.w2));
    }

    void compare()
    {
        ResultArrays own(m_own.size(), m_scene.channels());
        ResultArrays other(m_own.size(), m_scene.channels());
        m_method.filter(m_scene, m_own.queries(), own.results());
        m_method.filter(m_scene, m_other.queries(), other.results());
        std::vector<std::uint32_t> counts(m_jumps.size());
        for (std::size_t i = 0; i < m_places.size(); ++i) {
            if (own.taps[i] == kRefusedTaps || other.taps[i] == kRefusedTaps) {
                ++m_refused;
                continue;
            }
            ++m_samples;
            ++counts[m_places[i].edge];
            record(m_places[i], difference(own, other, i));
        }
        for (std::size_t e = 0; e < m_jumps.size(); ++e) {
            m_jumps[e].mean /= static_cast<float>(std::max(1U, counts[e]));
        }
    }

    float difference(const ResultArrays& own, const ResultArrays& other, std::size_t i) const
    {
        double largest = 0;
        for (std::size_t at = i; at < own.values.size(); at += m_places.size()) {
            const double a = own.values[at];
            const double b = other.values[at];
            if (std::isnan(a) != std::isnan(b)) {
                return std::numeric_limits<float>::infinity();
            }
            if (a != b && !std::isnan(a)) { // equal infinities have no difference
                largest = std::max(largest, std::abs(a - b) * m_perRange);
            }
        }
        return static_cast<float>(largest);
    }

    void record(const Place& place, float jump)
    {
        SeamJump& edge = m_jumps[place.edge];
        edge.mean += jump;
        if (jump > edge.jump) {
            edge.jump = jump;
            edge.along = place.along;
        }
    }

    const FilterScene& m_scene;
    const FilterMethod& m_method;
    const SeamSettings& m_settings;
    std::vector<double> m_points;
    double m_perRange;
    std::vector<SeamJump> m_jumps;
    std::vector<Place> m_places;
    QueryArrays m_own;
    QueryArrays m_other;
    std::uint64_t m_samples = 0;
    std::uint64_t m_refused = 0;
};

bool largerJump(const SeamJump& a, const SeamJump& b)
{
    return std::tuple(-a.jump, a.face, a.edge) < std::tuple(-b.jump, b.face, b.edge);
}

/// The batches in the order of their faces, then sorted: the same however many threads there were.
SeamReport joined(std::vector<SeamReport>& parts, double range)
{
    SeamReport report;
    report.range = range;
    std::size_t edges = 0;
    for (const SeamReport& part : parts) {
        edges += part.jumps.size();
    }
    report.jumps.reserve(edges);
    for (SeamReport& part : parts) {
        report.jumps.insert(report.jumps.end(), part.jumps.begin(), part.jumps.end());
        report.samples += part.samples;
        report.refused += part.refused;
        part.jumps = {};
    }
    std::ranges::sort(report.jumps, largerJump);
    return report;
}

} // namespace

Result<SeamReport> measureSeams(const FilterScene& scene,
                                const FilterMethod& method,
                                const SeamSettings& settings,
                                Threads threads,
                                Progress& progress)
{
    check(settings.samples >= 1, "samples along an edge");
    const double range = valueRange(scene.mips(), threads);
    const std::size_t batches = (scene.faceCount() + kFacesAtOnce - 1) / kFacesAtOnce;
    std::vector<SeamReport> parts(batches);
    SharedProgress shared(progress, std::max<std::size_t>(batches, 1));
    parallelFor(batches, 1, threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t b = begin; b < end && shared.goesOn(); ++b) {
            EdgeBatch batch(scene, method, settings, range);
            batch.measure(b * kFacesAtOnce, std::min(scene.faceCount(), (b + 1) * kFacesAtOnce));
            parts[b] = {std::move(batch.jumps()), range, batch.samples(), batch.refused()};
            shared.step();
        }
    });
    if (!shared.goesOn()) {
        return cancelled();
    }
    return joined(parts, range);
}

SeamSummary summarize(std::span<const SeamJump> jumps)
{
    SeamSummary summary;
    summary.edges = jumps.size();
    if (jumps.empty()) {
        return summary;
    }
    // The value that the given part of the edges does not exceed.
    const auto percentile = [&](double part) {
        const auto above = static_cast<std::size_t>(
            std::floor((1 - part) * static_cast<double>(jumps.size()) + 1e-9));
        return double{jumps[std::min(above, jumps.size() - 1)].jump};
    };
    summary.worst = jumps.front().jump;
    summary.p99 = percentile(0.99);
    summary.p90 = percentile(0.90);
    summary.median = percentile(0.50);
    for (const SeamJump& jump : jumps) {
        summary.mean += jump.mean;
        summary.broken += jump.jump > kSeamless ? 1 : 0;
    }
    summary.mean /= static_cast<double>(jumps.size());
    return summary;
}

std::vector<float> jumpsOfFaces(std::span<const SeamJump> jumps, std::size_t faceCount)
{
    std::vector<float> largest(faceCount, std::numeric_limits<float>::quiet_NaN());
    for (const SeamJump& jump : jumps) {
        for (const FaceId face : {jump.face, jump.neighbour}) {
            check(indexOf(face) < faceCount, "a face of the mesh");
            float& known = largest[indexOf(face)];
            known = known >= jump.jump ? known : jump.jump; // false for NaN
        }
    }
    return largest;
}

std::string toCsv(const SeamReport& report)
{
    std::ostringstream text;
    text << "face,edge,neighbour,neighbour_edge,level,neighbour_level,jump,mean,along\n";
    for (const SeamJump& jump : report.jumps) {
        text << indexOf(jump.face) << ',' << indexOf(jump.edge) << ',' << indexOf(jump.neighbour)
             << ',' << indexOf(jump.neighbourEdge) << ',' << jump.level.log2() << ','
             << jump.neighbourLevel.log2() << ',' << jump.jump << ',' << jump.mean << ','
             << jump.along << '\n';
    }
    return text.str();
}

} // namespace trixel
