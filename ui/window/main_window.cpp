// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/main_window.h"

#include <QCloseEvent>
#include <QCoreApplication>
#include <QLabel>
#include <QMenuBar>
#include <QMessageBox>
#include <QMimeData>
#include <QPointer>
#include <QSettings>
#include <QStackedWidget>
#include <QStatusBar>
#include <QToolBar>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/docks/seam_panel.h"
#include "ui/exchange/exchange_actions.h"
#include "ui/layers/layer_actions.h"
#include "ui/viewport/view_map.h"
#include "ui/viewport/viewport.h"
#include "ui/window/actions.h"
#include "ui/window/bookmark_actions.h"
#include "ui/window/brush_actions.h"
#include "ui/window/card_actions.h"
#include "ui/window/command_palette.h"
#include "ui/window/compare_actions.h"
#include "ui/window/edit_actions.h"
#include "ui/window/file_actions.h"
#include "ui/window/filtering_actions.h"
#include "ui/window/import_actions.h"
#include "ui/window/inspect_actions.h"
#include "ui/window/inspector_panels.h"
#include "ui/window/job_bar.h"
#include "ui/window/level_actions.h"
#include "ui/window/look_actions.h"
#include "ui/window/map_actions.h"
#include "ui/window/message_bar.h"
#include "ui/window/panel_actions.h"
#include "ui/window/panel_frames.h"
#include "ui/window/picture_actions.h"
#include "ui/window/selection_actions.h"
#include "ui/window/status_line.h"
#include "ui/window/study_panels.h"
#include "ui/window/tool_actions.h"
#include "ui/window/view_actions.h"
#include "ui/window/welcome.h"
#include "ui/window/work_panels.h"
#include "ui/window/workspace.h"

namespace trixel::ui {

namespace {

constexpr QSize kFirstSize(1440, 900);
constexpr int kIconSize = 20;
/// Of the surface's size: a first brush that covers a few faces of most meshes.
constexpr float kFirstRadius = 0.02F;

/// Where the sample shows itself best, degrees.
constexpr double kSampleYaw = 48;
constexpr double kSamplePitch = 12;
constexpr double kSampleCloseness = 1.25;

} // namespace

MainWindow::MainWindow(QWidget* parent)
    : QMainWindow(parent)
    , m_selection(m_document)
    , m_inspection(m_document)
    , m_colors(m_settings)
    , m_files(m_document, m_jobs)
    , m_filterScene(m_document, m_jobs)
{
    setObjectName("mainWindow");
    setAcceptDrops(true);
    setDockOptions(AnimatedDocks | AllowTabbedDocks | AllowNestedDocks);
    setTabPosition(Qt::RightDockWidgetArea, QTabWidget::North);
    setTabPosition(Qt::BottomDockWidgetArea, QTabWidget::North);
    // The panels at the side keep their height when one opens below the view.
    setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    resize(kFirstSize);
    makeCenter();
    makePanels();
    makeMenus();
    makeToolBars();
    makeStatusBar();
    connectView();
    restore();
    connect(&m_document, &Document::opened, this, &MainWindow::takeDocument);
    connect(&m_document, &Document::titleChanged, this, &MainWindow::showTitle);
    connect(&m_document, &Document::modifiedChanged, this, &MainWindow::showTitle);
    showTitle();
}

MainWindow::~MainWindow()
{
    // Left to themselves the widgets would outlive the members that they refer to.
    QList<QPointer<QWidget>> shown;
    for (QWidget* widget : findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly)) {
        shown += widget;
    }
    for (const QPointer<QWidget>& widget : shown) {
        delete widget.data();
    }
}

SeamPanel& MainWindow::seams()
{
    return m_panels->seams();
}

void MainWindow::open(const QString& path)
{
    m_fileActions->open(path);
}

void MainWindow::makeCenter()
{
    m_messages = new MessageBar;
    m_viewport = new Viewport(m_document, m_settings);
    m_viewport->setAccessibleName(tr("3D view"));
    m_viewport->setObjectName("viewport");
    m_viewport->useSelection(m_selection);
    m_viewport->useInspection(m_inspection);
    m_viewport->useJobs(m_jobs);
    m_document.useJobs(m_jobs);
    m_viewMap = new ViewMap(m_document, m_settings, m_filterScene, *m_viewport, m_viewport);
    m_fileActions = new FileActions(m_document, m_selection, m_files, *m_messages, *this);
    m_center = new QStackedWidget;
    m_center->addWidget(new Welcome({m_fileActions->newAction(), m_fileActions->openAction()}));
    m_center->addWidget(m_viewport);

    auto* whole = new QWidget;
    auto* layout = new QVBoxLayout(whole);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_messages);
    layout->addWidget(m_center, 1);
    setCentralWidget(whole);
}

Workspace MainWindow::workspace()
{
    return {*this,
            m_document,
            m_selection,
            m_inspection,
            m_settings,
            m_colors,
            m_jobs,
            m_filterScene,
            *m_viewport,
            *m_viewMap,
            *m_messages};
}

void MainWindow::makePanels()
{
    m_panelActions = new PanelActions(*this, *m_viewport);
    const Workspace work = workspace();
    const PanelFrames frames(*this, *m_panelActions);
    m_panels = new WorkPanels(work, frames, this);
    new StudyPanels(work, frames, this);
    m_inspectors = new InspectorPanels(work, frames, this);
    m_importActions = new ImportActions(work, frames, this);
    m_exchange = new ExchangeActions(work, frames, this);
    connect(&m_panels->seams(), &SeamPanel::reported, m_inspectors, &InspectorPanels::showSeams);
}

void MainWindow::makeMenus()
{
    m_editActions = new EditActions(m_document, m_settings, *this);
    m_selectionActions = new SelectionActions(m_document, m_selection, *this);
    m_levelActions = new LevelActions(m_document, m_selection, m_jobs, *m_messages, *this);
    m_toolActions = new ToolActions(m_settings, *this);
    m_brushActions = new BrushActions(m_settings, m_colors, m_panels->brush(), *this);
    m_pictureActions = new PictureActions(workspace());
    m_viewActions = new ViewActions(m_document, m_settings, *m_viewport, *this);
    m_cardActions = new CardActions(m_settings, *this);
    m_mapActions = new MapActions(m_settings, *this);
    m_inspectActions =
        new InspectActions(m_document, m_inspection, *m_viewport, m_panels->readout(), *this);
    m_lookActions = new LookActions(m_document, m_settings, m_inspectors->look(), *this);

    QMenu* file = menuBar()->addMenu(tr("&File"));
    m_fileActions->fillMenu(*file);
    m_importActions->fillMenu(*file);
    file->addSeparator();
    m_exchange->fillMenu(*file);
    file->addSeparator();
    m_pictureActions->fillMenu(*file);
    file->addSeparator();
    file->addAction(m_fileActions->quitAction());
    QMenu* edit = menuBar()->addMenu(tr("&Edit"));
    m_editActions->fillMenu(*edit);
    edit->addSeparator();
    m_selectionActions->fillMenu(*edit);
    edit->addSeparator();
    m_levelActions->fillMenu(*edit);
    QAction* fit = ActionMaker(*this)(tr("Fit Levels to S&cene…"),
                                      tr("Plan the lowest levels that keep what views show"),
                                      QKeySequence(Qt::CTRL | Qt::Key_L));
    connect(fit, &QAction::triggered, m_panels, &WorkPanels::showFit);
    edit->addAction(fit);
    edit->addSeparator();
    m_inspectActions->fillEditMenu(*edit);
    m_toolActions->fillMenu(*menuBar()->addMenu(tr("&Tool")));
    m_brushActions->fillMenu(*menuBar()->addMenu(tr("&Brush")));
    m_panels->layerActions().fillMenu(*menuBar()->addMenu(tr("La&yer")));
    QMenu* view = menuBar()->addMenu(tr("&View"));
    m_viewActions->fillMenu(*view);
    m_cardActions->fillMenu(*view);
    view->addSeparator();
    m_inspectActions->fillViewMenu(*view);
    view->addSeparator();
    m_panels->bookmarkActions().fillMenu(*view);
    view->addSeparator();
    m_mapActions->fillMenu(*view);
    auto* filterings = new FilteringActions(m_settings, *this);
    filterings->fillMenu(*view);
    auto* compare = new CompareActions(m_settings, *m_mapActions, *filterings, *m_viewport, *this);
    connect(compare, &CompareActions::remembered, m_inspectors, &InspectorPanels::rememberBefore);
    compare->fillMenu(*view);
    m_lookActions->fillMenu(*view);
    view->addSeparator();
    m_inspectors->fillMenu(*view);
    m_panelActions->fillMenu(*view);

    ActionMaker make(*this);
    QAction* commands = make(tr("&Commands…"),
                             tr("Search all commands by typing"),
                             QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_P));
    QAction* about = make(tr("&About Trixel"), tr("Version and licence"));
    connect(commands, &QAction::triggered, this, &MainWindow::showCommands);
    connect(about, &QAction::triggered, this, &MainWindow::showAbout);
    QMenu* help = menuBar()->addMenu(tr("&Help"));
    help->addAction(commands);
    help->addAction(about);
}

void MainWindow::makeToolBars()
{
    auto* tools = new QToolBar(tr("Tools"));
    tools->setObjectName("toolBar");
    m_toolActions->fillToolBar(*tools);
    addToolBar(Qt::LeftToolBarArea, tools);

    auto* main = new QToolBar(tr("File and View"));
    main->setObjectName("mainToolBar");
    main->addAction(m_fileActions->newAction());
    main->addAction(m_fileActions->openAction());
    main->addAction(m_fileActions->saveAction());
    main->addSeparator();
    main->addAction(m_editActions->undoAction());
    main->addAction(m_editActions->redoAction());
    main->addSeparator();
    m_viewActions->fillToolBar(*main);
    main->addSeparator();
    m_lookActions->fillToolBar(*main);
    main->addAction(m_mapActions->filteredAction());
    addToolBar(Qt::TopToolBarArea, main);
    for (QToolBar* bar : {tools, main}) {
        bar->setIconSize({kIconSize, kIconSize});
        bar->setMovable(false);
        // The keyboard reaches the same actions through the menus.
        for (QToolButton* button : bar->findChildren<QToolButton*>()) {
            button->setFocusPolicy(Qt::NoFocus);
        }
    }
}

void MainWindow::makeStatusBar()
{
    m_hint = new QLabel;
    m_hint->setAccessibleName(tr("Hint"));
    m_hint->setToolTip(tr("What the chosen tool does"));
    // A narrow window cuts the hint off instead of widening.
    m_hint->setMinimumWidth(1);
    m_hint->setContentsMargins(6, 0, 0, 0);
    m_hint->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    statusBar()->addWidget(m_hint, 1);
    statusBar()->addPermanentWidget(new JobBar(m_jobs));
    statusBar()->addPermanentWidget(m_panels->layerActions().makeLabel());
    statusBar()->addPermanentWidget(m_selectionActions->makeLabel());
    statusBar()->addPermanentWidget(new StatusLine(m_document));
    const auto showHint = [this] { m_hint->setText(ToolActions::hintFor(m_settings.tool())); };
    connect(&m_settings, &ViewSettings::toolChanged, this, showHint);
    showHint();
    const auto tell = [this](const QString& sentence) {
        constexpr int kShownMs = 4000;
        statusBar()->showMessage(sentence, kShownMs);
    };
    connect(&m_files, &ProjectFiles::saved, this, [tell](const QString& path) {
        tell(tr("Saved %1").arg(path));
    });
    connect(m_inspectActions, &InspectActions::copied, this, tell);
}

void MainWindow::connectView()
{
    connect(m_viewport, &Viewport::colorPicked, this, [this](const std::array<float, 4>& color) {
        m_colors.choose(color);
    });
    // What was painted with is worth finding again.
    connect(&m_document, &Document::colorUsed, &m_colors, &BrushColors::remember);
    connect(&m_files, &ProjectFiles::sampleOpened, m_viewport, [this] {
        m_viewport->lookFrom(kSampleYaw, kSamplePitch, kSampleCloseness);
    });
    connect(m_viewport, &Viewport::notice, m_messages, &MessageBar::showNote);
}

void MainWindow::takeDocument()
{
    m_center->setCurrentWidget(m_document.isOpen() ? static_cast<QWidget*>(m_viewport)
                                                   : m_center->widget(0));
    if (m_document.isOpen()) {
        const float size = m_document.surface()->size();
        const TexelFormat& format = m_document.texels().format();
        Brush brush = m_settings.brush();
        brush.radius = size > 0 ? size * kFirstRadius : 1.0F;
        m_settings.setBrush(brush);
        m_brushActions->setSurfaceSize(size);
        m_colors.setGreyOnly(format.channels < 3);
        m_viewport->setFocus();
    }
}

void MainWindow::showTitle()
{
    setWindowTitle(m_document.isOpen() ? tr("%1[*] – Trixel").arg(m_document.title())
                                       : tr("Trixel"));
    setWindowModified(m_document.isModified());
}

void MainWindow::showCommands()
{
    auto* palette = new CommandPalette(*menuBar(), this);
    palette->setAttribute(Qt::WA_DeleteOnClose);
    const QPoint top(width() / 2 - palette->width() / 2, menuBar()->height() + 40);
    palette->move(mapToGlobal(top));
    palette->show();
}

void MainWindow::showAbout()
{
    auto* box = new QMessageBox(QMessageBox::NoIcon,
                                tr("About Trixel"),
                                tr("<b>Trixel %1</b>").arg(QCoreApplication::applicationVersion()),
                                QMessageBox::Ok,
                                this);
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setInformativeText(tr("Paint and inspect Ptex textures of triangle meshes.<br>"
                               "Free software under the GNU GPL, version 3 or later."));
    box->open();
}

void MainWindow::closeEvent(QCloseEvent* event)
{
    if (m_mayClose) {
        remember();
        event->accept();
        return;
    }
    event->ignore();
    m_fileActions->withoutLoss([this] { closeAfterExport(); });
}

/// An export is work the user waits for: closing lets it end (or be cancelled) first.
void MainWindow::closeAfterExport()
{
    if (m_files.isExporting()) {
        statusBar()->showMessage(tr("Closing when the export is done…"));
        connect(&m_files,
                &ProjectFiles::exportEnded,
                this,
                &MainWindow::closeAfterExport,
                static_cast<Qt::ConnectionType>(Qt::SingleShotConnection | Qt::UniqueConnection));
        return;
    }
    m_mayClose = true;
    // Not from within the event that asks.
    QMetaObject::invokeMethod(this, &QWidget::close, Qt::QueuedConnection);
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event)
{
    for (const QUrl& url : event->mimeData()->urls()) {
        if (url.isLocalFile()) {
            event->acceptProposedAction();
            return;
        }
    }
}

void MainWindow::dropEvent(QDropEvent* event)
{
    QStringList paths;
    for (const QUrl& url : event->mimeData()->urls()) {
        if (url.isLocalFile()) {
            paths += url.toLocalFile();
        }
    }
    event->acceptProposedAction();
    if (!m_importActions->takeDropped(paths)) {
        m_fileActions->openDropped(paths);
    }
}

void MainWindow::restore()
{
    const QSettings settings;
    restoreGeometry(settings.value("window/geometry").toByteArray());
    restoreState(settings.value("window/state").toByteArray());
    std::vector<QColor> recent;
    for (const QString& name : settings.value("brush/recentColours").toStringList()) {
        if (const QColor color(name); color.isValid()) {
            recent.push_back(color);
        }
    }
    m_colors.restore(recent);
}

void MainWindow::remember() const
{
    QSettings settings;
    settings.setValue("window/geometry", saveGeometry());
    settings.setValue("window/state", saveState());
    QStringList recent;
    for (const QColor& color : m_colors.recent()) {
        recent += color.name(QColor::HexArgb);
    }
    settings.setValue("brush/recentColours", recent);
}

} // namespace trixel::ui
