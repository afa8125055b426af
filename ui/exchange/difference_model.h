// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>

#include "ui/document/background_job.h"
#include "ui/exchange/other_file.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace trixel::ui {

/// The faces in which two files differ, as rows, the worst first. Orders are worked out in the
/// background; a view is given the first rows, and more when it comes to their end.
class DifferenceModel : public QAbstractTableModel
{
    Q_OBJECT

public:
    enum Column { Face, Rms, Largest, Texels, Levels, ColumnCount };

    /// Rows that a view is given at a time.
    static constexpr int kRowsAtOnce = 50'000;

    explicit DifferenceModel(QObject* parent = nullptr);

    /// Null for no rows.
    void setComparison(std::shared_ptr<const FileComparison> comparison);
    /// The face of a row (checked).
    const FaceDifference& differenceAt(int row) const;
    bool isSorting() const { return !m_jobs.isIdle(); }

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    bool canFetchMore(const QModelIndex& parent) const override;
    void fetchMore(const QModelIndex& parent) override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    /// The order comes a moment later; marks of rows go.
    void sort(int column, Qt::SortOrder order) override;

private:
    using Order = std::vector<std::uint32_t>;
    std::size_t faceCount() const;
    void takeOrder(Order order);

    std::shared_ptr<const FileComparison> m_comparison;
    Order m_order;  ///< faces of the comparison as shown; empty while nothing is
    int m_rows = 0; ///< that views were given
    int m_column = Rms;
    Qt::SortOrder m_direction = Qt::DescendingOrder;
    quint64 m_generation = 0;
    BackgroundJobs m_jobs;
};

} // namespace trixel::ui
