// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/filter_scene_source.h"

#include "ui/document/document.h"
#include "ui/document/released_elsewhere.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace trixel::ui {

namespace {

/// Changes that follow each other are taken together.
constexpr int kPauseMs = 40;
/// A stroke has the processor to itself.
constexpr int kStrokePauseMs = 120;
/// Beyond so many touched rectangles it is simpler to begin anew.
constexpr std::size_t kMostRects = 100'000;

} // namespace

FilterSceneSource::FilterSceneSource(Document& document, BackgroundJobs& jobs, QObject* parent)
    : QObject(parent)
    , m_document(document)
    , m_jobs(jobs)
{
    m_pause.setSingleShot(true);
    m_pause.setInterval(kPauseMs);
    connect(&m_pause, &QTimer::timeout, this, &FilterSceneSource::refresh);
    connect(&document, &Document::changed, this, &FilterSceneSource::takeChange);
    connect(&document, &Document::opened, this, [this] {
        m_surface.reset();
        forget();
        refresh();
    });
}

void FilterSceneSource::want(QObject& who, bool wanted)
{
    if (!wanted) {
        leave(&who);
        return;
    }
    if (std::ranges::find(m_wanting, &who) == m_wanting.end()) {
        m_wanting.push_back(&who);
        connect(&who, &QObject::destroyed, this, [this](const QObject* gone) {
            disconnect(this, nullptr, gone, nullptr); // half gone, it must not hear of it
            leave(gone);
        });
    }
    refresh();
}

void FilterSceneSource::leave(const QObject* who)
{
    if (std::erase(m_wanting, who) > 0 && m_wanting.empty()) {
        forget();
    }
}

/// What is under way is dropped when it comes.
void FilterSceneSource::forget()
{
    ++m_generation;
    if (m_building) {
        m_building->cancel(); // two scenes at once are gigabytes for nothing
    }
    m_isBusy = false;
    m_rebuild = true;
    m_isStale = true;
    m_touched.clear();
    m_bounds = {};
    m_bytes = 0;
    if (std::exchange(m_scene, nullptr)) {
        emit changed();
    }
}

void FilterSceneSource::takeChange(const Change& change)
{
    m_isStale = true;
    if (m_rebuild && !m_isBusy) {
        return;
    }
    m_touched.insert(m_touched.end(), change.rects.begin(), change.rects.end());
    if (change.rects.empty() || m_touched.size() > kMostRects) {
        m_touched.clear();
        m_rebuild = true;
    }
    if (!m_wanting.empty() && !m_pause.isActive()) {
        m_pause.start(kPauseMs);
    }
}

void FilterSceneSource::refresh()
{
    if (m_wanting.empty() || m_isBusy || !m_isStale || !m_document.isOpen()) {
        return;
    }
    if (m_document.hasStroke()) {
        m_pause.start(kStrokePauseMs);
        return;
    }
    m_isBusy = true;
    m_isStale = false; // until the next change
    if (std::exchange(m_rebuild, false)) {
        m_touched.clear();
        build();
    } else {
        update();
    }
}

void FilterSceneSource::build()
{
    m_building = &m_jobs.run(
        tr("Preparing the filters…"),
        [surface = m_document.surface(), shape = m_surface, store = m_document.texels()](
            Progress& progress) mutable -> Result<Made> {
            if (!shape) {
                shape = std::make_shared<const FilterSurface>(
                    FilterSurface::fromMesh(surface->mesh(), surface->adjacency()));
            }
            auto built = FilterScene::build(shape, store, Threads::all(), progress);
            if (!built) {
                return tl::unexpected(built.error());
            }
            const auto scene =
                releasedElsewhere(std::make_unique<const FilterScene>(std::move(*built)));
            return Made{
                shape, scene, ValueBounds::of(scene->mips(), Threads::all()), bytesOf(*scene)};
        },
        [this, generation = m_generation](const Result<Made>& made) { take(generation, made); });
}

void FilterSceneSource::update()
{
    m_updates.run(
        QString(),
        [shape = m_surface,
         scene = m_scene,
         bounds = m_bounds,
         store = m_document.texels(),
         rects = std::exchange(m_touched, {})](Progress& /*progress*/) mutable -> Result<Made> {
            auto next = std::make_unique<FilterScene>(*scene);
            next->update(store, rects);
            std::optional<FaceId> last; // a stroke names its faces in runs
            for (const TouchedRect& rect : rects) {
                if (std::exchange(last, rect.face) != rect.face) {
                    bounds.add(next->mips(), rect.face);
                }
            }
            const std::size_t bytes = bytesOf(*next);
            return Made{shape,
                        releasedElsewhere<const FilterScene>(std::move(next)),
                        std::move(bounds),
                        bytes};
        },
        [this, generation = m_generation](const Result<Made>& made) { take(generation, made); });
}

std::size_t FilterSceneSource::bytesOf(const FilterScene& scene)
{
    return scene.mips().memoryBytes() + scene.pyramid().memoryBytes();
}

void FilterSceneSource::take(quint64 generation, const Result<Made>& made)
{
    if (generation != m_generation) {
        return; // of other texels
    }
    m_isBusy = false;
    if (!made) {
        const QString sentence = QString::fromStdString(made.error().message);
        m_wanting.clear();
        forget();
        emit refused(sentence);
        return;
    }
    m_scene = made->scene;
    m_surface = made->surface;
    m_bounds = made->bounds;
    m_bytes = made->bytes;
    emit changed();
    refresh(); // what was touched meanwhile
}

std::uint64_t FilterSceneSource::expectedBytes(const TexelStore& store)
{
    const std::uint64_t texels = store.storedBytes() / store.format().texelBytes();
    const std::uint64_t groups =
        (store.format().channels + std::uint64_t{kGroupChannels} - 1) / kGroupChannels;
    // Four thirds of a texel and about as much again of vertices.
    return texels * groups * sizeof(float) * kGroupChannels * 8 / 3;
}

} // namespace trixel::ui
