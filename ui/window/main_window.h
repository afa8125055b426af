// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMainWindow>

#include "ui/docks/brush_colors.h"
#include "ui/document/background_job.h"
#include "ui/document/document.h"
#include "ui/document/face_selection.h"
#include "ui/document/filter_scene_source.h"
#include "ui/document/inspection.h"
#include "ui/document/project_files.h"
#include "ui/viewport/view_settings.h"

class QLabel;
class QStackedWidget;

namespace trixel::ui {

class BrushActions;
class CardActions;
class EditActions;
class ExchangeActions;
class FileActions;
class ImportActions;
class InspectActions;
class InspectorPanels;
class LevelActions;
class LookActions;
class MapActions;
class MessageBar;
class PanelActions;
class PictureActions;
class SeamPanel;
class SelectionActions;
class ToolActions;
class ViewActions;
class ViewMap;
class Viewport;
class WorkPanels;
struct Workspace;

/// The window: puts document, view, panels and menus together. What they do lives in them.
class MainWindow : public QMainWindow
{
    Q_OBJECT

public:
    explicit MainWindow(QWidget* parent = nullptr);
    ~MainWindow() override;

    Document& document() { return m_document; }
    FaceSelection& selection() { return m_selection; }
    Inspection& inspection() { return m_inspection; }
    ViewSettings& settings() { return m_settings; }
    ProjectFiles& files() { return m_files; }
    BackgroundJobs& jobs() { return m_jobs; }
    Viewport& viewport() { return *m_viewport; }
    ViewMap& viewMap() { return *m_viewMap; }
    SeamPanel& seams();
    MessageBar& messages() { return *m_messages; }

    /// Opens a file as if chosen in the menu.
    void open(const QString& path);

protected:
    void closeEvent(QCloseEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    void makeCenter();
    Workspace workspace();
    void makePanels();
    void makeMenus();
    void makeToolBars();
    void makeStatusBar();
    void connectView();
    void takeDocument();
    void showTitle();
    void showCommands();
    void showAbout();
    void closeAfterExport();
    void restore();
    void remember() const;

    Document m_document;
    FaceSelection m_selection;
    Inspection m_inspection;
    ViewSettings m_settings;
    BrushColors m_colors;
    BackgroundJobs m_jobs;
    ProjectFiles m_files;
    FilterSceneSource m_filterScene;

    QStackedWidget* m_center = nullptr;
    Viewport* m_viewport = nullptr;
    MessageBar* m_messages = nullptr;
    WorkPanels* m_panels = nullptr;
    InspectorPanels* m_inspectors = nullptr;
    ViewMap* m_viewMap = nullptr; ///< a child of the viewport
    QLabel* m_hint = nullptr;
    FileActions* m_fileActions = nullptr;
    ImportActions* m_importActions = nullptr;
    EditActions* m_editActions = nullptr;
    ExchangeActions* m_exchange = nullptr;
    SelectionActions* m_selectionActions = nullptr;
    LevelActions* m_levelActions = nullptr;
    ToolActions* m_toolActions = nullptr;
    BrushActions* m_brushActions = nullptr;
    PictureActions* m_pictureActions = nullptr;
    ViewActions* m_viewActions = nullptr;
    CardActions* m_cardActions = nullptr;
    MapActions* m_mapActions = nullptr;
    InspectActions* m_inspectActions = nullptr;
    LookActions* m_lookActions = nullptr;
    PanelActions* m_panelActions = nullptr;
    bool m_mayClose = false;
};

} // namespace trixel::ui
