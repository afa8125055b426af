// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/footprint_class.h"
#include "core/study/speed/contest.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace trixel {

/// Queries of one subject that are timed together.
struct QueryBatch
{
    std::size_t subject = 0;
    std::optional<FootprintClass> footprintClass; ///< nothing: a mixture in the subject's order
    QueryArrays queries;
    std::vector<std::size_t> indices; ///< of each among the subject's queries
};

/// For each subject one batch a class that occurs, then the mixture of all.
/// \param kept  by subject, whether each query is wanted; empty: all are
std::vector<QueryBatch> makeBatches(const std::vector<StudySubject>& subjects,
                                    const std::vector<std::vector<bool>>& kept = {});

/// The same of one query in `step` of each class.
std::vector<QueryBatch> thinned(const std::vector<StudySubject>& subjects,
                                const std::vector<QueryBatch>& batches,
                                std::size_t step);

/// About `count` queries of a subject, evenly spread over its order.
QueryBatch sparseBatch(const StudySubject& subject, std::size_t number, std::size_t count);

} // namespace trixel
