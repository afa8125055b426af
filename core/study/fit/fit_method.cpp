// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/fit/fit_method.h"

#include "core/study/processor_clock.h"
#include "core/study/views/view_queries.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace trixel {
namespace {

constexpr double kPixelsPerCamera = 2000;

/// Every method of the table at every value of its curve, those that refuse or judge apart.
std::vector<MethodChoice> candidates()
{
    std::vector<MethodChoice> all;
    for (const MethodEntry& entry : filterMethods()) {
        if (entry.name == "exact" || entry.name == "ewa-base") {
            continue;
        }
        if (!entry.parameter || entry.parameter->curve.empty()) {
            all.push_back({std::string(entry.name), std::nullopt});
            continue;
        }
        for (const double value : entry.parameter->curve) {
            all.push_back({std::string(entry.name), value});
        }
    }
    return all;
}

Result<QueryArrays> pixelsOf(const Surface& surface, const SceneViews& views, Threads threads)
{
    NoProgress unseen;
    QueryArrays all;
    for (const ViewCamera& camera : views.cameras) {
        const double pixels = static_cast<double>(camera.width) * camera.height;
        const int step = std::max(1, static_cast<int>(std::sqrt(pixels / kPixelsPerCamera)));
        const auto seen = viewQueries(surface, camera, {step, 0}, threads, unseen);
        if (!seen) {
            return tl::unexpected(seen.error());
        }
        const QueryArrays& q = seen->queries;
        for (std::size_t i = 0; i < q.size(); ++i) {
            all.add(q.face[i], {q.u[i], q.v[i]}, {q.uw1[i], q.vw1[i]}, {q.uw2[i], q.vw2[i]});
        }
    }
    return all;
}

double rmsOf(std::span<const float> a, std::span<const float> b)
{
    double squares = 0;
    for (std::size_t k = 0; k < a.size(); ++k) {
        const double difference = static_cast<double>(a[k]) - static_cast<double>(b[k]);
        squares += difference * difference;
    }
    return std::sqrt(squares / static_cast<double>(a.size()));
}

/// The shortest of three runs.
double secondsOf(const FilterMethod& method,
                 const FilterScene& scene,
                 const FilterQueries& queries,
                 ResultArrays& results)
{
    double shortest = std::numeric_limits<double>::infinity();
    for (int run = 0; run < 3; ++run) {
        const double begin = processorSeconds();
        method.filter(scene, queries, results.results());
        shortest = std::min(shortest, processorSeconds() - begin);
    }
    return shortest;
}

} // namespace

Result<std::optional<FitMethod>> fitMethod(const Surface& surface,
                                           const FilterScene& scene,
                                           const SceneViews& views,
                                           double tolerance,
                                           Threads threads,
                                           Progress& progress)
{
    const auto pixels = pixelsOf(surface, views, threads);
    if (!pixels || pixels->size() == 0) {
        return std::optional<FitMethod>();
    }
    const FilterQueries queries = pixels->queries();
    ResultArrays exact(queries.size(), scene.channels());
    filterParallel(*makeMethod({"exact", std::nullopt}), scene, queries, exact.results(), threads);

    const std::vector<MethodChoice> methods = candidates();
    std::optional<FitMethod> best;
    for (std::size_t k = 0; k < methods.size(); ++k) {
        if (!progress.report(static_cast<double>(k) / static_cast<double>(methods.size()))) {
            return cancelled();
        }
        const auto method = makeMethod(methods[k]);
        ResultArrays results(queries.size(), scene.channels());
        filterParallel(*method, scene, queries, results.results(), threads);
        const double rms = rmsOf(results.values, exact.values);
        if (!(rms <= tolerance)) {
            continue;
        }
        const double nanoseconds =
            1e9 * secondsOf(*method, scene, queries, results) / static_cast<double>(queries.size());
        if (!best || nanoseconds < best->nanoseconds) {
            best = FitMethod{methods[k], nanoseconds, rms, queries.size()};
        }
    }
    return best;
}

} // namespace trixel
