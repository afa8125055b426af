// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/views/picture_error.h"

#include "core/filter/filter_method.h"

#include <algorithm>
#include <cmath>

namespace trixel {

Result<PictureError> pictureError(const FilterScene& before,
                                  const FilterScene& after,
                                  const FilterQueries& queries,
                                  Threads threads,
                                  Progress& progress)
{
    check(before.channels() == after.channels() && before.faceCount() == after.faceCount(),
          "two states of one texture");
    constexpr std::size_t kBetweenReports = 16384;
    const auto exact = makeMethod({"exact", std::nullopt});
    PictureError error;
    error.pixels = queries.size();
    double squares = 0;
    for (std::size_t begin = 0; begin < queries.size(); begin += kBetweenReports) {
        if (!progress.report(static_cast<double>(begin) / static_cast<double>(queries.size()))) {
            return cancelled();
        }
        const std::size_t count = std::min(kBetweenReports, queries.size() - begin);
        const FilterQueries part = queries.subspan(begin, count);
        ResultArrays was(count, before.channels());
        ResultArrays is(count, before.channels());
        filterParallel(*exact, before, part, was.results(), threads);
        filterParallel(*exact, after, part, is.results(), threads);
        for (std::size_t k = 0; k < was.values.size(); ++k) {
            const double difference =
                std::abs(static_cast<double>(was.values[k]) - static_cast<double>(is.values[k]));
            squares += difference * difference;
            error.worst = std::max(error.worst, difference);
        }
    }
    const auto values = static_cast<double>(queries.size()) * before.channels();
    error.rms = values > 0 ? std::sqrt(squares / values) : 0;
    return error;
}

} // namespace trixel
