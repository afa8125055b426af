// SPDX-License-Identifier: GPL-3.0-or-later
//
// Footprints as a table of text: what the command line reads and the stored distribution is in.
#pragma once

#include "core/base/result.h"
#include "core/filter/filter_queries.h"

#include <cstdint>
#include <string_view>
#include <vector>

namespace trixel {

struct QueryTable
{
    QueryArrays queries;
    /// Further columns: column c of query i at c * queries.size() + i.
    std::vector<float> values;
};

/// A header line that begins with "face,u,v,uw1,vw1,uw2,vw2" and names `furtherColumns` more, then
/// one line a query. Numbers are read strictly; "inf" and "nan" are numbers. Errors name the line.
/// \param faceCount  faces there are; others are refused
Result<QueryTable>
parseQueryTable(std::string_view text, std::uint32_t faceCount, int furtherColumns = 0);

} // namespace trixel
