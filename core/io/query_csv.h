// SPDX-License-Identifier: GPL-3.0-or-later
//
// Footprints as people and other programs write them, and the answers beside them.
#pragma once

#include "core/base/result.h"
#include "core/filter/filter_queries.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace trixel {

/// Queries and the text they came from.
struct QueryCsv
{
    QueryArrays queries;
    /// Without line breaks; views of the text that was read.
    std::string_view header;
    std::vector<std::string_view> lines; ///< one a query
};

/// Reads a header line that names the columns face, u, v, uw1, vw1, uw2 and vw2 in any order, maybe
/// others among them, then one line a query. Numbers are read strictly: the whole field must be
/// one, and a finite one must fit a float; "inf", "-inf" and "nan" are numbers, faces apart. Errors
/// name the line and the column.
/// \param text       outlives the result
/// \param faceCount  faces there are; others are refused
Result<QueryCsv> parseQueryCsv(std::string_view text, std::size_t faceCount);

/// What was answered.
struct SampleColumns
{
    /// Channel c of query i at c * stride + i.
    std::span<const float> values;
    std::size_t stride = 0;
    int channels = 0;
    std::span<const float> levels;             ///< one a query
    std::span<const std::string_view> methods; ///< one a query
};

/// The table again with the columns c0, c1, … (one a channel), method and level behind its own.
/// Numbers have as many digits as it takes to read the same floats again. Fails when the table has
/// columns of such names.
Result<std::string> withSamples(const QueryCsv& csv, const SampleColumns& columns);

/// Writes text through `commitFile`, comparing what was written.
Status writeCsv(const std::filesystem::path& path, std::string_view text);

} // namespace trixel
