// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/stability/sweeps.h"

#include <array>
#include <charconv>

namespace trixel::sweeps {

namespace {

/// "1e-06" as "1e-6", "1e+30" as "1e30".
std::string withShortExponent(std::string text)
{
    const std::size_t e = text.find('e');
    if (e == std::string::npos) {
        return text;
    }
    std::size_t digits = e + 2;
    while (digits + 1 < text.size() && text[digits] == '0') {
        text.erase(digits, 1);
    }
    if (text[e + 1] == '+') {
        text.erase(e + 1, 1);
    }
    return text;
}

} // namespace

SweepValue sweepValue(double value)
{
    if (std::isnan(value)) {
        return {value, "NaN"};
    }
    if (std::isinf(value)) {
        return {value, value > 0 ? "Inf" : "-Inf"};
    }
    std::array<char, 32> text{};
    if (value == std::round(value) && std::abs(value) < 1e5) {
        const auto whole = static_cast<long>(value);
        return {value, std::to_string(whole)};
    }
    const auto end =
        std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, 3)
            .ptr;
    return {value, withShortExponent({text.data(), end})};
}

std::vector<SweepValue>
geometric(double from, double to, double ratio, std::initializer_list<double> further)
{
    std::vector<SweepValue> values;
    const double steps = std::log(to / from) / std::log(ratio);
    for (int k = 0; k <= static_cast<int>(steps + 1e-6); ++k) {
        values.push_back(sweepValue(from * std::pow(ratio, k)));
    }
    for (const double value : further) {
        values.push_back(sweepValue(value));
    }
    return values;
}

} // namespace trixel::sweeps
