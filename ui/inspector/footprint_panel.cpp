// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inspector/footprint_panel.h"

#include <QApplication>
#include <QBoxLayout>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QToolButton>

#include "ui/docks/method_box.h"
#include "ui/document/document.h"
#include "ui/document/filter_scene_source.h"
#include "ui/document/inspection.h"
#include "ui/inspector/footprint_lines.h"
#include "ui/inspector/footprint_net_view.h"
#include "ui/inspector/footprint_table.h"
#include "ui/inspector/footprint_vectors.h"
#include "ui/inspector/sweep_bar.h"
#include "ui/viewport/view_settings.h"
#include "ui/viewport/viewport.h"

namespace trixel::ui {

namespace {

constexpr int kWide = 620; // from here on net and numbers stand side by side
constexpr int kSweepPauseMs = 150;
constexpr int kSweepStep = 2; // degrees
/// Lines that are drawn larger reach further than filters do.
constexpr double kLinesCut = 1.8;

} // namespace

FootprintPanel::FootprintPanel(const FootprintWork& work, QWidget* parent)
    : QWidget(parent)
    , m_work(work)
    , m_viewport(&work.viewport)
    , m_probe(new FootprintProbe(work.document, work.inspection, this))
    , m_answers(new FootprintAnswers(work.document, work.settings, work.filterScene, this))
    , m_frozenAnswers(new FootprintAnswers(work.document, work.settings, work.filterScene, this))
    , m_sweep(new FootprintSweep(this))
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

    auto* content = new QWidget;
    m_columns = new QBoxLayout(QBoxLayout::TopToBottom, content);
    m_columns->setContentsMargins(8, 8, 8, 8);
    m_columns->setSpacing(8);
    m_columns->addWidget(makeChoices(), 3);
    m_columns->addWidget(makeNumbers(), 2);
    auto* scroll = new QScrollArea;
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setWidget(content);
    scroll->setFocusPolicy(Qt::NoFocus);
    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins(0, 0, 0, 0);
    outer->addWidget(scroll);
    join();
}

/// Nobody may tell a panel anything that is half gone; what it works on may be gone already.
FootprintPanel::~FootprintPanel()
{
    m_links.reset();
}

/// Where the footprint comes from, its picture and what may be dragged.
QWidget* FootprintPanel::makeChoices()
{
    auto* side = new QWidget;
    auto* layout = new QVBoxLayout(side);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(6);

    m_source = new QComboBox;
    m_source->addItem(tr("Screen"), static_cast<int>(FootprintSource::Screen));
    m_source->addItem(tr("Texture-aligned"), static_cast<int>(FootprintSource::TextureAligned));
    m_source->addItem(tr("By hand"), static_cast<int>(FootprintSource::ByHand));
    m_source->addItem(tr("Tilted view"), static_cast<int>(FootprintSource::Tilted));
    m_source->setAccessibleName(tr("Source of the footprint"));
    m_source->setToolTip(
        tr("Where W1 and W2 come from: the pixel that sees this point, a box along "
           "u and v, your hand, or a view tilted over the point"));
    m_freeze = new QToolButton;
    m_freeze->setText(tr("Freeze"));
    m_freeze->setCheckable(true);
    m_freeze->setAccessibleName(tr("Freeze the footprint"));
    m_freeze->setToolTip(tr("Keep this footprint, then orbit or point elsewhere and compare"));
    auto* method = new MethodBox(m_work.settings);
    m_colouring = new QComboBox;
    m_colouring->addItem(tr("Weights of the method"));
    m_colouring->addItem(tr("Weights of exact"));
    m_colouring->addItem(tr("Texel values"));
    m_colouring->setAccessibleName(tr("Colour of the texels"));
    m_colouring->setToolTip(tr("Colour texels by how much they count in the answer, or by what "
                               "they hold"));
    for (QComboBox* box : {m_source, m_colouring, static_cast<QComboBox*>(method)}) {
        box->setMinimumWidth(60);
        box->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    }
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(6);
    grid->setVerticalSpacing(4);
    const auto label = [](const QString& text, QWidget* buddy) {
        auto* result = new QLabel(text);
        result->setBuddy(buddy);
        return result;
    };
    grid->addWidget(label(tr("&From"), m_source), 0, 0);
    grid->addWidget(m_source, 0, 1);
    grid->addWidget(m_freeze, 0, 2);
    grid->addWidget(label(tr("Me&thod"), method), 1, 0);
    grid->addWidget(method, 1, 1, 1, 2);
    grid->addWidget(label(tr("&Colour"), m_colouring), 2, 0);
    grid->addWidget(m_colouring, 2, 1, 1, 2);
    grid->setColumnStretch(1, 1);
    layout->addLayout(grid);
    layout->addWidget(m_view, 1);
    m_view->setMinimumHeight(240);

    m_vectors = new FootprintVectors;
    layout->addWidget(m_vectors);
    m_onSurface = new QCheckBox(tr("&Weights on the surface"));
    m_onSurface->setToolTip(tr("Outline the texels that count on the surface, too, in the colours "
                               "of their weights"));
    m_enlarge = new QCheckBox(tr("&Enlarge pixels %1×").arg(kEnlarged));
    m_enlarge->setToolTip(tr("A pixel's footprint is a pixel large on the screen: draw it so many "
                             "times larger on the surface"));
    m_enlarge->setChecked(true);
    layout->addWidget(m_onSurface);
    layout->addWidget(m_enlarge);
    return side;
}

QWidget* FootprintPanel::makeNumbers()
{
    auto* side = new QWidget;
    auto* layout = new QVBoxLayout(side);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(8);
    layout->addWidget(m_sweepBar);
    layout->addWidget(m_table);
    auto* copy = new QPushButton(tr("Copy n&umbers"));
    copy->setToolTip(tr("Copy every line, with those of the frozen footprint, to the clipboard"));
    copy->setAccessibleName(tr("Copy the numbers of the footprint"));
    connect(copy, &QPushButton::clicked, this, [this] {
        QApplication::clipboard()->setText(m_table->text());
    });
    layout->addWidget(copy, 0, Qt::AlignLeft);
    layout->addStretch(1);
    return side;
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
        const QSignalBlocker quiet(m_source);
        m_source->setCurrentIndex(m_source->findData(static_cast<int>(m_probe->source())));
        if (m_probe->source() != FootprintSource::Tilted) {
            m_sweepBar->setPlaying(false);
        }
        emit sourceChanged(m_probe->source());
    });
    connect(m_source, &QComboBox::currentIndexChanged, this, [this] {
        m_probe->setSource(static_cast<FootprintSource>(m_source->currentData().toInt()));
    });
    connect(m_view, &FootprintNetView::dragged, m_probe, &FootprintProbe::setVectors);
    connect(m_vectors, &FootprintVectors::edited, m_probe, &FootprintProbe::setVectors);
    connect(m_view, &FootprintNetView::clicked, this, [this](FaceId face, glm::dvec2 uv) {
        m_work.inspection.hold(face, glm::vec2(uv));
    });
    connect(m_freeze, &QToolButton::toggled, this, &FootprintPanel::setFrozen);
    connect(m_onSurface, &QCheckBox::toggled, this, [this](bool shown) {
        showOnSurface();
        emit weightsOnSurfaceChanged(shown);
    });
    connect(m_enlarge, &QCheckBox::toggled, links, [this] { showOnSurface(); });
    connect(m_colouring, &QComboBox::currentIndexChanged, this, [this] {
        m_answers->wantWeights(true, colouring() == Colouring::ExactWeights);
        showNet();
    });
    connect(m_answers, &FootprintAnswers::changed, links, [this] {
        showNet();
        showNumbers();
        if (m_onSurface->isChecked()) {
            showOnSurface();
        }
    });
    connect(m_frozenAnswers, &FootprintAnswers::changed, links, [this] { showNumbers(); });
    connect(m_sweep, &FootprintSweep::changed, links, [this] {
        m_sweepBar->plot().setPoints(m_sweep->points());
    });
    connect(m_sweepBar, &SweepBar::degreesChosen, links, [this](double degrees) {
        m_probe->setDegrees(degrees);
        m_sweepBar->setDegrees(degrees);
        m_probe->setSource(FootprintSource::Tilted);
    });
    connect(m_sweepBar, &SweepBar::playingChanged, links, [this](bool plays) {
        emit playingChanged(plays);
    });
    connect(&m_work.viewport, &Viewport::cameraChanged, links, [this] {
        if (m_probe->isActive()) {
            m_probe->setCamera(m_work.viewport.camera());
        }
    });
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

FootprintPanel::Colouring FootprintPanel::colouring() const
{
    return static_cast<Colouring>(m_colouring->currentIndex());
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
    m_columns->setDirection(width() >= kWide ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
}

void FootprintPanel::setActive(bool active)
{
    if (active) {
        m_probe->setCamera(m_work.viewport.camera());
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
    m_freeze->setEnabled(live.has_value() || isFrozen());
    m_answers->ask(live ? std::optional(live->placed) : std::nullopt);
    showNet();
    showNumbers();
    showOnSurface();
    sweepLater();
}

void FootprintPanel::refreshFrozen()
{
    const QSignalBlocker quiet(m_freeze);
    m_freeze->setChecked(isFrozen());
    m_freeze->setText(isFrozen() ? tr("Let go") : tr("Freeze"));
    const auto& frozen = m_probe->frozen();
    if (frozen) {
        m_frozenNet = netOf(frozen->placed);
    }
    if (m_probe->isActive()) {
        m_frozenAnswers->ask(frozen ? std::optional(frozen->placed) : std::nullopt);
        showNet();
        showNumbers();
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
    picture.texels = m_work.document.texels();
    picture.look = m_work.settings.look();
    picture.fill =
        colouring() == Colouring::Values ? NetPicture::Fill::Values : NetPicture::Fill::Weights;
    m_view->show(picture);
}

std::optional<FootprintFacts> FootprintPanel::facts(const std::optional<ProbedFootprint>& probed,
                                                    const FootprintAnswers& answers,
                                                    const FootprintNet& net) const
{
    if (!probed || net.faces.empty() || !m_work.document.isOpen()) {
        return std::nullopt;
    }
    return FootprintFacts{*probed,
                          net,
                          answers.answer(),
                          answers.answer() ? QString() : answers.reason(),
                          m_work.document.texels().format().type};
}

void FootprintPanel::showNumbers()
{
    m_table->show(facts(m_probe->live(), *m_answers, m_net));
    m_table->showFrozen(facts(m_probe->frozen(), *m_frozenAnswers, m_frozenNet));
}

double FootprintPanel::magnificationOf(const ProbedFootprint& probed) const
{
    const bool pixel =
        probed.source == FootprintSource::Screen || probed.source == FootprintSource::Tilted;
    return pixel && m_enlarge->isChecked() ? kEnlarged : 1.0;
}

void FootprintPanel::addLines(const ProbedFootprint& probed,
                              bool live,
                              std::vector<render::Polyline>& lines) const
{
    const double magnification = magnificationOf(probed);
    PlacedFootprint larger = probed.placed;
    larger.footprint.w1 *= magnification;
    larger.footprint.w2 *= magnification;
    const Surface& surface = *m_work.document.surface();
    NetLimits limits;
    limits.cut = kLinesCut; // the parallelogram's corners are √2 from the centre
    const FootprintNet net =
        footprintNet(surface.mesh(), surface.adjacency(), m_work.document.texels(), larger, limits);
    for (render::Polyline& line :
         footprintOnSurface(net,
                            surface.mesh(),
                            live ? FootprintRole::Live : FootprintRole::Frozen,
                            magnification == 1.0)) {
        lines.push_back(std::move(line));
    }
}

void FootprintPanel::showOnSurface()
{
    if (!m_probe->isActive() || !m_work.document.isOpen()) {
        return;
    }
    std::vector<render::Polyline> lines;
    const auto& answer = m_answers->answer();
    if (m_onSurface->isChecked() && m_probe->live() && answer && answer->weights) {
        lines = weightsOnSurface(m_work.document.surface()->mesh(), *answer->weights);
    }
    if (m_probe->frozen()) {
        addLines(*m_probe->frozen(), false, lines);
    }
    if (m_probe->live()) {
        addLines(*m_probe->live(), true, lines);
    }
    m_work.viewport.showFootprints(
        std::move(lines), m_probe->live() ? magnificationOf(*m_probe->live()) : 1.0, isFrozen());
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
    std::vector<FootprintSweep::Angle> angles;
    for (int degrees = 0; degrees < 90; degrees += kSweepStep) {
        const auto probed = m_probe->tilted(degrees);
        if (!probed) {
            return;
        }
        const auto corners = m_work.document.surface()->mesh().corners(probed->placed.face);
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
