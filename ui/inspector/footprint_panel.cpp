// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inspector/footprint_panel.h"

#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QPushButton>
#include <QSplitter>
#include <QTabBar>
#include <QTabWidget>
#include <QVBoxLayout>

#include "ui/document/document.h"
#include "ui/document/filter_scene_source.h"
#include "ui/document/inspection.h"
#include "ui/inspector/footprint_choices.h"
#include "ui/inspector/footprint_lines.h"
#include "ui/inspector/footprint_net_view.h"
#include "ui/inspector/footprint_table.h"
#include "ui/inspector/footprint_vectors.h"
#include "ui/inspector/sweep_bar.h"
#include "ui/viewport/view_settings.h"
#include "ui/viewport/viewport.h"

#include <utility>

namespace trixel::ui {

namespace {

constexpr int kWide = 620; // from here on net and numbers stand side by side
constexpr int kMargin = 8;
constexpr int kSweepPage = 2;
constexpr int kSweepPauseMs = 150;
constexpr int kSweepStep = 2; // degrees

} // namespace

FootprintPanel::FootprintPanel(const FootprintWork& work, QWidget* parent)
    : QWidget(parent)
    , m_work(work)
    , m_viewport(&work.viewport)
    , m_probe(new FootprintProbe(work.document, work.inspection, this))
    , m_answers(new FootprintAnswers(work.document, work.settings, work.filterScene, this))
    , m_frozenAnswers(new FootprintAnswers(work.document, work.settings, work.filterScene, this))
    , m_sweep(new FootprintSweep(this))
    , m_choices(new FootprintChoices(work.settings))
    , m_splitter(new QSplitter(Qt::Vertical))
    , m_pages(new QTabWidget)
    , m_view(new FootprintNetView)
    , m_table(new FootprintTable)
    , m_sweepBar(new SweepBar)
{
    m_view->setHint(tr("Point at a face in the view.\nIts pixel's footprint is laid flat here: "
                       "W1 and W2 lead to the next samples, the ellipse is what a filter averages "
                       "over."));
    m_refresh.setSingleShot(true);
    m_refresh.setInterval(0);
    m_sweepPause.setSingleShot(true);
    m_sweepPause.setInterval(kSweepPauseMs);
    auto* picture = new QWidget;
    auto* column = new QVBoxLayout(picture);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(6);
    column->addWidget(m_choices);
    column->addWidget(m_view, 1);
    makePages();
    m_splitter->setChildrenCollapsible(false);
    m_splitter->addWidget(picture);
    m_splitter->addWidget(m_pages);
    m_splitter->setStretchFactor(0, 3);
    m_splitter->setStretchFactor(1, 2);
    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins(kMargin, kMargin, kMargin, kMargin);
    outer->addWidget(m_splitter);
    join();
}

/// Nobody may tell a panel anything that is half gone; what it works on may be gone already.
FootprintPanel::~FootprintPanel()
{
    m_links.reset();
}

/// What stands beside or below the picture, a page at a time: the picture keeps its room.
void FootprintPanel::makePages()
{
    m_pages->setDocumentMode(true);
    m_pages->setAccessibleName(tr("Numbers, vectors and sweep of the footprint"));
    m_pages->tabBar()->setAccessibleName(m_pages->accessibleName());
    m_pages->setToolTip(tr("What the footprint is, how to change it, and how it fares when the "
                           "view tilts"));
    m_pages->tabBar()->setToolTip(m_pages->toolTip());
    m_pages->addTab(makeNumbers(), tr("Numbers"));
    m_pages->addTab(makeVectors(), tr("Vectors"));
    auto* sweep = new QWidget;
    auto* column = new QVBoxLayout(sweep);
    column->setContentsMargins(0, 6, 0, 0);
    column->addWidget(m_sweepBar);
    column->addStretch(1);
    m_pages->addTab(sweep, tr("Sweep"));
}

QWidget* FootprintPanel::makeNumbers()
{
    auto* page = new QWidget;
    auto* column = new QVBoxLayout(page);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(4);
    column->addWidget(m_table, 1);
    auto* copy = new QPushButton(tr("Copy n&umbers"));
    copy->setToolTip(tr("Copy every line, with those of the frozen footprint, to the clipboard"));
    copy->setAccessibleName(tr("Copy the numbers of the footprint"));
    connect(copy, &QPushButton::clicked, this, [this] {
        QApplication::clipboard()->setText(m_table->text());
    });
    column->addWidget(copy, 0, Qt::AlignLeft);
    return page;
}

QWidget* FootprintPanel::makeVectors()
{
    auto* page = new QWidget;
    auto* column = new QVBoxLayout(page);
    column->setContentsMargins(0, 6, 0, 0);
    column->setSpacing(6);
    m_vectors = new FootprintVectors;
    column->addWidget(m_vectors);
    m_onSurface = new QCheckBox(tr("&Weights on the surface"));
    m_onSurface->setToolTip(tr("Outline the texels that count on the surface, too, in the colours "
                               "of their weights"));
    m_enlarge = new QCheckBox(tr("&Enlarge pixels %1×").arg(kFootprintEnlarged));
    m_enlarge->setToolTip(tr("A pixel's footprint is a pixel large on the screen: draw it so many "
                             "times larger on the surface"));
    m_enlarge->setChecked(true);
    column->addWidget(m_onSurface);
    column->addWidget(m_enlarge);
    column->addStretch(1);
    return page;
}

void FootprintPanel::join()
{
    QObject* links = m_links.get();
    const auto later = [this] { m_refresh.start(); };
    connect(&m_refresh, &QTimer::timeout, this, &FootprintPanel::refresh);
    connect(&m_sweepPause, &QTimer::timeout, this, &FootprintPanel::startSweep);
    connect(m_probe, &FootprintProbe::changed, links, later);
    connect(m_probe, &FootprintProbe::frozenChanged, links, [this] { refreshFrozen(); });
    connect(m_probe, &FootprintProbe::sourceChanged, links, [this] {
        m_choices->setSource(m_probe->source());
        if (m_probe->source() != FootprintSource::Tilted) {
            m_sweepBar->setPlaying(false);
        }
        emit sourceChanged(m_probe->source());
    });
    connect(m_choices, &FootprintChoices::sourceChosen, m_probe, &FootprintProbe::setSource);
    connect(m_view, &FootprintNetView::dragged, m_probe, &FootprintProbe::setVectors);
    connect(m_vectors, &FootprintVectors::edited, m_probe, &FootprintProbe::setVectors);
    connect(m_view, &FootprintNetView::clicked, this, [this](FaceId face, glm::dvec2 uv) {
        m_work.inspection.hold(face, glm::vec2(uv));
    });
    connect(m_choices, &FootprintChoices::freezeToggled, this, &FootprintPanel::setFrozen);
    connect(m_onSurface, &QCheckBox::toggled, this, [this](bool shown) {
        showOnSurface();
        emit weightsOnSurfaceChanged(shown);
    });
    connect(m_enlarge, &QCheckBox::toggled, links, [this] { showOnSurface(); });
    connect(m_choices, &FootprintChoices::colouringChosen, this, [this] {
        m_answers->wantWeights(true,
                               m_choices->colouring() == FootprintChoices::Colouring::ExactWeights);
        showNet();
    });
    connect(m_answers, &FootprintAnswers::changed, links, [this] { takeAnswer(); });
    connect(m_frozenAnswers, &FootprintAnswers::changed, links, [this] { showFrozenNumbers(); });
    connect(m_sweep, &FootprintSweep::changed, links, [this] {
        m_sweepBar->plot().setPoints(m_sweep->points());
    });
    connect(m_sweepBar, &SweepBar::degreesChosen, links, [this](double degrees) {
        m_probe->setDegrees(degrees);
        m_sweepBar->setDegrees(degrees);
        m_probe->setSource(FootprintSource::Tilted);
    });
    connect(m_sweepBar, &SweepBar::playingChanged, links, [this](bool plays) {
        if (plays) {
            m_pages->setCurrentIndex(kSweepPage);
        }
        emit playingChanged(plays);
    });
    connect(&m_work.viewport, &Viewport::cameraChanged, links, [this] {
        if (m_probe->isActive()) {
            m_probe->setCamera(m_work.viewport.camera());
        }
    });
    connect(&m_work.viewport, &Viewport::seenSurfaceChanged, links, [this] { takeSurface(); });
    connect(&m_work.settings, &ViewSettings::methodChanged, links, [this] { sweepLater(); });
    connect(&m_work.settings, &ViewSettings::lookChanged, links, [this] { showNet(); });
    connect(&m_work.filterScene, &FilterSceneSource::changed, links, [this] { sweepLater(); });
    connect(&m_work.document, &Document::changed, links, later);
    m_answers->wantWeights(true, false);
}

void FootprintPanel::setFrozen(bool frozen)
{
    if (frozen == isFrozen()) {
        return;
    }
    if (frozen) {
        m_probe->freeze();
    } else {
        m_probe->thaw();
    }
}

void FootprintPanel::setWeightsOnSurface(bool shown)
{
    m_onSurface->setChecked(shown);
}

void FootprintPanel::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    setActive(true);
}

void FootprintPanel::hideEvent(QHideEvent* event)
{
    QWidget::hideEvent(event);
    setActive(false);
}

void FootprintPanel::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    const Qt::Orientation wanted = width() >= kWide ? Qt::Horizontal : Qt::Vertical;
    if (m_splitter->orientation() != wanted) {
        m_splitter->setOrientation(wanted);
    }
}

void FootprintPanel::setActive(bool active)
{
    if (active) {
        m_probe->setCamera(m_work.viewport.camera());
        m_probe->setLimit(m_work.viewport.seenLimit());
        m_probe->setActive(true);
        refreshFrozen();
        m_refresh.start();
        return;
    }
    m_sweepBar->setPlaying(false);
    m_probe->setActive(false);
    m_refresh.stop();
    m_sweepPause.stop();
    m_sweep->clear();
    m_answers->ask(std::nullopt);
    m_frozenAnswers->ask(std::nullopt);
    if (m_viewport) { // a window that ends takes it away first
        m_viewport->showFootprints(std::nullopt);
    }
}

/// The view shows another surface: footprints of its pixels are others, and all lie elsewhere.
void FootprintPanel::takeSurface()
{
    if (m_probe->isActive()) {
        m_probe->setLimit(m_work.viewport.seenLimit());
        m_refresh.start();
    }
}

FootprintNet FootprintPanel::netOf(const PlacedFootprint& footprint) const
{
    const Surface& surface = *m_work.document.surface();
    return footprintNet(surface.mesh(), surface.adjacency(), m_work.document.texels(), footprint);
}

void FootprintPanel::refresh()
{
    if (!m_probe->isActive()) {
        return;
    }
    const auto& live = m_probe->live();
    if (live) {
        m_net = netOf(live->placed);
        m_vectors->show(live->placed.footprint, 1.0 / m_net.faces.front().level.resolution());
    }
    m_vectors->setEnabled(live.has_value());
    m_choices->setFrozen(isFrozen(), live.has_value() || isFrozen());
    m_answers->ask(live ? std::optional(live->placed) : std::nullopt);
    showNet();
    showNumbers();
    showOnSurface();
    sweepLater();
}

void FootprintPanel::refreshFrozen()
{
    const auto& frozen = m_probe->frozen();
    m_choices->setFrozen(isFrozen(), m_probe->live().has_value() || isFrozen());
    if (frozen) {
        m_frozenNet = netOf(frozen->placed);
    }
    if (m_probe->isActive()) {
        m_frozenAnswers->ask(frozen ? std::optional(frozen->placed) : std::nullopt);
        showNet();
        showFrozenNumbers();
        showOnSurface();
    }
    emit frozenChanged(isFrozen());
}

void FootprintPanel::showNet()
{
    if (!m_probe->live() || m_net.faces.empty() || !m_work.document.isOpen()) {
        m_view->show(std::nullopt);
        return;
    }
    NetPicture picture;
    picture.net = m_net;
    const auto& answer = m_answers->answer();
    if (answer && answer->weights) {
        picture.weights = answer->weights;
    }
    if (m_probe->frozen()) {
        picture.frozen = m_probe->frozen()->placed;
    }
    if (m_choices->colouring() == FootprintChoices::Colouring::Values) {
        picture.fill = NetPicture::Fill::Values;
        picture.texels = m_work.document.texels();
        picture.look = m_work.settings.look();
    }
    m_view->show(picture);
}

/// An answer comes in parts; most of them are numbers alone.
void FootprintPanel::takeAnswer()
{
    const auto& answer = m_answers->answer();
    const auto& shown = m_view->picture();
    const auto& weights = answer ? answer->weights : std::nullopt;
    const bool otherWeights = shown && shown->weights != weights;
    const bool isToCome = answer && !weights && answer->noWeights.isEmpty();
    if (otherWeights && !isToCome) { // those shown stay until there are others
        showNet();
        if (m_onSurface->isChecked()) {
            showOnSurface();
        }
    }
    showNumbers();
}

std::optional<FootprintFacts> FootprintPanel::facts(const std::optional<ProbedFootprint>& probed,
                                                    const FootprintAnswers& answers,
                                                    const FootprintNet& net) const
{
    if (!probed || net.faces.empty() || !m_work.document.isOpen()) {
        return std::nullopt;
    }
    const auto& answer = answers.answer();
    return FootprintFacts{*probed,
                          net,
                          answer ? &*answer : nullptr,
                          answer ? QString() : answers.reason(),
                          m_work.document.texels().format().type};
}

void FootprintPanel::showNumbers()
{
    m_table->show(facts(m_probe->live(), *m_answers, m_net));
}

void FootprintPanel::showFrozenNumbers()
{
    m_table->showFrozen(facts(m_probe->frozen(), *m_frozenAnswers, m_frozenNet));
}

void FootprintPanel::showOnSurface()
{
    if (!m_probe->isActive() || !m_work.document.isOpen()) {
        return;
    }
    const auto& answer = m_answers->answer();
    FootprintMarks marks;
    marks.live = m_probe->live() ? &*m_probe->live() : nullptr;
    marks.frozen = m_probe->frozen() ? &*m_probe->frozen() : nullptr;
    marks.enlarged = m_enlarge->isChecked();
    if (m_onSurface->isChecked() && answer && answer->weights) {
        marks.weights = &*answer->weights;
    }
    const std::shared_ptr<const LimitMesh> limit = m_work.viewport.seenLimit();
    const SeenSurface seen(*m_work.document.surface(), limit.get());
    m_work.viewport.showFootprints(
        marksOnSurface(seen, m_work.document.texels(), marks),
        m_probe->live() ? magnificationOf(*m_probe->live(), marks.enlarged) : 1.0,
        isFrozen());
}

void FootprintPanel::sweepLater()
{
    if (m_probe->isActive() && m_probe->source() == FootprintSource::Tilted &&
        !m_sweepBar->isPlaying()) {
        m_sweepPause.start();
    } else if (m_sweepBar->isPlaying() && m_sweep->points().empty() && !m_sweepPause.isActive()) {
        m_sweepPause.start();
    }
}

void FootprintPanel::startSweep()
{
    if (!m_probe->isActive() || !m_work.filterScene.isCurrent() || !m_probe->live()) {
        return;
    }
    const std::shared_ptr<const LimitMesh> limit = m_work.viewport.seenLimit();
    const SeenSurface seen(*m_work.document.surface(), limit.get());
    std::vector<FootprintSweep::Angle> angles;
    for (int degrees = 0; degrees < 90; degrees += kSweepStep) {
        const auto probed = m_probe->tilted(degrees);
        if (!probed) {
            return;
        }
        const auto corners = seen.tangentFace(probed->placed.face, glm::vec2(probed->placed.uv));
        angles.push_back({static_cast<double>(degrees),
                          ellipseOf(probed->placed.footprint, corners).anisotropy(),
                          probed->placed});
    }
    m_sweep->start(m_work.filterScene.scene(),
                   m_work.settings.method(),
                   m_work.filterScene.valueRange(),
                   std::move(angles));
}

} // namespace trixel::ui
