// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointer>
#include <QTimer>
#include <QWidget>

#include "ui/document/background_job.h"
#include "ui/document/document.h"
#include "ui/import/import_preview.h"
#include "ui/import/import_settings.h"

#include <memory>
#include <vector>

class QBoxLayout;
class QComboBox;
class QFormLayout;
class QLabel;
class QProgressBar;
class QPushButton;
class QStackedWidget;

namespace trixel::ui {

class FaceSelection;
class ImageRow;
class ImportLook;
class ImportOptions;
class PlacePage;
class PlanePage;
class QuadPlacement;
class SpherePage;
class Viewport;
class ViewSettings;
struct Imported;

/// Brings a 2D image onto the faces: which image, how it lies on the surface, how it is looked up.
/// The view shows what would come of it while the panel is seen; nothing is changed until it is
/// applied, as one undo step: as a layer of its own where the project has layers.
class ImportPanel : public QWidget
{
    Q_OBJECT

public:
    ImportPanel(Document& document,
                const FaceSelection& selection,
                BackgroundJobs& jobs,
                Viewport& viewport,
                ViewSettings& settings,
                QWidget* parent = nullptr);
    ~ImportPanel() override;

    /// Gives the keyboard to the image's file. \param path  of an image; empty keeps the one chosen
    void begin(const QString& path);
    ImportSettings settings() const;
    /// The latest preview; null while there is none of what is chosen.
    const std::shared_ptr<const PreviewPicture>& picture() const { return m_picture; }
    const ImportLook& look() const { return *m_look; }
    bool isApplying() const { return m_job != nullptr; }

signals:
    /// One sentence about what was done.
    void applied(const QString& sentence);
    /// One sentence about what could not be done.
    void failed(const QString& sentence);
    /// The panel has no more to do.
    void finished();

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    void makeMapping(QFormLayout& form);
    void makeButtons(QBoxLayout& column);
    void connectAll();
    void takeDocument();
    void takeImage();
    void takeKind();
    void changed();
    void refresh();
    ImportInput input() const;
    std::vector<FaceId> faces() const;
    QString missing() const;
    QString mappingProblem() const;
    void takePicture(const std::shared_ptr<const PreviewPicture>& picture);
    void applyOrCancel();
    void apply();
    void take(Result<Imported> imported, StateId madeFor, const QString& name);
    void showState();
    QString stateText() const;
    MapKind kind() const;

    Document& m_document;
    BackgroundJobs& m_jobs;
    Viewport& m_viewport;
    ImportPreview m_preview;
    std::shared_ptr<ImportSamplers> m_samplers = std::make_shared<ImportSamplers>();
    std::shared_ptr<const PreviewPicture> m_picture;
    QString m_previewProblem;
    QPointer<BackgroundJob> m_job;
    QTimer m_pause; ///< after texels changed

    QWidget* m_fields;
    ImageRow* m_image = nullptr;
    QComboBox* m_kind;
    QLabel* m_mappingProblem;
    QStackedWidget* m_pages;
    SpherePage* m_sphere;
    PlanePage* m_plane;
    QuadPlacement* m_placement;
    PlacePage* m_place;
    ImportOptions* m_options = nullptr;
    ImportLook* m_look;
    QLabel* m_state;
    QProgressBar* m_progress;
    QPushButton* m_apply;
    QPushButton* m_close;
};

} // namespace trixel::ui
