// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/query_table.h"

#include <array>
#include <charconv>
#include <string>

namespace trixel {
namespace {

constexpr std::string_view kHeader = "face,u,v,uw1,vw1,uw2,vw2";
constexpr int kOwnColumns = 6; // beside the face

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

template <class Number>
bool readNumber(std::string_view field, Number& number)
{
    const char* end = field.data() + field.size();
    const auto [stop, error] = std::from_chars(field.data(), end, number);
    return error == std::errc() && stop == end;
}

tl::unexpected<Error> atLine(std::size_t line, const std::string& what)
{
    return contentsError("line " + std::to_string(line) + ": " + what);
}

} // namespace

Result<QueryTable>
parseQueryTable(std::string_view text, std::uint32_t faceCount, int furtherColumns)
{
    const auto further = static_cast<std::size_t>(furtherColumns);
    if (!nextLine(text).starts_with(kHeader)) {
        return atLine(1, "expected the header " + std::string(kHeader) + ".");
    }
    QueryTable table;
    std::vector<float> byRow;
    std::vector<float> fields(kOwnColumns + further);
    for (std::size_t number = 2; !text.empty(); ++number) {
        std::string_view line = nextLine(text);
        std::uint32_t face = 0;
        const std::string_view faceField = cutOff(line, ',');
        if (!readNumber(faceField, face) || face >= faceCount) {
            return atLine(number,
                          "expected a face below " + std::to_string(faceCount) + ", found '" +
                              std::string(faceField.substr(0, 40)) + "'.");
        }
        for (float& value : fields) {
            const std::string_view field = cutOff(line, ',');
            if (!readNumber(field, value)) {
                return atLine(
                    number, "expected a number, found '" + std::string(field.substr(0, 40)) + "'.");
            }
        }
        if (!line.empty()) {
            return atLine(
                number, "expected " + std::to_string(1 + fields.size()) + " columns, found more.");
        }
        table.queries.add(
            faceId(face), {fields[0], fields[1]}, {fields[2], fields[3]}, {fields[4], fields[5]});
        byRow.insert(byRow.end(), fields.begin() + kOwnColumns, fields.end());
    }
    const std::size_t count = table.queries.size();
    table.values.resize(byRow.size());
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t c = 0; c < further; ++c) {
            table.values[c * count + i] = byRow[i * further + c];
        }
    }
    return table;
}

} // namespace trixel
