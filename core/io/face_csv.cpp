// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/face_csv.h"

#include "core/io/commit_file.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fstream>

namespace trixel {

namespace {

/// Rows between two looks at the progress, and the most that are text at a time.
constexpr std::size_t kRowsAtOnce = 1U << 14U;

template <class Number>
void appendNumber(std::string& text, Number number)
{
    std::array<char, 32> digits;
    const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), number);
    text.append(digits.data(), end);
}

bool isFloat(FaceColumn column)
{
    return column >= FaceColumn::Density;
}

std::string someRows(const FaceFacts& facts, std::span<const FaceId> faces, std::size_t begin)
{
    std::string text = begin == 0 ? faceTableHeader(',') : std::string();
    const std::size_t end = std::min(faces.size(), begin + kRowsAtOnce);
    for (std::size_t row = begin; row < end; ++row) {
        appendFaceRow(text, facts, faces[row], ',');
    }
    return text;
}

/// Calls take(text) for the whole file, part by part, until it says no.
template <class Take>
Status eachPart(const FaceFacts& facts, std::span<const FaceId> faces, const Take& take)
{
    for (std::size_t begin = 0; begin == 0 || begin < faces.size(); begin += kRowsAtOnce) {
        if (Status taken = take(someRows(facts, faces, begin), begin); !taken) {
            return taken;
        }
    }
    return {};
}

} // namespace

std::string faceTableHeader(char separator)
{
    std::string line;
    for (const FaceColumn column : kFaceColumns) {
        line += line.empty() ? "" : std::string(1, separator);
        line += nameOf(column);
    }
    return line + '\n';
}

void appendFaceRow(std::string& text, const FaceFacts& facts, FaceId face, char separator)
{
    for (const FaceColumn column : kFaceColumns) {
        if (column != kFaceColumns[0]) {
            text += separator;
        }
        const double value = valueIn(facts, column, face);
        if (std::isnan(value)) {
            continue;
        }
        if (isFloat(column)) {
            appendNumber(text, static_cast<float>(value));
        } else {
            appendNumber(text, static_cast<std::uint64_t>(value));
        }
    }
    text += '\n';
}

Status writeFaceCsv(const FaceFacts& facts,
                    std::span<const FaceId> faces,
                    const std::filesystem::path& path,
                    Progress& progress)
{
    const auto whole = static_cast<double>(std::max<std::size_t>(faces.size(), 1));
    StageProgress writing(progress, 0, 0.6);
    StageProgress reading(progress, 0.6, 1);
    return commitFile(
        path,
        [&](FileWriter& file) {
            return eachPart(facts, faces, [&](const std::string& text, std::size_t row) -> Status {
                if (!writing.report(static_cast<double>(row) / whole)) {
                    return cancelled();
                }
                return file.write(text);
            });
        },
        [&](const std::filesystem::path& written) -> Status {
            std::ifstream file(written, std::ios::binary);
            std::string found;
            const Status same =
                eachPart(facts, faces, [&](const std::string& text, std::size_t row) -> Status {
                    if (!reading.report(static_cast<double>(row) / whole)) {
                        return cancelled();
                    }
                    found.resize(text.size());
                    file.read(found.data(), static_cast<std::streamsize>(found.size()));
                    return file && found == text
                               ? Status()
                               : pathError("what was read back differs from what was written");
                });
            if (same && file.peek() != std::ifstream::traits_type::eof()) {
                return pathError("the file is longer than what was written");
            }
            return same;
        });
}

} // namespace trixel
