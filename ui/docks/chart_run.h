// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/docks/chart_study.h"
#include "ui/docks/inbox.h"
#include "ui/docks/measured_run.h"

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <tuple>

namespace trixel::ui {

/// A study under way in the background, and what it has measured so far.
class ChartRun : public MeasuredRun
{
    Q_OBJECT

public:
    explicit ChartRun(BackgroundJobs& jobs, QObject* parent = nullptr);

    /// Does nothing while a study runs.
    void start(const StudyOffer& offer, StudyInput input);
    const Study& study() const { return m_study; }

private:
    using Key = std::tuple<std::string, std::string, std::optional<FootprintClass>>;
    bool take() override;
    /// Marks the front of what was measured before the end, as it is exported.
    void settle() override;
    void add(const StudyPoint& point);

    std::shared_ptr<Inbox<StudyPoint>> m_inbox;
    Study m_study;
    std::map<Key, std::size_t> m_places; ///< of the points, by who they are
};

} // namespace trixel::ui
