// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/arguments.h"

#include <charconv>
#include <cmath>
#include <optional>

namespace trixel::app {
namespace {

tl::unexpected<Error>
refused(std::string_view option, const std::string& expected, std::string_view found)
{
    return contentsError(std::string(option) + ": expected " + expected + ", found '" +
                         std::string(found) + "'.");
}

/// The number that the whole text is, whatever the locale.
template <class T>
std::optional<T> numberOf(std::string_view text)
{
    T value{};
    const char* end = text.data() + text.size();
    const auto [stop, problem] = std::from_chars(text.data(), end, value);
    return problem == std::errc{} && stop == end ? std::optional(value) : std::nullopt;
}

} // namespace

Result<std::int64_t>
wholeNumber(std::string_view option, std::string_view text, std::int64_t low, std::int64_t high)
{
    const auto value = numberOf<std::int64_t>(text);
    if (!value || *value < low || *value > high) {
        return refused(option,
                       "a whole number from " + std::to_string(low) + " to " + std::to_string(high),
                       text);
    }
    return *value;
}

Result<double> positiveNumber(std::string_view option, std::string_view text)
{
    const auto value = numberOf<double>(text);
    if (!value || !std::isfinite(*value) || *value <= 0) {
        return refused(option, "a number above 0", text);
    }
    return *value;
}

Result<std::vector<float>>
channelValues(std::string_view option, std::string_view text, int channels)
{
    std::vector<float> values;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        const auto value = numberOf<float>(text.substr(begin, end - begin));
        if (!value || !std::isfinite(*value)) {
            return refused(option, "numbers separated by commas", text);
        }
        values.push_back(*value);
        begin = end + 1;
    }
    const auto wanted = static_cast<std::size_t>(channels);
    if (values.size() == 1) {
        values.resize(wanted, values.front());
    }
    if (values.size() != wanted) {
        return refused(option, std::to_string(channels) + " numbers, one a channel", text);
    }
    return values;
}

Result<Level> level(std::string_view option, std::string_view text)
{
    return wholeNumber(option, text, 0, Level::kMax).map([](std::int64_t log2) {
        return Level(static_cast<int>(log2));
    });
}

Result<Threads> threads(std::string_view option, const std::optional<std::string>& text)
{
    constexpr std::int64_t kMaxThreads = 1024;
    if (!text) {
        return Threads::all();
    }
    return wholeNumber(option, *text, 1, kMaxThreads).map([](std::int64_t count) {
        return Threads{static_cast<unsigned>(count)};
    });
}

Result<TexelType> texelType(std::string_view option, std::string_view text)
{
    if (const auto type = texelTypeFromName(text)) {
        return *type;
    }
    return refused(option, "uint8, uint16, half or float", text);
}

} // namespace trixel::app
