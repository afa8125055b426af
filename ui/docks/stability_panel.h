// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "core/base/ids.h"
#include "ui/docks/stability_run.h"

#include <vector>

class QBoxLayout;
class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QToolButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace trixel::ui {

class ChartView;
class Document;
struct ExportFormat;

/// Where the textbook's formulas fail and ours hold: a row a hazard with its verdict, and the
/// chosen row's errors as a chart, the textbook's beside ours, with the bound.
class StabilityPanel : public QWidget
{
    Q_OBJECT

public:
    StabilityPanel(const Document& document,
                   BackgroundJobs& jobs,
                   StabilityWork work,
                   QWidget* parent = nullptr);

    const StabilityRun& run() const { return m_run; }
    ChartView& view() { return *m_view; }

signals:
    /// The user wants to see a face.
    void faceChosen(trixel::FaceId face);
    /// One sentence about what could not be done, or what was written.
    void failed(const QString& sentence);
    void written(const QString& sentence);

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void makeControls();
    void makeList();
    void makeExports();
    void connectRun();
    void startOrCancel();
    void listSubjects();
    void showRun();
    void listSweeps();
    void addFindings();
    void showSweep();
    void activate(const QTreeWidgetItem* item);
    const StabilitySweep* sweep() const;
    void write(const QString& path, const ExportFormat& format);

    const Document& m_document;
    BackgroundJobs& m_jobs;
    StabilityRun m_run;
    QString m_shown; ///< name of the sweep that the chart shows

    QBoxLayout* m_layout;
    QWidget* m_controls;
    ChartView* m_view;
    QLabel* m_about;
    QTreeWidget* m_list;
    QComboBox* m_subject;
    QPushButton* m_start;
    QToolButton* m_export;
    QProgressBar* m_progress;
};

} // namespace trixel::ui
