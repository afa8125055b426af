// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

#include "core/io/export_project.h"
#include "ui/document/background_job.h"

#include <array>
#include <optional>

class QCheckBox;
class QComboBox;
class QLabel;
class QPushButton;
class QStackedWidget;

namespace trixel::ui {

class ExportPage;
class PathRow;

/// What the dialog is about: a snapshot, for the estimate, and what is selected in it.
struct ExportSource
{
    Project project;
    std::vector<FaceId> selection;
    /// The latest export of this session, to begin with.
    std::optional<ExportRequest> latest;
};

/// Asks what a project is to be written as, and says beforehand what that will weigh. The ending of
/// the destination and the kind of export follow each other.
class ExportDialog : public QDialog
{
    Q_OBJECT

public:
    /// \param path  proposed destination
    ExportDialog(ExportSource source, const QString& path, QWidget* parent = nullptr);

signals:
    void exportWanted(const trixel::ExportRequest& request);

private:
    void addPages();
    void addPart();
    void addLayers();
    /// Those of the chosen layer, or of all together.
    void listChannels();
    std::optional<LayerId> layer() const;
    void connectAll();
    void begin(const QString& path);
    ExportPage& page() const;
    ExportPage& pageAt(int index) const;
    /// The kind of a file's ending: on the page that is open, if it has one; -1 for an unknown one.
    int kindOf(const QString& ending) const;
    int kindOn(int page, const QString& ending) const;
    /// What the controls say now.
    ExportRequest request() const;
    QString pathWithEnding() const;

    void applyPreset(int preset);
    void followPath();
    void chooseKind(int kind);
    void changeEnding(const QString& ending);
    void becomeCustom();
    void takeChange();
    void alignLabels();
    void estimate();
    void checkPath();
    void finish();

    ExportSource m_source;
    PathRow* m_path;
    QComboBox* m_preset;
    QComboBox* m_kind;
    QStackedWidget* m_pages;
    QCheckBox* m_selected;
    QComboBox* m_layer; ///< none offered where there are none
    QComboBox* m_channel;
    QLabel* m_size;
    QLabel* m_note;
    QPushButton* m_export;
    bool m_isFilling = false; ///< controls are being set, not used
    bool m_isWritable = true; ///< as the estimate found
    quint64 m_generation = 0;
    BackgroundJobs m_jobs; // last: waits for work before the rest dies
};

} // namespace trixel::ui
