// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "ui/charts/study_plot.h"
#include "ui/docks/chart_run.h"
#include "ui/docks/chart_study.h"

#include <vector>

class QBoxLayout;
class QComboBox;
class QGridLayout;
class QLabel;
class QProgressBar;
class QPushButton;
class QToolButton;

namespace trixel::ui {

class BackgroundJobs;
class ChartView;
class Document;
class ScaledSpinBox;
class ViewSettings;

/// Speed and accuracy: runs studies in the background and charts what they measure. A click on a
/// point makes its method the one that pictures, maps and read-outs are made with.
class ChartPanel : public QWidget
{
    Q_OBJECT

public:
    ChartPanel(const Document& document,
               ViewSettings& settings,
               BackgroundJobs& jobs,
               std::vector<StudyOffer> offers,
               QWidget* parent = nullptr);

    const ChartRun& run() const { return m_run; }
    ChartView& view() { return *m_view; }

signals:
    /// One sentence about what could not be done.
    void failed(const QString& sentence);
    /// One sentence about what was written.
    void written(const QString& sentence);

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void makeControls();
    void makeStudies(QGridLayout& grid);
    void makeFilters(QGridLayout& grid);
    void makeExports();
    void connectRun();
    void listSubjects();
    void listClasses();
    void startOrCancel();
    void showRun();
    void showStudy();
    void showChosen();
    void showAdvice();
    void choose(std::size_t point);
    void chooseAdvised();
    void write(const QString& path);
    const StudyOffer* offer() const;
    StudyView studyView() const;

    const Document& m_document;
    ViewSettings& m_settings;
    BackgroundJobs& m_jobs;
    std::vector<StudyOffer> m_offers;
    ChartRun m_run;

    QBoxLayout* m_layout;
    QWidget* m_controls;
    ChartView* m_view;
    QComboBox* m_study;
    QComboBox* m_subject;
    QComboBox* m_class;
    QComboBox* m_measure;
    ScaledSpinBox* m_tolerance;
    QPushButton* m_start;
    QPushButton* m_use;
    QToolButton* m_export;
    QProgressBar* m_progress;
    QLabel* m_advice;
};

} // namespace trixel::ui
