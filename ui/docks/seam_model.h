// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>

#include "core/study/seam_meter.h"
#include "ui/document/background_job.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace trixel::ui {

/// The edges of a seam report as rows. A million of them cost nothing but their order, which is
/// worked out in the background.
class SeamModel : public QAbstractTableModel
{
    Q_OBJECT

public:
    enum Column { Jump, Mean, Face, Edge, Neighbour, Levels, ColumnCount };

    explicit SeamModel(QObject* parent = nullptr);

    /// Null for no rows. The largest jump comes first until another order is asked for.
    void setReport(std::shared_ptr<const SeamReport> report);
    /// The edge of a row (checked).
    const SeamJump& jumpAt(int row) const;
    bool isSorting() const { return !m_jobs.isIdle(); }

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    /// The order comes a moment later.
    void sort(int column, Qt::SortOrder order) override;

private:
    using Order = std::vector<std::uint32_t>;
    void takeOrder(Order order);

    std::shared_ptr<const SeamReport> m_report;
    Order m_order; ///< rows of the report as shown; empty for its own order
    quint64 m_generation = 0;
    BackgroundJobs m_jobs;
};

} // namespace trixel::ui
