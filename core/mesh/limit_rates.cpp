// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/limit_rates.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace trixel {

namespace {

/// Rates in use: few, so that faces keep theirs while the camera moves a little.
constexpr std::array<std::uint8_t, 14> kRates = {1, 2, 3, 4, 6, 8, 11, 16, 23, 32, 45, 64, 90, 128};
static_assert(kRates.back() == kMaxRate);

std::uint8_t rateFor(double bend, double power, double error)
{
    const double ratio = bend / error;
    const double pieces = power == 2 ? std::sqrt(ratio) : std::pow(ratio, 1 / power);
    for (const std::uint8_t rate : kRates) {
        if (pieces <= rate) {
            return rate;
        }
    }
    return kRates.back();
}

double errorAt(double bend, double power, int rate)
{
    return power == 2 ? bend / (rate * rate) : bend / std::pow(rate, power);
}

/// Next to an edge of few pieces the triangles are long, and bend along other directions, too.
constexpr int kLongest = 2;

class Planner
{
public:
    Planner(const LimitBends& bends, const ErrorScale& scale)
        : m_bends(bends)
    {
        m_scales.reserve(bends.faces().size());
        for (const FaceBend& face : bends.faces()) {
            m_scales.push_back(scale.at(face.bounds));
        }
    }

    RatePlan plan(double error)
    {
        m_edges.assign(m_bends.surface().edgeCount(), 1);
        m_plan.faces.assign(m_scales.size(), CutRates{});
        for (std::size_t f = 0; f < m_scales.size(); ++f) {
            askFor(f, error);
        }
        m_plan.error = 0;
        for (std::size_t f = 0; f < m_scales.size(); ++f) {
            settle(f);
        }
        return std::move(m_plan);
    }

private:
    void askFor(std::size_t f, double error)
    {
        const double scale = m_scales[f];
        if (scale <= 0) {
            return;
        }
        const FaceBend& bend = m_bends.faces()[f];
        const std::uint8_t inside = rateFor(bend.inside * scale, bend.power, error);
        m_plan.faces[f].inside = inside;
        const auto edges = m_bends.surface().edges(faceId(f));
        for (std::size_t e = 0; e < 3; ++e) {
            const std::uint8_t along = rateFor(bend.along[e] * scale, bend.power, error);
            const auto least = static_cast<std::uint8_t>((inside + kLongest - 1) / kLongest);
            m_edges[edges[e]] = std::max({m_edges[edges[e]], along, least});
        }
    }

    void settle(std::size_t f)
    {
        CutRates& rates = m_plan.faces[f];
        const auto edges = m_bends.surface().edges(faceId(f));
        bool isUniform = true;
        for (std::size_t e = 0; e < 3; ++e) {
            rates.edges[e] = m_edges[edges[e]];
            isUniform = isUniform && rates.edges[e] == rates.inside;
        }
        const FaceBend& bend = m_bends.faces()[f];
        double off = errorAt(bend.inside, bend.power, rates.inside);
        for (std::size_t e = 0; e < 3; ++e) {
            off = std::max(off, errorAt(bend.along[e], bend.power, rates.edges[e]));
        }
        m_plan.error = std::max(m_plan.error, off * m_scales[f]);
        if (!isUniform) { // what joins lattice and edges leaves wider triangles
            const int more = rates.inside + std::max(1, rates.inside / 4);
            rates.inside = static_cast<std::uint8_t>(std::min(more, kMaxRate));
        }
    }

    const LimitBends& m_bends;
    std::vector<double> m_scales; ///< one a face
    std::vector<std::uint8_t> m_edges;
    RatePlan m_plan;
};

/// About: enough to stay clear of what a card can hold.
std::size_t trianglesOf(const RatePlan& plan)
{
    std::size_t triangles = 0;
    for (const CutRates& rates : plan.faces) {
        triangles += std::size_t{rates.inside} * rates.inside + rates.edges[0] + rates.edges[1] +
                     rates.edges[2];
    }
    return triangles;
}

} // namespace

RatePlan
planRates(const LimitBends& bends, const ErrorScale& scale, double error, std::size_t mostTriangles)
{
    Planner planner(bends, scale);
    RatePlan plan = planner.plan(error);
    const std::size_t whole = 8 * bends.faces().size();
    while (trianglesOf(plan) > std::max(mostTriangles, whole)) {
        error *= 2;
        plan = planner.plan(error);
    }
    return plan;
}

} // namespace trixel
