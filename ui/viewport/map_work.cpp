// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/map_work.h"

#include <QElapsedTimer>

#include "core/study/views/view_map.h"
#include "ui/viewport/map_scale.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <optional>

namespace trixel::ui {

namespace {

/// Bands are made so large that each takes about so long.
constexpr double kBandMs = 60;
constexpr int kFirstBandQueries = 256;
constexpr int kMostBandRows = 128;

constexpr float kNoValue = std::numeric_limits<float>::quiet_NaN();

class CancelOnly final : public Progress
{
public:
    explicit CancelOnly(const QPromise<MapBand>& promise)
        : m_promise(promise)
    {
    }
    bool report(double /*fraction*/) override { return !m_promise.isCanceled(); }

private:
    const QPromise<MapBand>& m_promise;
};

std::uint32_t opaque(render::Rgb color)
{
    return std::bit_cast<std::uint32_t>(
        std::array<std::uint8_t, 4>{color[0], color[1], color[2], 255});
}

/// What a run of queries comes to.
struct Answers
{
    std::vector<std::uint32_t> colors;
    std::vector<float> values;       ///< empty for Filtered
    std::vector<render::Mark> marks; ///< empty where the look shows none
};

/// Methods of the work, made once.
class Evaluator
{
public:
    explicit Evaluator(const MapWork& work)
        : m_work(work)
        , m_scale(MapScale::of(work.map))
    {
        if (work.scene) {
            m_method = makeMethod(work.method);
        }
        if (work.map == ViewMapKind::Error) {
            m_exact = makeMethod({std::string(kExactMethod), std::nullopt});
        }
    }

    Answers operator()(const FilterQueries& queries) const
    {
        return m_work.map == ViewMapKind::Filtered ? filtered(queries) : measured(queries);
    }

private:
    Answers measured(const FilterQueries& queries) const
    {
        Answers answers;
        answers.values.resize(queries.size());
        if (m_work.map == ViewMapKind::Condition) {
            conditions(queries, answers.values);
        } else {
            filterDifferences(*m_work.scene,
                              *m_method,
                              *m_exact,
                              m_work.range,
                              queries,
                              Threads::all(),
                              answers.values);
        }
        answers.colors.reserve(queries.size());
        for (const float value : answers.values) {
            answers.colors.push_back(opaque(m_scale.color(double{value})));
        }
        return answers;
    }

    void conditions(const FilterQueries& queries, std::span<float> values) const
    {
        if (m_work.limit) {
            footprintConditions(m_work.limit->surface(), queries, Threads::all(), values);
        } else {
            footprintConditions(*m_work.surface, queries, Threads::all(), values);
        }
    }

    Answers filtered(const FilterQueries& queries) const
    {
        const int channels = m_work.scene->channels();
        ResultArrays results(queries.size(), channels);
        filterParallel(*m_method, *m_work.scene, queries, results.results(), Threads::all());
        // What is filtered lies over what is not: it has to be opaque.
        render::Look look = m_work.look;
        look.opaque = true;
        const render::LookRule rule = render::LookRule::of(m_work.format, look);
        Answers answers;
        answers.colors.reserve(queries.size());
        std::vector<float> texel(static_cast<std::size_t>(channels));
        for (std::size_t i = 0; i < queries.size(); ++i) {
            for (std::size_t c = 0; c < texel.size(); ++c) {
                texel[c] = results.values[i + c * queries.size()];
            }
            answers.colors.push_back(std::bit_cast<std::uint32_t>(render::shade(rule, texel)));
            if (rule.marks) {
                answers.marks.push_back(render::markOf(m_work.format, texel, look));
            }
        }
        return answers;
    }

    const MapWork& m_work;
    MapScale m_scale;
    std::unique_ptr<const FilterMethod> m_method;
    std::unique_ptr<const FilterMethod> m_exact;
};

/// One pass over the picture.
class Pass
{
public:
    Pass(const MapWork& work, int step, ViewQueries queries)
        : m_camera(work.camera)
        , m_unit(work.unit)
        , m_hasValues(work.map != ViewMapKind::Filtered)
        , m_step(step)
        , m_queries(std::move(queries))
    {
    }

    bool isDone() const { return m_row >= m_camera.height; }

    /// The next rows, of about so many queries.
    MapBand next(const Evaluator& evaluate, std::size_t count)
    {
        const std::size_t begin = m_next;
        const int firstRow = m_row;
        do {
            m_row = std::min(m_row + m_step, m_camera.height);
            while (m_next < m_queries.size() && rowOf(m_next) < m_row) {
                ++m_next;
            }
        } while (!isDone() && m_next - begin < count && m_row - firstRow < kMostBandRows);
        MapBand band = emptyBand(firstRow);
        const Answers answers =
            evaluate(m_queries.queries.queries().subspan(begin, m_next - begin));
        for (std::size_t i = begin; i < m_next; ++i) {
            fill(band,
                 i,
                 answers.colors[i - begin],
                 m_hasValues ? answers.values[i - begin] : kNoValue);
            if (!answers.marks.empty() && answers.marks[i - begin] != render::Mark::None) {
                fillMarked(band, i, answers.marks[i - begin]);
            }
        }
        return band;
    }

private:
    int rowOf(std::size_t query) const
    {
        return static_cast<int>(m_queries.pixel[query]) / m_camera.width;
    }

    MapBand emptyBand(int firstRow) const
    {
        MapBand band;
        band.step = m_step;
        band.firstRow = firstRow;
        band.endsPass = isDone();
        const std::size_t size =
            static_cast<std::size_t>(m_row - firstRow) * static_cast<std::size_t>(m_camera.width);
        band.pixels.resize(size);
        if (m_hasValues) {
            band.values.resize(size, kNoValue);
        }
        return band;
    }

    /// The block of a pixel, all in one colour.
    void fill(MapBand& band, std::size_t query, std::uint32_t color, float value) const
    {
        const int x = static_cast<int>(m_queries.pixel[query]) % m_camera.width / m_step * m_step;
        const int y = rowOf(query) / m_step * m_step;
        const int right = std::min(x + m_step, m_camera.width);
        const int below = std::min(y + m_step, m_row);
        for (int row = y; row < below; ++row) {
            const auto begin = static_cast<std::ptrdiff_t>(row - band.firstRow) * m_camera.width;
            std::fill(band.pixels.begin() + begin + x, band.pixels.begin() + begin + right, color);
            if (m_hasValues) {
                std::fill(
                    band.values.begin() + begin + x, band.values.begin() + begin + right, value);
            }
        }
    }

    /// The block of a pixel in the colour and the pattern of a mark.
    void fillMarked(MapBand& band, std::size_t query, render::Mark mark) const
    {
        const int left =
            static_cast<int>(m_queries.pixel[query]) % m_camera.width / m_step * m_step;
        const int top = rowOf(query) / m_step * m_step;
        const std::uint32_t plain = std::bit_cast<std::uint32_t>(render::markColor(mark));
        const std::uint32_t ink = std::bit_cast<std::uint32_t>(render::kMarkInk);
        for (int y = top; y < std::min(top + m_step, m_row); ++y) {
            const auto row = static_cast<std::size_t>(y - band.firstRow) *
                             static_cast<std::size_t>(m_camera.width);
            for (int x = left; x < std::min(left + m_step, m_camera.width); ++x) {
                const bool isInk = render::hasInk(
                    mark, static_cast<int>(x / m_unit), static_cast<int>(y / m_unit));
                band.pixels[row + static_cast<std::size_t>(x)] = isInk ? ink : plain;
            }
        }
    }

    const ViewCamera& m_camera;
    double m_unit;
    bool m_hasValues;
    int m_step;
    ViewQueries m_queries;
    std::size_t m_next = 0;
    int m_row = 0;
};

Result<ViewQueries> queriesOf(const MapWork& work, int step, Progress& progress)
{
    const PixelSubset subset{step, 0};
    if (work.queries) {
        return work.queries(step);
    }
    if (work.limit) {
        return viewQueries(*work.limit, work.camera, subset, Threads::all(), progress);
    }
    return viewQueries(*work.surface, work.camera, subset, Threads::all(), progress);
}

} // namespace

void computeMap(QPromise<MapBand>& promise, const MapWork& work)
{
    CancelOnly progress(promise);
    const Evaluator evaluate(work);
    double perBand = kFirstBandQueries;
    for (const int step : kMapSteps) {
        auto queries = queriesOf(work, step, progress);
        if (!queries) {
            return; // cancelled
        }
        Pass pass(work, step, std::move(*queries));
        while (!pass.isDone()) {
            if (promise.isCanceled()) {
                return;
            }
            QElapsedTimer clock;
            clock.start();
            promise.addResult(pass.next(evaluate, static_cast<std::size_t>(perBand)));
            const double ms = std::max(0.1, static_cast<double>(clock.nsecsElapsed()) / 1e6);
            perBand = std::clamp(perBand * kBandMs / ms, 16.0, 4 * perBand);
        }
    }
}

} // namespace trixel::ui
