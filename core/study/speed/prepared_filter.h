// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/filter/filter_scene.h"
#include "core/study/speed/contest.h"

namespace trixel {

/// Queries that a method, or what chooses among methods, answers with nothing prepared.
/// \tparam Filter  has filter(scene, queries, results); it and the scene outlive this
template <class Filter>
class PreparedFilter final : public PreparedQueries
{
public:
    PreparedFilter(const Filter& filter, const FilterScene& scene, FilterQueries queries)
        : m_filter(filter)
        , m_scene(scene)
        , m_queries(queries)
    {
    }

    void run(const FilterResults& results) const override
    {
        m_filter.filter(m_scene, m_queries, results);
    }

private:
    const Filter& m_filter;
    const FilterScene& m_scene;
    FilterQueries m_queries;
};

} // namespace trixel
