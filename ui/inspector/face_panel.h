// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTimer>
#include <QWidget>

#include "core/base/ids.h"
#include "core/study/seam_meter.h"

#include <memory>

class QLabel;
class QLineEdit;
class QToolButton;

namespace trixel::ui {

class BackgroundJobs;
class Document;
class FaceListing;
class FaceSelection;
class FaceTableModel;
class FaceTableView;
class Inspection;
class ViewSettings;

/// All faces as a table: level, texels, bytes, density, values, seams; to sort, filter, select and
/// go to.
class FacePanel : public QWidget
{
    Q_OBJECT

public:
    FacePanel(const Document& document,
              FaceSelection& selection,
              Inspection& inspection,
              const ViewSettings& settings,
              BackgroundJobs& jobs,
              QWidget* parent = nullptr);

    FaceListing& listing() { return *m_listing; }
    FaceTableModel& model() { return *m_model; }
    FaceTableView& table() { return *m_table; }

    /// The seams that the last column tells of; null for none.
    void setSeams(std::shared_ptr<const SeamReport> report);
    /// Puts the selected rows on the clipboard, a line each, a moment later.
    void copySelected();
    /// Writes the listed rows as comma-separated values, in the background.
    void save(const QString& path);

signals:
    /// The user wants to see a face.
    void faceChosen(trixel::FaceId face);
    /// One sentence about a file written, or about what failed.
    void written(const QString& sentence);
    void failed(const QString& sentence);

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    QWidget* makeFilter();
    void makeTable();
    void addTerm(const QString& term);
    void applyFilter();
    void askWhereToSave();
    void showState();
    QString summary() const;

    const Document& m_document;
    FaceSelection& m_selection;
    BackgroundJobs& m_jobs;
    FaceListing* m_listing;
    FaceTableModel* m_model;
    FaceTableView* m_table;
    QLineEdit* m_filter;
    QToolButton* m_save = nullptr;
    QLabel* m_summary;
    QLabel* m_empty;
    QString m_fault; ///< of the filter as typed; empty when it is understood
    QString m_notice;
    QTimer m_typing;
};

} // namespace trixel::ui
