// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filter/footprint_level.h"
#include "core/filter/methods.h"
#include "core/filter/query_filter.h"
#include "core/filter/rectilinear_rows.h"

#include <array>
#include <cmath>
#include <numbers>
#include <optional>

namespace trixel {
namespace {

/// Half widths of the box in standard deviations.
constexpr double kCut = 2.5;
/// The mip level is the finest whose texels are that much narrower than the box: its shorter side
/// has this standard deviation or up to twice that.
constexpr double kNarrowSigma = 1.0;
/// Least standard deviation in texels of the level: narrower ones miss rows.
constexpr double kLeastSigma = 0.5;
/// Most taps of a box: a longer one is read on a coarser level. Beyond the face each is a walk of
/// its own, so that more would not pay.
constexpr double kMostBoxTaps = 1024;
static_assert(kMostBoxTaps <= kMostTaps);
/// Most weights along an axis.
constexpr int kMostWeights = 256;
/// Columns lie half a texel apart, rows a whole one.
constexpr double kColumnsPerTexel = 2;

/// Gaussian weights at whole numbers.
struct AxisWeights
{
    int first = 0;
    int count = 0;
    std::array<double, kMostWeights> weights;

    /// \param centre, sigma  in steps of the axis, which is 2 cut sigma + 1 of them at most
    /// \param zigzag         what is weighted lies that much above even numbers and below odd ones
    AxisWeights(double centre, double sigma, double zigzag = 0)
    {
        const double reach = kCut * sigma;
        first = static_cast<int>(std::ceil(centre - reach));
        count = static_cast<int>(std::floor(centre + reach)) - first + 1;
        // Where the cut ends the weights unevenly, their mean is off the centre: they are tilted
        // so that it is not, and an affine texture is kept.
        double mean = 0;
        double perTilt = 0;
        for (int k = 0; k < count; ++k) {
            const double x = first + k - centre;
            const double place = x + sign(k) * zigzag;
            const double w = std::exp(-x * x / (2 * sigma * sigma));
            weights[static_cast<std::size_t>(k)] = w;
            mean += w * place;
            perTilt += w * x * place;
        }
        const double tilt = perTilt > 0 ? -mean / perTilt : 0;
        for (int k = 0; k < count; ++k) {
            weights[static_cast<std::size_t>(k)] *= 1 + tilt * (first + k - centre);
        }
    }

    double at(int k) const { return weights[static_cast<std::size_t>(k)]; }
    /// The number nearest to the centre, from 0.
    int middle() const { return count / 2; }
    /// Mean of 1 at even numbers and -1 at odd ones.
    double alternating() const
    {
        double sum = 0;
        double all = 0;
        for (int k = 0; k < count; ++k) {
            sum += sign(k) * at(k);
            all += at(k);
        }
        return sum / all;
    }

private:
    double sign(int k) const { return ((first + k) & 1) == 0 ? 1.0 : -1.0; }
};

/// Standard deviations of the ellipse's bounding box along x = u + v/2 and y = v.
struct RowBox
{
    double x = 0;
    double y = 0;
};

/// In edges of the face.
RowBox rowBox(const QueryEllipse& ellipse, const FaceShape& shape)
{
    const glm::dvec2 major = shape.toUv(ellipse.majorSigma * ellipse.majorAxis);
    const glm::dvec2 minor = shape.toUv(ellipse.minorSigma * ellipse.minorAxis());
    return {std::hypot(major.x + major.y / 2, minor.x + minor.y / 2), std::hypot(major.y, minor.y)};
}

/// The same in columns and rows of a level.
struct LevelBox
{
    double columns = 0;
    double rows = 0;

    /// The weights that an axis takes at most.
    static double reach(double sigma) { return 2 * kCut * sigma + 2; }
    double taps() const { return reach(columns) * reach(rows); }
};

LevelBox levelBox(const RowBox& box, Level level, Level base)
{
    // The means of a coarser level spread a texel already: the variances of a triangle along x and
    // y are 1/24 and 1/18, less those of a base-level texel.
    const double spread = 1 - std::exp2(2.0 * (level.log2() - base.log2()));
    const double r = level.resolution();
    const auto rest = [](double sigma, double variance) {
        return std::sqrt(std::max(sigma * sigma - variance, kLeastSigma * kLeastSigma));
    };
    return {kColumnsPerTexel * rest(box.x * r, spread / 24), rest(box.y * r, spread / 18)};
}

/// A box of faces at the coarsest level may still take too many taps: then its longer side is cut.
LevelBox cutToMostTaps(LevelBox box)
{
    while (box.taps() > kMostBoxTaps ||
           LevelBox::reach(std::max(box.columns, box.rows)) > kMostWeights) {
        double& longer = box.columns > box.rows ? box.columns : box.rows;
        longer *= 0.9;
    }
    return box;
}

/// Steps along the rows of a face, over its edges too.
class RowWalk
{
public:
    /// \param steps  one column and one row, in (u,v) of the place's face
    RowWalk(const FilterSurface& surface, const SurfacePlace& place, const glm::dmat2& steps)
        : m_surface(&surface)
        , m_walk{place, steps, false}
    {
    }

    void moveColumns(double columns) { move(columns * m_walk.carried[0]); }
    void moveRows(double rows) { move(rows * m_walk.carried[1]); }
    const SurfacePlace& place() const { return m_walk.end; }

private:
    void move(glm::dvec2 step)
    {
        m_walk = walkStraight(*m_surface, m_walk.end, step, m_walk.carried);
    }

    const FilterSurface* m_surface;
    SurfaceWalk m_walk;
};

/// Sums the box row by row. Texels of the face are read by number; where a row leaves the face it
/// is followed over the surface, half a texel at a time.
class BoxSum
{
public:
    BoxSum(const FilterScene& scene,
           const SurfacePlace& centre,
           Level level,
           int group,
           const AxisWeights& columns,
           const AxisWeights& rows)
        : m_scene(scene)
        , m_level(level)
        , m_group(group)
        , m_columns(columns)
        , m_rows(rows)
        , m_reader(scene, centre, level, group)
        , m_face(centre.face)
    {
        const double r = m_reader.resolution();
        m_steps = glm::dmat2(glm::dvec2(0.5 / r, 0), glm::dvec2(-0.5 / r, 1 / r));
        // From the middle of the box up and down, and from there along the rows.
        const int middle = rows.middle();
        const glm::dvec2 to = pointOf(columns.first + columns.middle(), rows.first + middle);
        const SurfaceWalk start = walkStraight(scene.surface(), centre, to - centre.uv, m_steps);
        RowWalk up(scene.surface(), start.end, start.carried);
        RowWalk down = up;
        addRow(middle, up);
        for (int k = middle + 1; k < rows.count; ++k) {
            up.moveRows(1);
            addRow(k, up);
        }
        for (int k = middle - 1; k >= 0; --k) {
            down.moveRows(-1);
            addRow(k, down);
        }
    }

    const TexelSum& total() const { return m_sum; }

private:
    /// Point in the middle of a row's height.
    glm::dvec2 pointOf(int column, int row) const
    {
        const double v = row + 0.5;
        return glm::dvec2(column / kColumnsPerTexel - v / 2, v) / double(m_reader.resolution());
    }

    void addRow(int k, const RowWalk& middle)
    {
        const double weight = m_rows.at(k);
        const int row = m_rows.first + k;
        for (const int direction : {1, -1}) {
            std::optional<RowWalk> walk = middle;
            int walked = m_columns.middle();
            const int begin = direction > 0 ? walked : walked - 1;
            for (int c = begin; c >= 0 && c < m_columns.count; c += direction) {
                const double w = weight * m_columns.at(c);
                const RowTexel at{m_columns.first + c, row};
                if (const float* texel = m_reader.texelInside(at)) {
                    m_sum.add(texel, w);
                    walk.reset();
                    walked = c;
                    continue;
                }
                if (!walk) {
                    walk.emplace(m_scene.surface(),
                                 SurfacePlace{m_face, pointOf(m_columns.first + walked, row)},
                                 m_steps);
                }
                walk->moveColumns(c - walked);
                walked = c;
                m_sum.add(texelUnder(m_scene, walk->place(), m_level, m_group), w);
            }
        }
    }

    const FilterScene& m_scene;
    Level m_level;
    int m_group;
    const AxisWeights& m_columns;
    const AxisWeights& m_rows;
    RowReader m_reader;
    FaceId m_face;
    glm::dmat2 m_steps{0};
    TexelSum m_sum;
};

/// The finest level on which the box is not too wide.
Level levelOf(const FilterScene& scene, const QueryEllipse& ellipse, FaceId face, const RowBox& box)
{
    // Lengths as in an equilateral face of the same area, so that the continuous field applies.
    const FaceShape& shape = scene.surface().shape(face);
    const double edge = std::sqrt(shape.e1.x * shape.e2.y * 2 / std::numbers::sqrt3);
    const double narrow = edge * std::min(box.x, box.y);
    const Level base = scene.level(face);
    Level level =
        nearestLevel(scene, face, std::floor(levelOfEdge(ellipse, narrow / kNarrowSigma)));
    while (level > Level(0) && levelBox(box, level, base).taps() > kMostBoxTaps) {
        level = level.coarser();
    }
    return level;
}

QueryCost separableAnswer(const FilterScene& scene,
                          const QueryEllipse& ellipse,
                          FaceId face,
                          int group,
                          GroupValue& value)
{
    const RowBox whole = rowBox(ellipse, scene.surface().shape(face));
    const Level level = levelOf(scene, ellipse, face, whole);
    const LevelBox box = cutToMostTaps(levelBox(whole, level, scene.level(face)));
    const double r = level.resolution();
    const AxisWeights columns(kColumnsPerTexel * (ellipse.uv.x + ellipse.uv.y / 2) * r,
                              box.columns);
    // A texel's centroid lies a sixth of a row above the row's middle where its column and row
    // are both even or both odd, below it elsewhere.
    const AxisWeights rows(ellipse.uv.y * r - 0.5, box.rows, columns.alternating() / 6);
    const BoxSum sum(scene, {face, ellipse.uv}, level, group, columns, rows);
    sum.total().store(value.data());
    return {static_cast<float>(level.log2()),
            static_cast<std::uint32_t>(columns.count * rows.count)};
}

} // namespace

MethodEntry separableMethod()
{
    MethodEntry entry;
    entry.name = "separable";
    entry.title = "Separable in rows";
    entry.about = "A Gaussian along rows of texels times one across them, over the bounding box of "
                  "the ellipse on a mip level.";
    entry.claims = {.affineKept = Claim::Yes};
    entry.make = [](double) { return perQueryMethod(separableAnswer); };
    return entry;
}

} // namespace trixel
