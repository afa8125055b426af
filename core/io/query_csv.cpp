// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/query_csv.h"

#include "core/base/read_file.h"
#include "core/io/commit_file.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>

namespace trixel {
namespace {

constexpr std::array<std::string_view, 7> kColumns = {"face", "u", "v", "uw1", "vw1", "uw2", "vw2"};
constexpr std::size_t kLongestQuote = 40;

/// Cuts the text before the next separator off; the separator goes too.
std::string_view cutOff(std::string_view& text, char separator)
{
    const std::size_t end = text.find(separator);
    const std::string_view first = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    return first;
}

std::string_view nextLine(std::string_view& text)
{
    std::string_view line = cutOff(text, '\n');
    if (line.ends_with('\r')) {
        line.remove_suffix(1);
    }
    return line;
}

std::vector<std::string_view> fieldsOf(std::string_view line)
{
    std::vector<std::string_view> fields;
    const auto count = std::ranges::count(line, ',') + 1;
    for (auto k = count; k > 0; --k) {
        fields.push_back(cutOff(line, ','));
    }
    return fields;
}

tl::unexpected<Error> atLine(std::size_t line, const std::string& what)
{
    return contentsError("line " + std::to_string(line) + ": " + what);
}

std::string found(std::string_view field)
{
    return ", found '" + std::string(field.substr(0, kLongestQuote)) +
           (field.size() > kLongestQuote ? "…'." : "'.");
}

/// Where each of kColumns stands.
using Places = std::array<std::size_t, kColumns.size()>;

Result<Places> placesIn(const std::vector<std::string_view>& names)
{
    Places places{};
    for (std::size_t c = 0; c < kColumns.size(); ++c) {
        const auto count = std::ranges::count(names, kColumns[c]);
        const std::string name = std::string("'").append(kColumns[c]).append("'");
        if (count == 0) {
            return atLine(1,
                          "expected a column " + name +
                              "; there must be face, u, v, uw1, vw1, "
                              "uw2 and vw2.");
        }
        if (count > 1) {
            return atLine(1,
                          "the column " + name + " is there " + std::to_string(count) + " times.");
        }
        places[c] = static_cast<std::size_t>(std::ranges::find(names, kColumns[c]) - names.begin());
    }
    return places;
}

template <class Number>
std::optional<Number> wholeFieldAs(std::string_view field)
{
    Number number{};
    const char* end = field.data() + field.size();
    const auto [stop, error] = std::from_chars(field.data(), end, number);
    return error == std::errc() && stop == end ? std::optional(number) : std::nullopt;
}

/// By way of double, so that numbers too small for a float become 0 or denormal.
std::optional<float> floatOf(std::string_view field)
{
    const auto number = wholeFieldAs<double>(field);
    const bool fits = number && (!std::isfinite(*number) ||
                                 std::abs(*number) <= double{std::numeric_limits<float>::max()});
    return fits ? std::optional(static_cast<float>(*number)) : std::nullopt;
}

/// Adds a line's query.
Status readLine(const std::vector<std::string_view>& fields,
                const Places& places,
                std::size_t line,
                std::size_t faceCount,
                QueryArrays& queries)
{
    const std::string_view faceField = fields[places[0]];
    const auto face = wholeFieldAs<std::uint64_t>(faceField);
    if (!face || *face >= faceCount) {
        return atLine(line,
                      "column face: expected a face below " + std::to_string(faceCount) +
                          found(faceField));
    }
    std::array<float, kColumns.size()> numbers{};
    for (std::size_t c = 1; c < kColumns.size(); ++c) {
        const auto number = floatOf(fields[places[c]]);
        if (!number) {
            return atLine(line,
                          "column " + std::string(kColumns[c]) +
                              ": expected a number that a float can hold" +
                              found(fields[places[c]]));
        }
        numbers[c] = *number;
    }
    queries.add(faceId(*face),
                {numbers[1], numbers[2]},
                {numbers[3], numbers[4]},
                {numbers[5], numbers[6]});
    return {};
}

void append(std::string& text, float number)
{
    std::array<char, 32> digits{};
    const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), number);
    text.append(digits.data(), end);
}

std::vector<std::string> addedNames(int channels)
{
    std::vector<std::string> names;
    for (int c = 0; c < channels; ++c) {
        names.push_back(std::string("c").append(std::to_string(c)));
    }
    names.emplace_back("method");
    names.emplace_back("level");
    return names;
}

} // namespace

Result<QueryCsv> parseQueryCsv(std::string_view text, std::size_t faceCount)
{
    constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
    if (text.starts_with(kByteOrderMark)) {
        text.remove_prefix(kByteOrderMark.size());
    }
    QueryCsv csv;
    csv.header = nextLine(text);
    const auto names = fieldsOf(csv.header);
    const auto places = placesIn(names);
    if (!places) {
        return tl::unexpected(places.error());
    }
    for (std::size_t number = 2; !text.empty(); ++number) {
        const std::string_view line = nextLine(text);
        const auto fields = fieldsOf(line);
        if (fields.size() != names.size()) {
            return atLine(number,
                          "expected " + std::to_string(names.size()) +
                              " columns as in the header, found " + std::to_string(fields.size()) +
                              ".");
        }
        const Status read = readLine(fields, *places, number, faceCount, csv.queries);
        if (!read) {
            return tl::unexpected(read.error());
        }
        csv.lines.push_back(line);
    }
    return csv;
}

Result<std::string> withSamples(const QueryCsv& csv, const SampleColumns& columns)
{
    const auto names = fieldsOf(csv.header);
    std::string text(csv.header);
    for (const std::string& name : addedNames(columns.channels)) {
        if (std::ranges::find(names, std::string_view(name)) != names.end()) {
            return atLine(1,
                          "the column '" + name +
                              "' would be there twice: it is one of those "
                              "that are added.");
        }
        text += ',';
        text += name;
    }
    text += '\n';
    for (std::size_t i = 0; i < csv.lines.size(); ++i) {
        text += csv.lines[i];
        for (int c = 0; c < columns.channels; ++c) {
            text += ',';
            append(text, columns.values[static_cast<std::size_t>(c) * columns.stride + i]);
        }
        text += ',';
        text += columns.methods[i];
        text += ',';
        append(text, columns.levels[i]);
        text += '\n';
    }
    return text;
}

Status writeCsv(const std::filesystem::path& path, std::string_view text)
{
    return commitFile(
        path,
        [&](FileWriter& file) { return file.write(text); },
        [&](const std::filesystem::path& written) -> Status {
            const auto back = readFile(written);
            if (!back) {
                return tl::unexpected(back.error());
            }
            return *back == text ? Status()
                                 : pathError("What was written does not read back the same.");
        });
}

} // namespace trixel
