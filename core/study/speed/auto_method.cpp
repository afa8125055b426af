// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/speed/auto_method.h"

#include <algorithm>
#include <iomanip>
#include <sstream>
#include <tuple>

namespace trixel {
namespace {

constexpr std::size_t kChunk = 1024;

Result<CostEntry> cheapest(const CostTable& table, FootprintClass footprintClass, double tolerance)
{
    const CostEntry* chosen = nullptr;
    const CostEntry* best = nullptr;
    for (const CostEntry& entry : table.entries) {
        if (entry.footprintClass != footprintClass) {
            continue;
        }
        best = best == nullptr || entry.rms < best->rms ? &entry : best;
        const auto rank = [](const CostEntry& e) { return std::tuple(e.cost, e.rms); };
        if (entry.rms <= tolerance && (chosen == nullptr || rank(entry) < rank(*chosen))) {
            chosen = &entry;
        }
    }
    if (chosen != nullptr) {
        return *chosen;
    }
    std::ostringstream text;
    text << "No method has an RMS error within " << tolerance << " for " << nameOf(footprintClass)
         << " footprints";
    if (best != nullptr) {
        text << "; the best is " << toText(best->method) << " with " << best->rms;
    }
    return contentsError(text.str() + ".");
}

} // namespace

Result<AutoChoices> chooseMethods(const CostTable& table, double tolerance)
{
    AutoChoices choices;
    choices.tolerance = tolerance;
    for (const FootprintClass footprintClass : footprintClasses()) {
        auto entry = cheapest(table, footprintClass, tolerance);
        if (!entry) {
            return tl::unexpected(entry.error());
        }
        choices.classes[static_cast<std::size_t>(footprintClass)] = std::move(*entry);
    }
    return choices;
}

std::string toText(const AutoChoices& choices)
{
    std::ostringstream text;
    for (const CostEntry& entry : choices.classes) {
        text << std::left << std::setw(18) << nameOf(entry.footprintClass) << std::setw(24)
             << toText(entry.method) << std::right << std::setprecision(3) << std::setw(10)
             << entry.cost << " ns" << std::setw(12) << 100 * entry.rms << " % rms\n";
    }
    return text.str();
}

/// Queries of one chunk in the order of their methods, and where the answers go.
class AutoMethod::Chunk
{
public:
    Chunk(int channels, std::size_t methods, const FilterResults& results)
        : m_channels(static_cast<std::size_t>(channels))
        , m_ends(methods)
        , m_values(m_channels * kChunk)
        , m_levels(results.levels.empty() ? 0 : kChunk)
        , m_taps(results.taps.empty() ? 0 : kChunk)
    {
        m_sorted.face.resize(kChunk);
        for (std::vector<float>* column : columns()) {
            column->resize(kChunk);
        }
    }

    /// \param methodOf  of each query of the chunk
    void sort(const FilterQueries& queries, std::span<const std::uint8_t> methodOf)
    {
        std::ranges::fill(m_ends, 0);
        for (const std::uint8_t method : methodOf) {
            ++m_ends[method];
        }
        std::size_t begin = 0;
        for (std::size_t& end : m_ends) {
            begin += std::exchange(end, begin); // where the next of it goes
        }
        for (std::size_t i = 0; i < queries.size(); ++i) {
            const std::size_t to = m_ends[methodOf[i]]++;
            m_origin[to] = static_cast<std::uint16_t>(i);
            m_sorted.face[to] = queries.face[i];
            m_sorted.u[to] = queries.u[i];
            m_sorted.v[to] = queries.v[i];
            m_sorted.uw1[to] = queries.uw1[i];
            m_sorted.vw1[to] = queries.vw1[i];
            m_sorted.uw2[to] = queries.uw2[i];
            m_sorted.vw2[to] = queries.vw2[i];
        }
    }

    void answer(const FilterMethod& filter, std::size_t method, const FilterScene& scene)
    {
        const std::size_t begin = method == 0 ? 0 : m_ends[method - 1];
        const std::size_t count = m_ends[method] - begin;
        if (count == 0) {
            return;
        }
        const auto part = [&](auto& all) {
            return all.empty() ? std::span(all) : std::span(all).subspan(begin, count);
        };
        filter.filter(scene,
                      m_sorted.queries().subspan(begin, count),
                      {std::span(m_values).subspan(begin), kChunk, part(m_levels), part(m_taps)});
    }

    /// \param first  of the chunk among the results
    void scatter(const FilterResults& results, std::size_t first, std::size_t count) const
    {
        for (std::size_t c = 0; c < m_channels; ++c) {
            float* to = results.values.data() + c * results.stride + first;
            for (std::size_t k = 0; k < count; ++k) {
                to[m_origin[k]] = m_values[c * kChunk + k];
            }
        }
        for (std::size_t k = 0; k < count && !m_levels.empty(); ++k) {
            results.levels[first + m_origin[k]] = m_levels[k];
        }
        for (std::size_t k = 0; k < count && !m_taps.empty(); ++k) {
            results.taps[first + m_origin[k]] = m_taps[k];
        }
    }

private:
    std::array<std::vector<float>*, 6> columns()
    {
        return {
            &m_sorted.u, &m_sorted.v, &m_sorted.uw1, &m_sorted.vw1, &m_sorted.uw2, &m_sorted.vw2};
    }

    std::size_t m_channels;
    QueryArrays m_sorted;
    std::array<std::uint16_t, kChunk> m_origin{};
    std::vector<std::size_t> m_ends; // of each method's queries
    std::vector<float> m_values, m_levels;
    std::vector<std::uint32_t> m_taps;
};

AutoMethod::AutoMethod(const AutoChoices& choices)
    : m_choices(choices)
{
    std::vector<MethodChoice> known;
    for (std::size_t k = 0; k < kFootprintClasses; ++k) {
        const MethodChoice& choice = choices.classes[k].method;
        const auto at = std::ranges::find(known, choice);
        m_methodOfClass[k] = static_cast<std::uint8_t>(at - known.begin());
        if (at == known.end()) {
            known.push_back(choice);
            m_methods.push_back(makeMethod(choice));
        }
    }
}

AutoMethod::~AutoMethod() = default;

const MethodChoice& AutoMethod::choiceFor(const FilterScene& scene,
                                          const FilterQueries& queries,
                                          std::size_t index) const
{
    std::uint8_t found = 0;
    classify(scene, queries.subspan(index, 1), std::span(&found, 1));
    return m_choices.classes[found].method;
}

void AutoMethod::filter(const FilterScene& scene,
                        const FilterQueries& queries,
                        const FilterResults& results) const
{
    if (m_methods.size() == 1) {
        m_methods.front()->filter(scene, queries, results);
        return;
    }
    if (queries.size() == 0) {
        return;
    }
    check(results.values.size() >=
              static_cast<std::size_t>(scene.channels() - 1) * results.stride + queries.size(),
          "room for every value");
    Chunk chunk(scene.channels(), m_methods.size(), results);
    std::array<std::uint8_t, kChunk> methodOf{};
    for (std::size_t first = 0; first < queries.size(); first += kChunk) {
        const std::size_t count = std::min(kChunk, queries.size() - first);
        const std::span<std::uint8_t> found = std::span(methodOf).first(count);
        classify(scene, queries.subspan(first, count), found);
        std::ranges::transform(
            found, found.begin(), [&](std::uint8_t k) { return m_methodOfClass[k]; });
        chunk.sort(queries.subspan(first, count), found);
        for (std::size_t m = 0; m < m_methods.size(); ++m) {
            chunk.answer(*m_methods[m], m, scene);
        }
        chunk.scatter(results, first, count);
    }
}

Result<std::unique_ptr<AutoMethod>> makeAuto(double tolerance, Progress& progress)
{
    return findCostTable(costTablePath(), progress)
        .and_then(
            [&](const FoundCostTable& found) { return chooseMethods(found.table, tolerance); })
        .map([](const AutoChoices& choices) { return std::make_unique<AutoMethod>(choices); });
}

} // namespace trixel
