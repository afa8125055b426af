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
/// worked out in the background: a view is given the first rows, and more when it comes to their
/// end.
class SeamModel : public QAbstractTableModel
{
    Q_OBJECT

public:
    enum Column { Jump, Mean, Face, Edge, Neighbour, Levels, ColumnCount };

    /// Rows that a view is given at a time.
    static constexpr int kRowsAtOnce = 50'000;

    explicit SeamModel(QObject* parent = nullptr);

    /// Null for no rows. The largest jump comes first until another order is asked for.
    void setReport(std::shared_ptr<const SeamReport> report);
    /// The edge of a row (checked).
    const SeamJump& jumpAt(int row) const;
    bool isSorting() const { return !m_jobs.isIdle(); }

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    bool canFetchMore(const QModelIndex& parent) const override;
    void fetchMore(const QModelIndex& parent) override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    /// The order comes a moment later. A marked row that then comes after those given loses its
    /// mark.
    void sort(int column, Qt::SortOrder order) override;

private:
    using Order = std::vector<std::uint32_t>;
    void takeOrder(Order order);
    int edgeCount() const;

    std::shared_ptr<const SeamReport> m_report;
    Order m_order;  ///< rows of the report as shown; empty for its own order
    int m_rows = 0; ///< that views were given
    quint64 m_generation = 0;
    BackgroundJobs m_jobs;
};

} // namespace trixel::ui
