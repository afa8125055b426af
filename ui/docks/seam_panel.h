// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointer>
#include <QWidget>

#include "core/study/seam_meter.h"
#include "ui/document/background_job.h"
#include "ui/viewport/viewport.h"

#include <deque>
#include <memory>
#include <vector>

class QComboBox;
class QLabel;
class QPushButton;
class QTableView;
class QTreeWidget;

namespace trixel::ui {

class Document;
class FilterSceneSource;
class SeamModel;
class ViewSettings;

/// The seam meter: how far the chosen filter jumps across each edge of the mesh, the worst first,
/// and how the methods compare.
class SeamPanel : public QWidget
{
    Q_OBJECT

public:
    SeamPanel(const Document& document,
              ViewSettings& settings,
              FilterSceneSource& source,
              BackgroundJobs& jobs,
              const Viewport& viewport,
              QWidget* parent = nullptr);

    /// Measures the chosen method in the background.
    void measure();
    /// Measures every method of the table, one after the other.
    void compareAll();
    bool isMeasuring() const { return m_isWaiting || m_job != nullptr; }

    /// Null while nothing was measured.
    const std::shared_ptr<const SeamReport>& report() const { return m_report; }
    SeamModel& model() { return *m_model; }

signals:
    /// The user wants to see an edge.
    void edgeChosen(trixel::ui::SurfaceEdge edge);
    /// The edges of another report are listed; null for none.
    void reported(const std::shared_ptr<const trixel::SeamReport>& report);

private:
    /// What is to be measured, and whether its edges are to be listed.
    struct Task
    {
        MethodChoice method;
        bool lists = true;
    };

    QWidget* makeChoices();
    QTableView* makeTable();
    void makeComparison();
    void forget();
    void begin(std::deque<Task> tasks);
    void next();
    void take(const Task& task, const Result<SeamReport>& report);
    void addToComparison(const MethodChoice& method, const SeamSummary& summary);
    void showState();
    void choose(int row);
    SeamSettings footprints() const;

    const Document& m_document;
    ViewSettings& m_settings;
    FilterSceneSource& m_source;
    BackgroundJobs& m_jobs;
    const Viewport& m_viewport;

    QComboBox* m_footprints = nullptr;
    QPushButton* m_measure = nullptr;
    QPushButton* m_compare = nullptr;
    QLabel* m_summary;
    QTableView* m_table = nullptr;
    QTreeWidget* m_comparison;
    SeamModel* m_model;

    std::deque<Task> m_tasks;
    bool m_isWaiting = false; ///< for the scene
    QPointer<BackgroundJob> m_job;
    quint64 m_generation = 0;
    std::shared_ptr<const SeamReport> m_report;
    MethodChoice m_reported;   ///< the method of the report
    bool m_isOutdated = false; ///< texels changed since
};

} // namespace trixel::ui
