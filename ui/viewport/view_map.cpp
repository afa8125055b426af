// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/view_map.h"

#include <QMouseEvent>
#include <QtConcurrent>

#include "render/camera_view.h"
#include "ui/document/document.h"
#include "ui/document/filter_scene_source.h"
#include "ui/viewport/map_legend.h"

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
{
    m_pause.setSingleShot(true);
    m_pause.setInterval(kPauseMs);
    connect(&m_pause, &QTimer::timeout, this, &ViewMap::begin);
    connect(&m_watcher, &QFutureWatcherBase::resultsReadyAt, this, [this](int first, int last) {
        for (int k = first; k < last; ++k) {
            takeBand(m_watcher.resultAt(k));
        }
    });
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
    connect(&viewport, &Viewport::cameraChanged, this, [this] {
        m_legend->place();
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
    m_watcher.disconnect(this);
    m_watcher.cancel();
    m_watcher.waitForFinished();
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

/// Whether all is there that the map is computed from.
bool ViewMap::isReady() const
{
    if (m_map == ViewMapKind::Fit) {
        return m_faceErrors.rms &&
               m_faceErrors.rms->size() == m_document.surface()->mesh().faceCount();
    }
    return !readsTexels(m_map) || m_source.isCurrent();
}

void ViewMap::drop()
{
    m_watcher.cancel();
    m_faceWatcher.cancel();
    m_completeStep = 0;
    m_step = 0;
    m_rows = 0;
    m_values.clear();
    m_viewport.clearPicture();
    m_viewport.setFaceColors({});
    showValue();
    emit progressed();
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
    FaceMapWork work{m_map, m_document.surface(), m_document.texels(), m_faceErrors};
    m_faceWatcher.setFuture(
        QtConcurrent::run([work = std::move(work)] { return computeFaceMap(work); }));
    showState();
}

void ViewMap::takeFaces()
{
    if (m_faceWatcher.isCanceled()) {
        return; // of a map that is gone
    }
    const FaceNumbers numbers = m_faceWatcher.result();
    m_viewport.setFaceColors(numbers.colors);
    m_values = numbers.values;
    m_completeStep = 1;
    m_legend->setMap(m_map, title(), numbers.scale);
    showState();
    showValue();
    emit progressed();
}

void ViewMap::beginPixels()
{
    MapWork work;
    work.map = m_map;
    work.camera = render::viewOf(m_viewport.camera());
    work.surface = m_document.surface();
    work.method = m_settings.method();
    work.format = m_document.texels().format();
    work.look = m_settings.look();
    if (readsTexels(m_map)) {
        work.scene = m_source.scene();
        work.range = m_source.valueRange();
    }
    m_size = {work.camera.width, work.camera.height};
    if (m_map != ViewMapKind::Filtered) {
        m_values.assign(static_cast<std::size_t>(m_size.width()) *
                            static_cast<std::size_t>(m_size.height()),
                        std::nanf(""));
    }
    m_step = kMapSteps[0];
    m_watcher.setFuture(QtConcurrent::run(
        [work = std::move(work)](QPromise<MapBand>& promise) { computeMap(promise, work); }));
    showState();
}

void ViewMap::takeBand(const MapBand& band)
{
    if (m_watcher.isCanceled()) {
        return; // of a view that is gone
    }
    const auto begin =
        static_cast<std::ptrdiff_t>(band.firstRow) * static_cast<std::ptrdiff_t>(m_size.width());
    std::ranges::copy(band.values, m_values.begin() + (band.values.empty() ? 0 : begin));
    m_viewport.setPictureRows(band.pixels, m_size, band.firstRow);
    m_step = band.step;
    m_rows = band.firstRow + static_cast<int>(band.pixels.size()) / std::max(1, m_size.width());
    if (band.endsPass) {
        m_completeStep = band.step;
    }
    showState();
    showValue();
    emit progressed();
}

std::optional<float> ViewMap::valueAt(QPointF position) const
{
    if (m_values.empty()) {
        return std::nullopt;
    }
    if (isOfFaces(m_map)) {
        const auto point = m_viewport.surfacePointAt(position);
        return point ? toNumber(m_values[indexOf(point->face)]) : std::nullopt;
    }
    const double ratio = m_viewport.devicePixelRatioF();
    const QPoint pixel(static_cast<int>(std::floor(position.x() * ratio)),
                       static_cast<int>(std::floor(position.y() * ratio)));
    if (!QRect(QPoint(), m_size).contains(pixel)) {
        return std::nullopt;
    }
    const float value =
        m_values[static_cast<std::size_t>(pixel.x()) +
                 static_cast<std::size_t>(pixel.y()) * static_cast<std::size_t>(m_size.width())];
    return toNumber(value);
}

void ViewMap::showValue()
{
    m_legend->setValue(m_pointer ? valueAt(*m_pointer) : std::nullopt);
}

void ViewMap::showState()
{
    if (isComplete()) {
        m_legend->setState({});
    } else if (m_map == ViewMapKind::Fit && !isReady()) {
        m_legend->setState(tr("There is no plan yet."));
    } else if (!isReady()) {
        m_legend->setState(tr("Preparing…"));
    } else if (m_step > 1) {
        m_legend->setState(tr("1/%1 of the pixels a side…").arg(m_step));
    } else if (m_step == 1) {
        m_legend->setState(tr("%1 % of the pixels…").arg(100 * m_rows / m_size.height()));
    } else {
        m_legend->setState(tr("Waiting…"));
    }
}

QString ViewMap::title() const
{
    const MethodEntry* entry = findMethod(m_settings.method().name);
    const QString name =
        entry != nullptr
            ? QString::fromUtf8(entry->title.data(), static_cast<qsizetype>(entry->title.size()))
            : QString();
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
    case ViewMapKind::None:
        break;
    }
    return {};
}

} // namespace trixel::ui
