// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inspector/net_filter.h"

#include "ui/document/document.h"
#include "ui/document/filter_scene_source.h"
#include "ui/document/run_within_memory.h"
#include "ui/viewport/view_settings.h"

#include <algorithm>
#include <cstring>
#include <utility>

namespace trixel::ui {

namespace {

/// As the map of the 3D view: a place that moves is left alone.
constexpr int kPauseMs = 80;

/// A face and the way back from the picture to its (u,v).
struct Laid
{
    FaceId face{};
    PlaneMap toUv;
};

bool isInside(glm::dvec2 uv)
{
    return uv.x >= 0 && uv.y >= 0 && uv.x + uv.y <= 1;
}

/// The pixels that show a face, each with the footprint that it has there.
ViewQueries queriesOf(const NetFilter::Place& place, int step)
{
    std::vector<Laid> faces; // the main one, which lies over the others, first
    for (auto face = place.scene.faces.rbegin(); face != place.scene.faces.rend(); ++face) {
        faces.push_back({face->face, face->layout.moved(place.toPixels).map().inverse()});
    }
    ViewQueries result;
    const auto first = [step](int from) { return from / step * step; };
    for (int top = first(place.area.top()); top <= place.area.bottom(); top += step) {
        for (int left = first(place.area.left()); left <= place.area.right(); left += step) {
            const int x = std::min(left + step / 2, place.size.width() - 1);
            const int y = std::min(top + step / 2, place.size.height() - 1);
            const glm::dvec2 middle(x + 0.5, y + 0.5);
            const auto hit = std::ranges::find_if(
                faces, [&](const Laid& laid) { return isInside(laid.toUv.point(middle)); });
            if (hit != faces.end()) {
                result.pixel.push_back(static_cast<std::uint32_t>(x + y * place.size.width()));
                result.queries.add(hit->face,
                                   glm::vec2(hit->toUv.point(middle)),
                                   glm::vec2(hit->toUv.x),
                                   glm::vec2(hit->toUv.y));
            }
        }
    }
    result.asked = result.size();
    return result;
}

} // namespace

NetFilter::NetFilter(const Document& document,
                     const ViewSettings& settings,
                     FilterSceneSource& source,
                     QObject* parent)
    : QObject(parent)
    , m_document(document)
    , m_settings(settings)
    , m_source(source)
{
    m_pause.setSingleShot(true);
    m_pause.setInterval(kPauseMs);
    connect(&m_pause, &QTimer::timeout, this, qOverload<>(&NetFilter::begin));
    for (Picture& picture : m_pictures) {
        connect(&picture.watcher,
                &QFutureWatcherBase::resultsReadyAt,
                this,
                [this, &picture](int from, int end) {
                    for (int k = from; k < end && !picture.watcher.isCanceled(); ++k) {
                        take(picture, picture.watcher.resultAt(k));
                    }
                    emit changed();
                });
    }
    const auto again = [this] {
        restart();
        emit changed();
    };
    connect(&settings, &ViewSettings::methodChanged, this, again);
    connect(&settings, &ViewSettings::lookChanged, this, again);
    connect(&settings, &ViewSettings::comparisonChanged, this, [this, again] {
        if (hasOther() != !m_pictures[1].image.isNull()) {
            again();
        }
    });
    connect(&source, &FilterSceneSource::changed, this, again);
    connect(&document, &Document::changed, this, again);
    connect(&document, &Document::opened, this, [this] { show(std::nullopt); });
}

NetFilter::~NetFilter()
{
    for (Picture& picture : m_pictures) {
        picture.watcher.disconnect(this);
        picture.watcher.cancel();
        picture.watcher.waitForFinished();
    }
}

bool NetFilter::isWanted() const
{
    return m_settings.view().map == ViewMapKind::Filtered;
}

bool NetFilter::hasOther() const
{
    return m_settings.comparison().by == ComparedBy::Method;
}

void NetFilter::show(const std::optional<Place>& place)
{
    if (place != m_place) {
        m_place = place;
        m_source.want(*this, place.has_value());
        restart();
    }
}

const QImage* NetFilter::picture(render::Side side) const
{
    const QImage& image = m_pictures[static_cast<std::size_t>(side)].image;
    return image.isNull() ? nullptr : &image;
}

bool NetFilter::isComplete() const
{
    return m_pictures[0].isComplete && (!hasOther() || m_pictures[1].isComplete);
}

void NetFilter::restart()
{
    drop();
    if (m_place && m_document.isOpen()) {
        m_pause.start();
    } else {
        m_pause.stop();
    }
}

void NetFilter::drop()
{
    for (Picture& picture : m_pictures) {
        picture.watcher.cancel();
        picture.image = {};
        picture.isComplete = false;
    }
}

void NetFilter::begin()
{
    if (!m_place || !m_document.isOpen() || !m_source.isCurrent()) {
        return; // begins again when the source says that it is
    }
    begin(m_pictures[0], m_settings.method());
    if (hasOther()) {
        begin(m_pictures[1], m_settings.comparison().method);
    }
}

void NetFilter::begin(Picture& picture, const MethodChoice& method)
{
    picture.image = QImage(m_place->size, QImage::Format_RGBA8888);
    picture.image.fill(Qt::transparent);
    MapWork work;
    work.map = ViewMapKind::Filtered;
    work.camera.width = m_place->size.width();
    work.camera.height = m_place->size.height();
    work.surface = m_document.surface();
    work.scene = m_source.scene();
    work.method = method;
    work.format = m_document.texels().format();
    work.look = m_settings.look();
    work.unit = m_place->unit;
    work.queries = [place = *m_place](int step) { return queriesOf(place, step); };
    picture.watcher.setFuture(runWithinMemory<MapBand>(
        [work = std::move(work)](QPromise<MapBand>& promise) { computeMap(promise, work); }));
}

void NetFilter::take(Picture& picture, const MapBand& band)
{
    const auto width = static_cast<std::size_t>(picture.image.width());
    const std::size_t rows = band.pixels.size() / width;
    for (std::size_t row = 0; row < rows; ++row) {
        std::memcpy(picture.image.scanLine(band.firstRow + static_cast<int>(row)),
                    band.pixels.data() + row * width,
                    4 * width);
    }
    picture.isComplete = band.step == 1 && band.endsPass;
}

} // namespace trixel::ui
