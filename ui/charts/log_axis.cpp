// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/log_axis.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace trixel::ui {

namespace {

/// Free ends, so that no marker lies on the frame.
constexpr double kMargin = 0.05;
/// An axis spans a factor of 4 at least.
constexpr double kLeastSpan = 0.6;
/// Share of the axis that zero takes at one end, infinity at the other.
constexpr double kFloorShare = 0.11;
constexpr double kFloorPlace = 0.045;
/// Beyond this many decades lines within a decade only grey the plot.
constexpr double kMostFineDecades = 6;

constexpr std::array kFine{1, 2, 3, 4, 5, 6, 7, 8, 9};

/// Which numbers of which decades are written, densest first.
struct Density
{
    std::array<int, 3> digits;
    std::size_t count;
    int everyDecades;

    std::span<const int> used() const { return std::span(digits).first(count); }
};
constexpr Density kDensities[] = {{{1, 2, 5}, 3, 1},
                                  {{1, 3, 0}, 2, 1},
                                  {{1, 0, 0}, 1, 1},
                                  {{1, 0, 0}, 1, 2},
                                  {{1, 0, 0}, 1, 3},
                                  {{1, 0, 0}, 1, 5},
                                  {{1, 0, 0}, 1, 10}};

bool isShown(double value)
{
    return std::isfinite(value) && value >= 0;
}

} // namespace

LogAxis::LogAxis(std::span<const double> values, Quantity quantity, double decades)
    : m_quantity(quantity)
{
    double most = 0;
    for (const double value : values) {
        m_hasCeiling = m_hasCeiling || (std::isinf(value) && value > 0);
        most = isShown(value) ? std::max(most, value) : most;
    }
    const double threshold = most * std::pow(10, -decades);
    double least = most;
    for (const double value : values) {
        if (isShown(value) && value > 0 && value >= threshold) {
            least = std::min(least, value);
        } else if (isShown(value)) {
            m_hasFloor = true;
            m_mostBelow = std::max(m_mostBelow, value);
        }
    }
    m_least = most > 0 ? least : 1;
    m_most = most > 0 ? most : 1;
    const double low = std::log10(m_least);
    const double high = std::log10(m_most);
    const double missing = std::max(0.0, kLeastSpan - (high - low)) / 2;
    const double margin = kMargin * (high - low + 2 * missing);
    m_low = low - missing - margin;
    m_high = high + missing + margin;
}

double LogAxis::place(double value) const
{
    if (isBelow(value)) {
        return kFloorPlace;
    }
    if (m_hasCeiling && std::isinf(value)) {
        return 1 - kFloorPlace;
    }
    return placeOfLog(std::log10(std::max(value, 1e-300)));
}

double LogAxis::placeOfLog(double log) const
{
    const double start = m_hasFloor ? kFloorShare : 0;
    const double end = m_hasCeiling ? 1 - kFloorShare : 1;
    return start + (end - start) * std::clamp((log - m_low) / (m_high - m_low), 0.0, 1.0);
}

int LogAxis::textsWith(std::span<const int> digits, int everyDecades) const
{
    int count = 0;
    for (int decade = static_cast<int>(std::floor(m_low)); decade <= m_high; ++decade) {
        if (decade % everyDecades != 0) {
            continue;
        }
        count += static_cast<int>(std::ranges::count_if(digits, [&](int digit) {
            const double at = decade + std::log10(digit);
            return at >= m_low && at <= m_high;
        }));
    }
    return count;
}

QString LogAxis::floorText() const
{
    if (m_mostBelow == 0) {
        return "0";
    }
    // Rounded up to one digit, so that what is said holds for all of them.
    const double unit = std::pow(10, std::floor(std::log10(m_mostBelow)));
    return QChar(0x2264) + quantityText(std::ceil(m_mostBelow / unit) * unit, m_quantity, 1);
}

std::vector<Tick> LogAxis::ticks(int mostTexts) const
{
    const auto fitting = std::ranges::find_if(kDensities, [&](const Density& density) {
        return textsWith(density.used(), density.everyDecades) <= mostTexts;
    });
    const Density& chosen =
        fitting != std::end(kDensities) ? *fitting : *std::prev(std::end(kDensities));
    const bool fine = m_high - m_low <= kMostFineDecades;

    std::vector<Tick> ticks;
    if (m_hasFloor) {
        ticks.push_back({kFloorPlace, floorText()});
    }
    for (int decade = static_cast<int>(std::floor(m_low)); decade <= m_high; ++decade) {
        for (const int digit : kFine) {
            const double at = decade + std::log10(digit);
            if (at < m_low || at > m_high || (digit > 1 && !fine)) {
                continue;
            }
            const bool written = decade % chosen.everyDecades == 0 &&
                                 std::ranges::find(chosen.used(), digit) != chosen.used().end();
            const double value = digit * std::pow(10, decade);
            ticks.push_back(
                {placeOfLog(at), written ? quantityText(value, m_quantity) : QString()});
        }
    }
    if (m_hasCeiling) {
        ticks.push_back({1 - kFloorPlace, QChar(0x221E)});
    }
    return ticks;
}

} // namespace trixel::ui
