// SPDX-License-Identifier: GPL-3.0-or-later
//
// The triangle filter of the reference library (wdas/ptex), rewritten from what it computes: the
// yardstick of speed. Plain scalar loops over the bounding hexagon of the ellipse, as there.
//   * Every face counts as equilateral; neighbours are reached by Ptex's affine map.
//   * The ellipse is widened until its axes differ by 15 at most, and by half a texel of the hit
//     face; it is cut at 3.5 standard deviations, and at one face in each direction. The parameter
//     moves that last cut: with it away the same loop sees the whole ellipse.
//   * One level, from the exponent of its width: a hard switch.
// Differences: texels are floats that nothing truncated on the way, sums are not rounded to the
// type of the texture, and no input gives a NaN.
#include "core/filter/methods.h"
#include "core/filter/query_filter.h"
#include "core/footprint/limit.h"

#include <array>
#include <cmath>
#include <utility>

namespace trixel {
namespace {

constexpr float kCut = 3.5F;
constexpr float kMostEccentric = 15.0F;
/// Faces within so many edges have 4,096 texels at level 0, where the widest footprints are read.
constexpr float kMostEdges = 26.0F;

/// One barycentric coordinate of the footprint.
struct Span
{
    float centre = 0;
    float low = 0; ///< the part that is looked at
    float high = 0;
    float variance = 0; ///< times the cut squared
};

/// Barycentric coordinates by vertex: w, u, v. Their variances say all about the ellipse, because
/// the three always sum to 1.
struct Kernel
{
    std::array<Span, 3> spans;
    int log2 = 0; ///< level wanted
};

/// A half of a face's texels about the ellipse: columns and rows of the packed square and, as
/// third, what is left to the diagonal. Ranges are half open.
struct TexelBounds
{
    std::array<int, 3> begin{}, end{};
    float column = 0; ///< centre
    float row = 0;
    float columnVariance = 0; ///< times the cut squared, in texels squared
    float rowVariance = 0;
    float covariance = 0;

    bool isEmpty() const { return begin[0] >= end[0] || begin[1] >= end[1] || begin[2] >= end[2]; }
};

struct Sums
{
    GroupValue values{};
    float weight = 0;
    std::uint32_t taps = 0;
};

/// \param edges  at which the ellipse is cut on every side
Kernel kernelOf(const FilterQueries& queries, std::size_t i, Level level, float edges)
{
    const auto limited = [](float u, float v) {
        const bool finite = std::isfinite(u) && std::isfinite(v);
        return finite ? glm::vec2(limitedVector({u, v}, kWidestFootprint))
                      : glm::vec2(static_cast<float>(kWidestFootprint));
    };
    const glm::vec2 a = limited(queries.uw1[i], queries.vw1[i]);
    const glm::vec2 b = limited(queries.uw2[i], queries.vw2[i]);
    const float uu = 0.25F * (a.x * a.x + b.x * b.x);
    const float uv = 0.25F * (a.x * a.y + b.x * b.y);
    const float vv = 0.25F * (a.y * a.y + b.y * b.y);

    // The same where faces are equilateral: x = u + v/2, y = v sqrt(3)/2.
    float xx = uu + uv + 0.25F * vv;
    const float xy = std::sqrt(0.75F) * (uv + 0.5F * vv);
    float yy = 0.75F * vv;
    const float apart = std::sqrt((xx - yy) * (xx - yy) + 4 * xy * xy); // of the eigenvalues
    constexpr float kSquared = kMostEccentric * kMostEccentric;
    const float forAxes = 0.5F * ((kSquared + 1) / (kSquared - 1) * apart - (xx + yy));
    const float halfTexel = 0.5F / static_cast<float>(level.resolution());
    const float blur = std::max(forAxes, halfTexel * halfTexel);
    xx += blur;
    yy += blur;
    const float minor = std::sqrt(std::max(2 * (xx * yy - xy * xy) / (xx + yy + apart), 0.0F));

    Kernel kernel;
    // 2^-n <= 2 minor < 2^(1-n)
    const int exponent = minor > 0 ? std::ilogb(2 * minor) : -Level::kMax;
    kernel.log2 = std::clamp(-exponent, 0, Level::kMax);
    const float vvBlurred = yy * (4.0F / 3.0F);
    const float uvBlurred = xy / std::sqrt(0.75F) - 0.5F * vvBlurred;
    const float uuBlurred = xx - uvBlurred - 0.25F * vvBlurred;
    constexpr float kScale = kCut * kCut;
    const glm::vec2 uvCentre(
        broughtInside({static_cast<double>(queries.u[i]), static_cast<double>(queries.v[i])}));
    const std::array<float, 3> centres = {1 - uvCentre.x - uvCentre.y, uvCentre.x, uvCentre.y};
    const std::array<float, 3> variances = {
        kScale * (uuBlurred + 2 * uvBlurred + vvBlurred), kScale * uuBlurred, kScale * vvBlurred};
    for (std::size_t k = 0; k < 3; ++k) {
        const float reach = std::min(std::sqrt(variances[k]), edges);
        kernel.spans[k] = {centres[k], centres[k] - reach, centres[k] + reach, variances[k]};
    }
    return kernel;
}

/// The kernel as the face across an edge sees it: (t, h) becomes (1-t, -h) in coordinates along
/// and above the edge, whatever the shapes.
Kernel acrossEdge(const Kernel& kernel, LocalEdge own, LocalEdge other)
{
    const auto turned = [](const Span& s, float sum) {
        return Span{sum - s.centre, sum - s.high, sum - s.low, s.variance};
    };
    const std::size_t k = indexOf(own);
    const std::size_t m = indexOf(other);
    Kernel across;
    across.log2 = kernel.log2;
    across.spans[(m + 2) % 3] = turned(kernel.spans[(k + 2) % 3], 0);
    across.spans[(m + 1) % 3] = turned(kernel.spans[(k + 1) % 3], 1);
    across.spans[m] = turned(kernel.spans[k], 1);
    return across;
}

TexelBounds boundsOf(const Kernel& kernel, Level level, TexelHalf half)
{
    const auto r = static_cast<float>(level.resolution());
    constexpr float kThird = 1.0F / 3.0F;
    const auto& [w, u, v] = kernel.spans;
    // Upper texels lie in the square as if u were 1 - v, v 1 - u and w -w.
    const bool lower = half == TexelHalf::Lower;
    const auto turned = [](const Span& s, float sum) {
        return Span{sum - s.centre, sum - s.high, sum - s.low, s.variance};
    };
    const std::array<Span, 3> spans = {
        lower ? u : turned(v, 1), lower ? v : turned(u, 1), lower ? w : turned(w, 0)};
    TexelBounds bounds;
    for (std::size_t k = 0; k < 3; ++k) {
        bounds.begin[k] = static_cast<int>(std::ceil(spans[k].low * r - kThird));
        bounds.end[k] = static_cast<int>(std::ceil(spans[k].high * r - kThird));
    }
    bounds.column = spans[0].centre * r - kThird;
    bounds.row = spans[1].centre * r - kThird;
    bounds.columnVariance = spans[0].variance * r * r;
    bounds.rowVariance = spans[1].variance * r * r;
    bounds.covariance = 0.5F * (w.variance - u.variance - v.variance) * r * r;
    return bounds;
}

/// The ellipse's equation by differences along each row, as Heckbert has it.
void addTexels(const LevelTexels& texels, Level level, const TexelBounds& bounds, Sums& sums)
{
    const float inverse =
        1 / (bounds.columnVariance * bounds.rowVariance - bounds.covariance * bounds.covariance);
    const float a = bounds.rowVariance * inverse;
    const float b = -2 * bounds.covariance * inverse;
    const float c = bounds.columnVariance * inverse;
    const auto resolution = static_cast<int>(level.resolution());
    const float area = 1 / static_cast<float>(level.texelCount());
    const float change = 2 * a;
    for (int y = bounds.begin[1]; y < bounds.end[1]; ++y) {
        const int begin = std::max(bounds.begin[0], resolution - y - bounds.end[2]);
        const int end = std::min(bounds.end[0], resolution - y - bounds.begin[2]);
        const float dx = static_cast<float>(begin) - bounds.column;
        const float dy = static_cast<float>(y) - bounds.row;
        float step = a * (2 * dx + 1) + b * dy;
        float q = a * dx * dx + (b * dx + c * dy) * dy;
        for (int x = begin; x < end; ++x) {
            if (q < 1) {
                const float weight = std::exp(-0.5F * kCut * kCut * q) * area;
                const float* texel = texels.texel(static_cast<TexelIndex>(y * resolution + x));
                sums.weight += weight;
                for (std::size_t k = 0; k < kGroupChannels; ++k) {
                    sums.values[k] += weight * texel[k];
                }
                ++sums.taps;
            }
            q += step;
            step += change;
        }
    }
}

void addFace(const FilterScene& scene, FaceId face, int group, Kernel kernel, Sums& sums)
{
    const Level level(std::min(kernel.log2, scene.level(face).log2()));
    for (Span& span : kernel.spans) {
        span.low = std::max(span.low, 0.0F);
    }
    auto& [w, u, v] = kernel.spans;
    u.high = std::min(u.high, 1 - (v.low + w.low));
    v.high = std::min(v.high, 1 - (w.low + u.low));
    w.high = std::min(w.high, 1 - (u.low + v.low));
    const LevelTexels texels = scene.mips().texels(face, level, group);
    for (const TexelHalf half : {TexelHalf::Lower, TexelHalf::Upper}) {
        const TexelBounds bounds = boundsOf(kernel, level, half);
        if (!bounds.isEmpty()) {
            addTexels(texels, level, bounds, sums);
        }
    }
}

/// Whether no point has its three coordinates, which sum to 1, within their spans.
bool isEmpty(const Kernel& kernel)
{
    const auto& [w, u, v] = kernel.spans;
    return w.low + u.low + v.low >= 1 || w.high + u.high + v.high <= 1;
}

/// Cuts off what lies beyond each edge and hands it to the neighbour, then reads the face itself.
/// Ends: the lines of one direction are one edge apart, the kernel reaches a few edges from its
/// centre, and no part is handed back across the line where it was cut off.
void splitAndAdd(const FilterScene& scene, FaceId face, int group, Kernel kernel, Sums& sums)
{
    for (const LocalEdge edge : {LocalEdge::E2, LocalEdge::E0, LocalEdge::E1}) {
        Span& height = kernel.spans[(indexOf(edge) + 2) % 3];
        const auto across =
            height.low < 0 ? scene.surface().adjacency().neighbour(face, edge) : std::nullopt;
        if (across) {
            Kernel beyond = kernel;
            beyond.spans[(indexOf(edge) + 2) % 3].high = 0;
            if (!isEmpty(beyond)) {
                const Kernel there = acrossEdge(beyond, edge, across->edge);
                splitAndAdd(scene, across->face, group, there, sums);
            }
            height.low = 0;
        }
    }
    addFace(scene, face, group, kernel, sums);
}

class ReferenceLoop final : public FilterMethod
{
public:
    explicit ReferenceLoop(double edges)
        : m_edges(static_cast<float>(edges))
    {
    }

    void filter(const FilterScene& scene,
                const FilterQueries& queries,
                const FilterResults& results) const override
    {
        checkRoom(scene, queries, results);
        for (std::size_t i = 0; i < queries.size(); ++i) {
            const FaceId face = queries.face[i];
            const bool hasCentre = std::isfinite(queries.u[i]) && std::isfinite(queries.v[i]);
            const Kernel kernel =
                hasCentre ? kernelOf(queries, i, scene.level(face), m_edges) : Kernel{};
            QueryCost cost{0, 1};
            for (int group = 0; group < scene.mips().groups(); ++group) {
                GroupValue value{};
                std::copy_n(scene.mips().average(face, group), kGroupChannels, value.begin());
                if (hasCentre) {
                    cost = answer(scene, face, group, kernel, value);
                }
                storeAnswer(results, i, group, scene.channels(), value);
            }
            storeCost(results, i, cost);
        }
    }

private:
    static QueryCost answer(
        const FilterScene& scene, FaceId face, int group, const Kernel& kernel, GroupValue& value)
    {
        Sums sums;
        splitAndAdd(scene, face, group, kernel, sums);
        if (!(sums.weight > 0)) {
            return {0, 1}; // no centroid under the ellipse, large texels amid small ones
        }
        for (std::size_t c = 0; c < kGroupChannels; ++c) {
            value[c] = sums.values[c] / sums.weight;
        }
        const int level = std::min(kernel.log2, scene.level(face).log2());
        return {static_cast<float>(level), sums.taps};
    }

    float m_edges;
};

} // namespace

MethodEntry referenceLoopMethod()
{
    MethodEntry entry;
    entry.name = "reference-loop";
    entry.title = "Reference loop";
    entry.about = "The reference library's triangle filter, texel by texel: one Gaussian at one "
                  "level, anisotropy cut at 15.";
    // A constant is kept to 1e-6 only: sums of a few thousand floats, as in the library.
    entry.claims = {.constantKept = Claim::No};
    entry.parameter = MethodParameter{"edges",
                                      "Edges of a face at which the footprint is cut on every "
                                      "side; the library has 1.",
                                      1,
                                      kMostEdges,
                                      1,
                                      {1, kMostEdges}};
    entry.make = [](double edges) -> std::unique_ptr<const FilterMethod> {
        return std::make_unique<ReferenceLoop>(edges);
    };
    return entry;
}

} // namespace trixel
