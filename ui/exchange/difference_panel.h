// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointer>
#include <QWidget>

#include "ui/document/background_job.h"
#include "ui/document/document.h"
#include "ui/exchange/other_file.h"

#include <memory>
#include <vector>

class QLabel;
class QPushButton;
class QTableView;

namespace trixel::ui {

class DifferenceModel;

/// How the open project differs from a file: figures, and every face that differs, the worst first.
class DifferencePanel : public QWidget
{
    Q_OBJECT

public:
    DifferencePanel(Document& document, BackgroundJobs& jobs, QWidget* parent = nullptr);

    /// Compares with a file in the background; another comparison under way is given up.
    /// \param matches  whether its faces are matched to the mesh's first
    void compare(const QString& path, bool matches);

    /// Null while there is none.
    const std::shared_ptr<const FileComparison>& comparison() const { return m_comparison; }
    /// The file compared with last, also if that failed; empty when there is none.
    const QString& path() const { return m_path; }
    DifferenceModel& model() { return *m_model; }

signals:
    /// Another comparison is there; null for none.
    void compared(const std::shared_ptr<const trixel::ui::FileComparison>& comparison);
    /// One sentence about a comparison that could not be made.
    void failed(const QString& sentence);
    void chooseWanted();
    /// The user wants to see a face.
    void faceChosen(trixel::FaceId face);
    void facesChosen(std::vector<trixel::FaceId> faces);

private:
    void makeTable();
    void forget();
    void compareNow(const QString& path, bool matches);
    void take(const Result<std::shared_ptr<const FileComparison>>& comparison);
    void show(std::shared_ptr<const FileComparison> comparison);
    void showState();
    QString figures() const;
    void chooseAll();

    Document& m_document;
    BackgroundJobs& m_jobs;
    QLabel* m_summary;
    QTableView* m_table;
    QPushButton* m_other;
    QPushButton* m_again;
    QPushButton* m_select;
    DifferenceModel* m_model;

    QPointer<BackgroundJob> m_job;
    quint64 m_generation = 0;
    QString m_path;
    bool m_matches = false;
    std::uint64_t m_madeFor = 0; ///< the texels that were compared, or are
    std::shared_ptr<const FileComparison> m_comparison;
};

} // namespace trixel::ui
