// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointer>
#include <QTimer>

#include "core/study/seam_meter.h"
#include "core/texture/face_order.h"
#include "ui/document/background_job.h"

#include <memory>
#include <vector>

namespace trixel::ui {

struct Change;
class Document;
class FaceSelection;
class ViewSettings;

/// What is listed of the document's faces: their figures, and which of them in what order. All of
/// it is worked out in the background, one thing after the other; what was there before stays until
/// then. Nothing is done while nobody looks.
class FaceListing : public QObject
{
    Q_OBJECT

public:
    /// \param jobs  of the window, which shows and cancels the measuring
    FaceListing(const Document& document,
                const FaceSelection& selection,
                const ViewSettings& settings,
                BackgroundJobs& jobs,
                QObject* parent = nullptr);

    /// Whether someone looks. What was missed meanwhile is made up for.
    void setWatched(bool watched);

    const FaceOrder& order() const { return m_order; }
    void sortBy(FaceColumn column, bool descending);
    void setFilter(const FaceFilter& filter);
    /// A filter that asks for the selection takes the present one.
    void takeSelection();

    /// The jumps that a face is told of; null for none.
    void setSeams(std::shared_ptr<const SeamReport> report);

    /// Null until they are measured.
    const std::shared_ptr<const FaceFigures>& figures() const { return m_figures; }
    /// Never null; of faces that have figures.
    const std::shared_ptr<const FaceRows>& rows() const { return m_rows; }
    /// Null where none were measured.
    const std::shared_ptr<const std::vector<float>>& jumps() const { return m_jumps; }
    /// There are figures (checked). Selected are those that the filter goes by.
    FaceFacts facts() const;

    /// Whether anything shown is about to change.
    bool isBusy() const { return m_job != nullptr || (m_isWatched && isStale()); }
    /// The measuring was cancelled, and is not tried again until someone looks anew.
    bool isStopped() const { return m_isStopped; }

signals:
    /// Around another set of rows, or another order of the same.
    void aboutToRearrange(bool sameFaces);
    void rearranged(bool sameFaces);
    /// Figures changed, rows did not.
    void figuresChanged();
    void busyChanged();

private:
    using Figures = std::shared_ptr<const FaceFigures>;
    using Rows = std::shared_ptr<const FaceRows>;

    bool isStale() const;
    void forget();
    void takeChange(const Change& change);
    void takeLook();
    void goOn();
    void measureAll();
    void measureTouched();
    void gatherJumps();
    void arrange();
    void takeFigures(Figures figures);
    void takeRows(Rows rows);
    void ended();

    const Document& m_document;
    const FaceSelection& m_selection;
    const ViewSettings& m_settings;
    BackgroundJobs& m_jobs;
    BackgroundJobs m_quickJobs; ///< too short to be worth showing

    Figures m_figures;
    Rows m_rows = std::make_shared<const FaceRows>();
    FaceOrder m_order;
    std::shared_ptr<const SeamReport> m_seams;
    std::shared_ptr<const std::vector<float>> m_jumps;
    std::shared_ptr<const std::vector<FaceId>> m_selected; ///< that the filter goes by

    bool m_isWatched = false;
    bool m_isStopped = false;
    bool m_allStale = true;
    bool m_jumpsStale = false;
    bool m_orderStale = true;
    std::vector<FaceId> m_touched; ///< since they were measured; some more than once
    QPointer<BackgroundJob> m_job; ///< the one thing being done
    quint64 m_generation = 0;      ///< of documents
    QTimer m_soon;                 ///< goes on when nothing was painted for a moment
};

} // namespace trixel::ui
