// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/limit_bends.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>

namespace trixel {

namespace {

/// Samples along a side: a regular face is one polynomial, others bend most next to a vertex.
constexpr int kRegularSide = 4;
constexpr int kIrregularSide = 8;
/// The largest bend may lie between samples.
constexpr double kBetweenSamples = 1.1;
constexpr double kBetweenIrregular = 1.3;
/// The smallest triangles looked at next to a corner, in parts of the face.
constexpr double kLeastPart = 1.0 / 32;
constexpr double kLeastPower = 0.5;

constexpr std::size_t kFacesAtATime = 256;
constexpr std::size_t kFacesPerReport = 65536;

/// Points of one face on a lattice.
class Samples
{
public:
    void take(const LimitSurface::Evaluator& face, int side)
    {
        m_side = side;
        m_points.clear();
        for (int j = 0; j <= side; ++j) {
            for (int i = 0; i + j <= side; ++i) {
                m_points.push_back(face.position(glm::dvec2(i, j) / static_cast<double>(side)));
            }
        }
    }

    /// How far the middle of two lattice points lies from their mean.
    double offMiddle(glm::ivec2 a, glm::ivec2 b) const
    {
        return glm::distance(at((a + b) / 2), 0.5 * (at(a) + at(b)));
    }

    std::span<const glm::dvec3> points() const { return m_points; }
    const glm::dvec3& at(glm::ivec2 p) const
    {
        return m_points[static_cast<std::size_t>(p.y * (2 * m_side + 3 - p.y) / 2 + p.x)];
    }

private:
    int m_side = 0;
    std::vector<glm::dvec3> m_points;
};

/// The most that middles of sides along each edge are off, of triangles of one size.
using Off = std::array<double, 3>;

void widen(Off& off, const Off& other)
{
    for (std::size_t e = 0; e < 3; ++e) {
        off[e] = std::max(off[e], other[e]);
    }
}

/// \param step  of the lattice: the side of the triangles, even
Off offAt(const Samples& samples, int side, int step)
{
    Off off{};
    for (int j = 0; j < side; j += step) {
        for (int i = 0; i + j < side; i += step) {
            const glm::ivec2 a(i, j), b(i + step, j), c(i, j + step);
            widen(off, {samples.offMiddle(a, b), samples.offMiddle(b, c), samples.offMiddle(c, a)});
        }
    }
    return off;
}

/// The same for the triangle of a part of the sides at each corner: the surface bends most there,
/// and in steps that a lattice would take too many points to show.
Off offAtCorners(const LimitSurface::Evaluator& face, double part)
{
    Off off{};
    for (const glm::dvec2 corner : {glm::dvec2(0, 0), {1 - part, 0}, {0, 1 - part}}) {
        const auto at = [&](double u, double v) {
            return face.position(corner + part * glm::dvec2(u, v));
        };
        const glm::dvec3 a = at(0, 0), b = at(1, 0), c = at(0, 1);
        widen(off,
              {glm::distance(at(0.5, 0), 0.5 * (a + b)),
               glm::distance(at(0.5, 0.5), 0.5 * (b + c)),
               glm::distance(at(0, 0.5), 0.5 * (c + a))});
    }
    return off;
}

double largest(const Off& off)
{
    return *std::ranges::max_element(off);
}

/// \param between  how far the surface may be from the triangles of the samples
FaceBounds boundsOf(const Samples& samples, int side, double between)
{
    const glm::dvec3 sum =
        std::accumulate(samples.points().begin(), samples.points().end(), glm::dvec3(0));
    FaceBounds bounds;
    bounds.centre = glm::vec3(sum / static_cast<double>(samples.points().size()));
    const glm::dvec3 origin = samples.at({0, 0});
    const glm::dvec3 across =
        glm::cross(samples.at({side, 0}) - origin, samples.at({0, side}) - origin);
    const double length = glm::length(across);
    const glm::dvec3 normal = length > 0 ? across / length : glm::dvec3(0);
    double radius = 0;
    double height = 0;
    for (const glm::dvec3& p : samples.points()) {
        const glm::dvec3 from = p - glm::dvec3(bounds.centre);
        radius = std::max(radius, glm::length(from));
        height = std::max(height, std::abs(glm::dot(normal, from)));
    }
    bounds.radius = static_cast<float>((radius + between) * 1.0001);
    bounds.normal = glm::vec3(normal);
    bounds.height = static_cast<float>((height + between) * 1.0001);
    return bounds;
}

/// By pieces: 1, 2, 4 and so on.
std::vector<Off> offByPieces(const LimitSurface::Evaluator& face, bool isRegular, Samples& samples)
{
    const int side = isRegular ? kRegularSide : kIrregularSide;
    samples.take(face, side);
    std::vector<Off> off;
    for (int step = side; step >= 2; step /= 2) {
        off.push_back(offAt(samples, side, step));
    }
    for (double part = 2.0 / side; !isRegular && part >= kLeastPart; part /= 2) {
        off.push_back(offAtCorners(face, 0.5 * part));
    }
    return off;
}

/// How fast errors shrink with the pieces, from the coarse to the fine.
double powerOf(const std::vector<Off>& off)
{
    const double coarse = largest(off[1]);
    const double fine = largest(off.back());
    if (!(coarse > 0) || !(fine > 0)) {
        return 2;
    }
    const double halvings = static_cast<double>(off.size() - 2);
    return std::clamp(std::log2(coarse / fine) / halvings, kLeastPower, 2.0);
}

// Linear interpolation over a triangle with the sides a, b, c is off by ½ Σ λiλj D²(side ij): at
// the middle of a side by an eighth of its second derivative, four thirds of that where all three
// meet.
FaceBend bendOf(const LimitSurface::Evaluator& face, bool isRegular, Samples& samples)
{
    const std::vector<Off> off = offByPieces(face, isRegular, samples);
    const double power = isRegular ? 2 : powerOf(off);
    const double between = isRegular ? kBetweenSamples : kBetweenIrregular;
    Off along{};
    double inside = 0;
    for (std::size_t k = 0; k < off.size(); ++k) {
        const double scale = std::exp2(power * static_cast<double>(k));
        for (std::size_t e = 0; e < 3; ++e) {
            along[e] = std::max(along[e], scale * off[k][e]);
        }
        const double allThree = 8.0 / 18 * (off[k][0] + off[k][1] + off[k][2]);
        inside = std::max(inside, scale * std::max(largest(off[k]), allThree));
    }
    FaceBend bend;
    for (std::size_t e = 0; e < 3; ++e) {
        bend.along[e] = static_cast<float>(between * 4 / 3 * along[e]);
    }
    bend.inside = static_cast<float>(between * inside);
    bend.power = static_cast<float>(power);
    const int side = isRegular ? kRegularSide : kIrregularSide;
    bend.bounds = boundsOf(samples, side, bend.inside / std::pow(side, power));
    return bend;
}

} // namespace

Result<std::shared_ptr<const LimitBends>> LimitBends::measure(
    std::shared_ptr<const LimitSurface> surface, Threads threads, Progress& progress)
{
    const std::shared_ptr<LimitBends> bends(new LimitBends());
    bends->m_surface = std::move(surface);
    const LimitSurface& limit = *bends->m_surface;
    bends->m_faces.resize(limit.faceCount());
    for (std::size_t first = 0; first < limit.faceCount(); first += kFacesPerReport) {
        if (!progress.report(static_cast<double>(first) / static_cast<double>(limit.faceCount()))) {
            return cancelled();
        }
        const std::size_t count = std::min(kFacesPerReport, limit.faceCount() - first);
        parallelFor(count, kFacesAtATime, threads, [&](std::size_t begin, std::size_t end) {
            LimitSurface::Evaluator evaluator(limit);
            Samples samples;
            for (std::size_t f = first + begin; f < first + end; ++f) {
                evaluator.moveTo(faceId(f));
                const bool isRegular = limit.isRegular(faceId(f));
                bends->m_faces[f] = bendOf(evaluator, isRegular, samples);
            }
        });
    }
    bends->findOwners();
    return bends;
}

void LimitBends::findOwners()
{
    m_edgeOwners.resize(m_surface->edgeCount());
    m_vertexOwners.resize(m_surface->vertexCount());
    for (std::size_t f = m_surface->faceCount(); f-- > 0;) { // the lowest is the last to write
        const auto edges = m_surface->edges(faceId(f));
        const Triangle& vertices = m_surface->vertices(faceId(f));
        for (std::uint32_t k = 0; k < 3; ++k) {
            m_edgeOwners[edges[k]] = {static_cast<std::uint32_t>(f), k};
            m_vertexOwners[vertices[k]] = {static_cast<std::uint32_t>(f), k};
        }
    }
}

} // namespace trixel
