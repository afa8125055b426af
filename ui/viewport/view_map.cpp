// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/view_map.h"

#include <QMouseEvent>

#include "render/camera_view.h"
#include "ui/document/document.h"
#include "ui/document/filter_scene_source.h"
#include "ui/document/run_within_memory.h"
#include "ui/viewport/map_legend.h"
#include "ui/viewport/method_title.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace trixel::ui {

namespace {

/// A camera that moves is left alone: the map follows when it stands still for so long.
constexpr int kPauseMs = 80;

bool readsTexels(ViewMapKind map)
{
    return map == ViewMapKind::Filtered || map == ViewMapKind::Error;
}

/// Nothing where the map has no number.
std::optional<float> toNumber(float value)
{
    return std::isnan(value) ? std::nullopt : std::optional(value);
}

} // namespace

ViewMap::ViewMap(const Document& document,
                 ViewSettings& settings,
                 FilterSceneSource& source,
                 Viewport& viewport,
                 QObject* parent)
    : QObject(parent)
    , m_document(document)
    , m_settings(settings)
    , m_source(source)
    , m_viewport(viewport)
    , m_legend(new MapLegend(&viewport))
    , m_pixels(viewport, render::Side::A, this)
    , m_other(viewport, render::Side::B, this)
{
    m_pause.setSingleShot(true);
    m_pause.setInterval(kPauseMs);
    connect(&m_pause, &QTimer::timeout, this, &ViewMap::begin);
    for (PixelMap* pixels : {&m_pixels, &m_other}) {
        connect(pixels, &PixelMap::progressed, this, [this] {
            showState();
            showValue();
            emit progressed();
        });
    }
    connect(&settings, &ViewSettings::viewChanged, this, &ViewMap::takeOptions);
    connect(&settings, &ViewSettings::methodChanged, this, [this] {
        if (readsTexels(m_map)) {
            restart();
        }
    });
    connect(&m_faceWatcher, &QFutureWatcherBase::finished, this, &ViewMap::takeFaces);
    connect(&settings, &ViewSettings::lookChanged, this, [this] {
        if (m_map == ViewMapKind::Filtered) {
            restart();
        }
    });
    connect(&settings, &ViewSettings::comparisonChanged, this, [this] {
        const Comparison before = std::exchange(m_comparison, m_settings.comparison());
        if (before.by != m_comparison.by || before.method != m_comparison.method) {
            beginOther();
            showLegend();
            showState();
        }
    });
    connect(&viewport, &Viewport::cameraChanged, this, [this] {
        m_legend->place();
        if (!isOfFaces(m_map)) {
            restart();
        }
    });
    connect(&viewport, &Viewport::seenSurfaceChanged, this, [this] {
        if (!isOfFaces(m_map)) {
            restart();
        }
    });
    connect(&document, &Document::levelsChanged, this, [this] {
        if (isOfFaces(m_map)) {
            restart();
        }
    });
    connect(&document, &Document::opened, this, &ViewMap::restart);
    connect(&document, &Document::changed, this, [this] {
        if (readsTexels(m_map)) {
            restart();
        }
    });
    connect(&source, &FilterSceneSource::changed, this, [this] {
        if (readsTexels(m_map)) {
            restart();
        }
    });
    connect(&source, &FilterSceneSource::refused, this, [this] {
        if (readsTexels(m_map)) {
            ViewOptions view = m_settings.view();
            view.map = ViewMapKind::None;
            m_settings.setView(view);
        }
    });
    connect(&viewport, &Viewport::pointerMoved, this, [this](std::optional<QPointF> position) {
        m_pointer = position;
        showValue();
    });
    takeOptions();
}

ViewMap::~ViewMap()
{
    m_faceWatcher.disconnect(this);
    m_faceWatcher.waitForFinished();
}

void ViewMap::takeOptions()
{
    if (m_map == m_settings.view().map) {
        return;
    }
    m_map = m_settings.view().map;
    m_source.want(*this, readsTexels(m_map));
    restart();
}

/// Throws away what there is; the next picture begins when all is still.
void ViewMap::restart()
{
    drop();
    if (m_map == ViewMapKind::None || !m_document.isOpen()) {
        m_pause.stop();
        m_legend->setMap(ViewMapKind::None, {});
        return;
    }
    showLegend();
    showState();
    m_pause.start();
}

void ViewMap::showLegend()
{
    if (m_map == ViewMapKind::Fit) {
        m_legend->setMap(m_map, title(), MapScale::about(m_faceErrors.tolerance));
    } else {
        m_legend->setMap(m_map, title());
    }
}

void ViewMap::setFaceErrors(FaceErrors errors)
{
    m_faceErrors = std::move(errors);
    if (m_map == ViewMapKind::Fit) {
        restart();
    }
}

void ViewMap::setFaceDifferences(FaceDifferences differences)
{
    m_faceDifferences = std::move(differences);
    if (m_map == ViewMapKind::Difference) {
        restart();
    }
}

/// Whether all is there that the map is computed from.
bool ViewMap::isReady() const
{
    if (m_map == ViewMapKind::Fit) {
        return m_faceErrors.rms &&
               m_faceErrors.rms->size() == m_document.surface()->mesh().faceCount();
    }
    if (m_map == ViewMapKind::Difference) {
        return m_faceDifferences.rms &&
               m_faceDifferences.rms->size() == m_document.surface()->mesh().faceCount();
    }
    return !readsTexels(m_map) || m_source.isCurrent();
}

void ViewMap::drop()
{
    m_pixels.drop();
    m_other.drop();
    m_faceWatcher.cancel();
    m_faceValues.clear();
    m_viewport.setFaceColors({});
    emit facesNumbered(nullptr);
    showValue();
    emit progressed();
}

int ViewMap::completeStep() const
{
    if (isOfFaces(m_map)) {
        return m_faceValues.empty() ? 0 : 1;
    }
    const int pixels = m_pixels.completeStep();
    const int other = m_other.completeStep();
    return !hasOther() ? pixels : pixels == 0 || other == 0 ? 0 : std::max(pixels, other);
}

/// Whether B has a picture of its own.
bool ViewMap::hasOther() const
{
    return m_map == ViewMapKind::Filtered && m_comparison.by == ComparedBy::Method;
}

void ViewMap::begin()
{
    if (!m_document.isOpen() || !isReady()) {
        return; // begins again when it is
    }
    if (isOfFaces(m_map)) {
        beginFaces();
    } else {
        beginPixels();
    }
}

void ViewMap::beginFaces()
{
    FaceMapWork work{
        m_map, m_document.surface(), m_document.texels(), m_faceErrors, m_faceDifferences};
    m_faceWatcher.setFuture(
        runWithinMemory([work = std::move(work)] { return computeFaceMap(work); }));
    showState();
}

void ViewMap::takeFaces()
{
    if (m_faceWatcher.isCanceled()) {
        return; // of a map that is gone
    }
    auto made = madeOf(m_faceWatcher.future());
    if (!made) {
        m_legend->setState(tr("There is not enough memory for this map."));
        return;
    }
    const auto numbers = std::make_shared<const FaceNumbers>(std::move(*made));
    m_viewport.setFaceColors(numbers->colors);
    m_faceValues = numbers->values;
    m_legend->setMap(m_map, title(), numbers->scale);
    emit facesNumbered(numbers);
    showState();
    showValue();
    emit progressed();
}

void ViewMap::beginPixels()
{
    m_pixels.begin(workOf(m_settings.method()));
    beginOther();
    showState();
}

void ViewMap::beginOther()
{
    m_other.drop();
    if (hasOther() && m_pixels.step() > 0) {
        m_other.begin(workOf(m_comparison.method));
    }
}

MapWork ViewMap::workOf(const MethodChoice& method) const
{
    MapWork work;
    work.map = m_map;
    work.camera = render::viewOf(m_viewport.camera());
    work.surface = m_document.surface();
    work.limit = m_viewport.seenLimit();
    work.method = method;
    work.format = m_document.texels().format();
    work.look = m_settings.look();
    work.unit = m_viewport.devicePixelRatioF();
    if (readsTexels(m_map)) {
        work.scene = m_source.scene();
        work.range = m_source.valueRange();
    }
    return work;
}

std::optional<float> ViewMap::valueAt(QPointF position) const
{
    if (isOfFaces(m_map)) {
        const auto point =
            m_faceValues.empty() ? std::nullopt : m_viewport.surfacePointAt(position);
        return point ? toNumber(m_faceValues[indexOf(point->face)]) : std::nullopt;
    }
    const double ratio = m_viewport.devicePixelRatioF();
    return m_pixels.valueAt({static_cast<int>(std::floor(position.x() * ratio)),
                             static_cast<int>(std::floor(position.y() * ratio))});
}

void ViewMap::showValue()
{
    m_legend->setValue(m_pointer ? valueAt(*m_pointer) : std::nullopt);
}

void ViewMap::showState()
{
    const PixelMap& behind = hasOther() && m_pixels.completeStep() == 1 ? m_other : m_pixels;
    if (isComplete()) {
        m_legend->setState({});
    } else if (m_map == ViewMapKind::Fit && !isReady()) {
        m_legend->setState(tr("There is no plan yet."));
    } else if (m_map == ViewMapKind::Difference && !isReady()) {
        m_legend->setState(tr("Nothing was compared yet: File > Compare."));
    } else if (!isReady()) {
        m_legend->setState(tr("Preparing…"));
    } else if (behind.step() > 1) {
        m_legend->setState(tr("1/%1 of the pixels a side…").arg(behind.step()));
    } else if (behind.step() == 1) {
        m_legend->setState(tr("%1 % of the pixels…").arg(int(100 * behind.partOfStep())));
    } else {
        m_legend->setState(tr("Waiting…"));
    }
}

QString ViewMap::title() const
{
    QString name = methodTitle(m_settings.method());
    if (hasOther()) {
        name = tr("%1 (A) and %2 (B)").arg(name, methodTitle(m_comparison.method));
    }
    switch (m_map) {
    case ViewMapKind::Filtered:
        return m_settings.look() == render::Look()
                   ? tr("Every pixel filtered by %1, unlit; 0 is black, 1 is full").arg(name)
                   : tr("Every pixel filtered by %1, unlit, seen through the look").arg(name);
    case ViewMapKind::Condition:
        return tr("Condition of each pixel's footprint: its ellipse's length over its width");
    case ViewMapKind::Error:
        return tr("Error of %1: largest channel's difference from Exact, of the value range")
            .arg(name);
    case ViewMapKind::Fit:
        return tr("RMS that the fit leaves on each face, in 1/255; the tolerance is %1. Grey: in "
                  "no view")
            .arg(QString::number(255 * m_faceErrors.tolerance, 'g', 3));
    case ViewMapKind::Level:
        return tr("Level of each face: 4 to the power of it texels");
    case ViewMapKind::Density:
        return tr("Density of each face: texels along a unit of length");
    case ViewMapKind::Difference:
        return m_faceDifferences.file.empty()
                   ? tr("RMS of each face from a compared file's")
                   : tr("RMS of each face from that of %1, in % of the value range")
                         .arg(QString::fromStdString(m_faceDifferences.file));
    case ViewMapKind::None:
        break;
    }
    return {};
}

} // namespace trixel::ui
