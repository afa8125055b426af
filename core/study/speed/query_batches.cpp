// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/speed/query_batches.h"

#include <algorithm>
#include <array>

namespace trixel {
namespace {

void append(QueryBatch& batch, const QueryArrays& from, std::size_t i)
{
    batch.indices.push_back(i);
    batch.queries.add(from.face[i],
                      {from.u[i], from.v[i]},
                      {from.uw1[i], from.vw1[i]},
                      {from.uw2[i], from.vw2[i]});
}

} // namespace

std::vector<QueryBatch> makeBatches(const std::vector<StudySubject>& subjects,
                                    const std::vector<std::vector<bool>>& kept)
{
    std::vector<QueryBatch> batches;
    for (std::size_t s = 0; s < subjects.size(); ++s) {
        const StudySubject& subject = subjects[s];
        std::array<QueryBatch, kFootprintClasses> classes;
        QueryBatch mixture;
        mixture.subject = s;
        std::vector<std::uint8_t> numbers(subject.queries.size());
        classify(*subject.scene, subject.queries.queries(), numbers);
        for (std::size_t i = 0; i < subject.queries.size(); ++i) {
            if (!kept.empty() && !kept[s][i]) {
                continue;
            }
            append(classes[numbers[i]], subject.queries, i);
            append(mixture, subject.queries, i);
        }
        for (const FootprintClass footprintClass : footprintClasses()) {
            QueryBatch& batch = classes[static_cast<std::size_t>(footprintClass)];
            if (!batch.indices.empty()) {
                batch.subject = s;
                batch.footprintClass = footprintClass;
                batches.push_back(std::move(batch));
            }
        }
        batches.push_back(std::move(mixture));
    }
    return batches;
}

std::vector<QueryBatch> thinned(const std::vector<StudySubject>& subjects,
                                const std::vector<QueryBatch>& batches,
                                std::size_t step)
{
    std::vector<std::vector<bool>> kept;
    for (const StudySubject& subject : subjects) {
        kept.emplace_back(subject.queries.size());
    }
    for (const QueryBatch& batch : batches) {
        const std::size_t first = std::min(step, batch.indices.size() + 1) / 2;
        for (std::size_t k = first; batch.footprintClass && k < batch.indices.size(); k += step) {
            kept[batch.subject][batch.indices[k]] = true;
        }
    }
    return makeBatches(subjects, kept);
}

QueryBatch sparseBatch(const StudySubject& subject, std::size_t number, std::size_t count)
{
    QueryBatch batch;
    batch.subject = number;
    const std::size_t step = std::max<std::size_t>(1, subject.queries.size() / count);
    for (std::size_t i = step / 2; i < subject.queries.size(); i += step) {
        append(batch, subject.queries, i);
    }
    return batch;
}

} // namespace trixel
