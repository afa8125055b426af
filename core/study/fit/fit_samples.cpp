// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/fit/fit_samples.h"

#include "core/lattice/texel.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace trixel {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
const Level kMostCells(4);
/// Fewer points would let faces pass by luck.
const Level kFewestCells(1);
/// Where the pixels of a face are counted.
const Level kSurveyCells(1);
/// The same where part of it is hidden.
const Level kPartCells(3);

struct Sample
{
    glm::dvec2 uv{0};
    double spacing = kNever;
};

glm::dvec3 positionAt(const std::array<glm::vec3, 3>& corners, glm::dvec2 uv)
{
    const glm::dvec3 a(corners[0]);
    return a + uv.x * (glm::dvec3(corners[1]) - a) + uv.y * (glm::dvec3(corners[2]) - a);
}

/// A number in [0,1), always the same for the same place.
double hashed(std::uint64_t face, std::uint64_t cell, std::uint64_t which)
{
    std::uint64_t x = (face << 20U) ^ (cell << 2U) ^ which;
    x = (x ^ (x >> 30U)) * 0xBF58476D1CE4E5B9ULL + 0x9E3779B97F4A7C15ULL;
    x = (x ^ (x >> 27U)) * 0x94D049BB133111EBULL;
    return static_cast<double>((x ^ (x >> 31U)) >> 11U) * 0x1p-53;
}

/// A point of a cell, every place in it as likely as every other.
glm::dvec2 pointOfCell(Level cells, FaceId face, std::uint32_t cell)
{
    const auto at = corners(cells, texelAt(cells, static_cast<TexelIndex>(cell)));
    double a = hashed(indexOf(face), cell, 0);
    double b = hashed(indexOf(face), cell, 1);
    if (a + b > 1) {
        a = 1 - a;
        b = 1 - b;
    }
    return at[0] + a * (at[1] - at[0]) + b * (at[2] - at[0]);
}

class FaceSampler
{
public:
    FaceSampler(const Surface& surface,
                const FilterSurface& shapes,
                const FaceViews& views,
                FaceId face)
        : m_corners(surface.mesh().corners(face))
        , m_area(shapes.shape(face).e1.x * shapes.shape(face).e2.y / 2)
        , m_views(views)
        , m_face(face)
    {
    }

    /// How much of the face is seen, and how closely.
    struct Survey
    {
        double pixels = 0;
        double finest = kNever;
        bool isWhole = true; ///< whether every point that was asked is seen

        void add(double spacing)
        {
            pixels += 1 / (spacing * spacing);
            finest = std::min(finest, spacing);
            isWhole = isWhole && spacing < kNever;
        }
    };

    Survey survey() const
    {
        Survey survey = surveyAt(kSurveyCells);
        if (!survey.isWhole) {
            survey = surveyAt(kPartCells);
        }
        return survey.finest < kNever ? survey : surveyOfSliver();
    }

    std::vector<Sample> samples(double pixels, double finest, Level level) const
    {
        Level cells(0);
        while (cells < kMostCells && cells < level &&
               (cells < kFewestCells || 2.0 * cells.texelCount() <= pixels)) {
            cells = Level(cells.log2() + 1);
        }
        std::vector<Sample> found;
        for (std::uint32_t cell = 0; cell < cells.texelCount(); ++cell) {
            const Sample sample = at(pointOfCell(cells, m_face, cell));
            if (sample.spacing < kNever) {
                found.push_back(sample);
            }
        }
        if (found.empty()) { // what is seen lies between the points
            found.push_back({glm::dvec2(1.0 / 3.0), finest});
        }
        return found;
    }

private:
    Survey surveyAt(Level cells) const
    {
        Survey survey;
        for (std::uint32_t cell = 0; cell < cells.texelCount(); ++cell) {
            survey.add(at(centroid(cells, texelAt(cells, static_cast<TexelIndex>(cell)))).spacing);
        }
        for (const glm::dvec2 corner : {glm::dvec2(0, 0), glm::dvec2(1, 0), glm::dvec2(0, 1)}) {
            survey.add(at(corner).spacing);
        }
        survey.pixels *= m_area / (cells.texelCount() + 3.0);
        return survey;
    }

    /// Of a face that is seen, but at none of the points.
    Survey surveyOfSliver() const
    {
        double spacing = kNever;
        for (const glm::vec3 corner : m_corners) {
            spacing = std::min(spacing, m_views.spacingUnhidden(m_face, glm::dvec3(corner)));
        }
        Survey survey;
        survey.add(spacing);
        survey.pixels *= m_area / (4.0 * kPartCells.texelCount());
        return survey;
    }

    Sample at(glm::dvec2 uv) const
    {
        return {uv, m_views.finestSpacing(m_face, positionAt(m_corners, uv))};
    }

    std::array<glm::vec3, 3> m_corners;
    double m_area;
    const FaceViews& m_views;
    FaceId m_face;
};

} // namespace

std::array<glm::vec2, 2> roundFootprint(const FaceShape& shape, double spacing)
{
    return {glm::vec2(shape.toUv({spacing, 0})), glm::vec2(shape.toUv({0, spacing}))};
}

FitSamples fitSamples(const Surface& surface,
                      const FilterSurface& shapes,
                      const FaceMap<Level>& levels,
                      const FaceViews& views,
                      Threads threads)
{
    const std::size_t faces = surface.mesh().faceCount();
    FitSamples all;
    all.pixels = FaceMap<double>(faces);
    all.spacing = FaceMap<double>(faces, kNever);
    std::vector<std::vector<Sample>> found(faces);
    parallelFor(faces, 64, threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t f = begin; f < end; ++f) {
            const FaceSampler sampler(surface, shapes, views, faceId(f));
            const auto survey = sampler.survey();
            all.pixels[faceId(f)] = survey.pixels;
            all.spacing[faceId(f)] = survey.finest;
            if (survey.finest < kNever) {
                found[f] = sampler.samples(survey.pixels, survey.finest, levels[faceId(f)]);
            }
        }
    });
    all.begin.push_back(0);
    for (std::size_t f = 0; f < faces; ++f) {
        for (const Sample& sample : found[f]) {
            const auto [w1, w2] = roundFootprint(shapes.shape(faceId(f)), sample.spacing);
            all.queries.add(faceId(f), glm::vec2(sample.uv), w1, w2);
        }
        all.begin.push_back(static_cast<std::uint32_t>(all.queries.size()));
    }
    return all;
}

FaceMap<double> meanSquares(const FitSamples& samples,
                            std::span<const float> was,
                            std::span<const float> is,
                            int channels)
{
    const std::size_t count = samples.queries.size();
    check(was.size() == is.size() && was.size() == count * static_cast<std::size_t>(channels),
          "values of every sample");
    FaceMap<double> result(samples.pixels.size());
    for (std::size_t f = 0; f < samples.pixels.size(); ++f) {
        double squares = 0;
        std::size_t counted = 0;
        for (std::size_t i = samples.begin[f]; i < samples.begin[f + 1]; ++i) {
            for (std::size_t c = 0; c < static_cast<std::size_t>(channels); ++c) {
                const double before = was[c * count + i];
                const double after = is[c * count + i];
                if (std::isfinite(before)) {
                    const double difference = std::isfinite(after) ? after - before : kNever;
                    squares += difference * difference;
                    ++counted;
                }
            }
        }
        result[faceId(f)] = counted > 0 ? squares / static_cast<double>(counted) : 0;
    }
    return result;
}

} // namespace trixel
