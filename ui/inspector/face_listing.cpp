// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inspector/face_listing.h"

#include "ui/document/document.h"
#include "ui/document/face_selection.h"
#include "ui/viewport/view_settings.h"

#include <algorithm>
#include <utility>

namespace trixel::ui {

namespace {

/// Figures follow a stroke when it has ended, not every dab.
constexpr int kCalmMs = 120;
/// Of more touched faces all are measured again.
constexpr std::size_t kMostTouched = 100'000;

struct TouchedFace
{
    FaceId face;
    FaceTexels texels;
};

/// A channel that the format has; a look may be kept from another document.
ChannelChoice channelOf(const ViewSettings& settings, const TexelFormat& format)
{
    const ChannelChoice channel = settings.look().channel;
    return channel && *channel < format.channels ? channel : std::nullopt;
}

} // namespace

FaceListing::FaceListing(const Document& document,
                         const FaceSelection& selection,
                         const ViewSettings& settings,
                         BackgroundJobs& jobs,
                         QObject* parent)
    : QObject(parent)
    , m_document(document)
    , m_selection(selection)
    , m_settings(settings)
    , m_jobs(jobs)
    , m_selected(selection.snapshot())
{
    m_soon.setSingleShot(true);
    m_soon.setInterval(kCalmMs);
    connect(&m_soon, &QTimer::timeout, this, &FaceListing::goOn);
    connect(&document, &Document::opened, this, &FaceListing::forget);
    connect(&document, &Document::changed, this, &FaceListing::takeChange);
    connect(&settings, &ViewSettings::lookChanged, this, &FaceListing::takeLook);
}

void FaceListing::setWatched(bool watched)
{
    if (std::exchange(m_isWatched, watched) != watched && watched) {
        m_isStopped = false;
        goOn();
    }
}

void FaceListing::sortBy(FaceColumn column, bool descending)
{
    if (m_order.by != column || m_order.descending != descending) {
        m_order.by = column;
        m_order.descending = descending;
        m_orderStale = true;
        goOn();
    }
}

void FaceListing::setFilter(const FaceFilter& filter)
{
    if (m_order.filter != filter) {
        m_order.filter = filter;
        m_selected = m_selection.snapshot();
        m_orderStale = true;
        goOn();
    }
}

void FaceListing::takeSelection()
{
    if (m_order.filter.asksForSelection()) {
        m_selected = m_selection.snapshot();
        m_orderStale = true;
        goOn();
    }
}

void FaceListing::setSeams(std::shared_ptr<const SeamReport> report)
{
    m_seams = std::move(report);
    m_jumpsStale = true;
    goOn();
}

FaceFacts FaceListing::facts() const
{
    check(m_figures != nullptr, "faces that were measured");
    return {*m_figures,
            m_jumps ? std::span<const float>(*m_jumps) : std::span<const float>(),
            *m_selected};
}

bool FaceListing::isStale() const
{
    return m_document.isOpen() && !m_isStopped &&
           (m_allStale || !m_touched.empty() || m_jumpsStale || m_orderStale);
}

/// Another document: nothing is known of it.
void FaceListing::forget()
{
    ++m_generation;
    if (m_job) {
        m_job->cancel();
        m_job = nullptr;
    }
    m_seams.reset();
    m_jumps.reset();
    m_touched.clear();
    m_jumpsStale = false;
    m_isStopped = false;
    m_allStale = true;
    m_orderStale = true;
    m_selected = m_selection.snapshot();
    emit aboutToRearrange(false);
    m_figures.reset();
    m_rows = std::make_shared<const FaceRows>();
    emit rearranged(false);
    goOn();
}

void FaceListing::takeChange(const Change& change)
{
    if (change.rects.empty() || m_touched.size() > kMostTouched) {
        m_allStale = true;
        m_touched.clear();
    }
    if (!m_allStale || m_job) { // a measuring under way looks at older texels
        for (const TouchedRect& rect : change.rects) {
            if (m_touched.empty() || m_touched.back() != rect.face) {
                m_touched.push_back(rect.face);
            }
        }
    }
    m_soon.start();
}

void FaceListing::takeLook()
{
    if (m_figures && channelOf(m_settings, m_figures->format()) != m_figures->channel()) {
        m_allStale = true;
        goOn();
    }
}

void FaceListing::goOn()
{
    if (!m_isWatched || m_job || !isStale()) {
        emit busyChanged();
        return;
    }
    if (m_document.hasStroke()) {
        m_soon.start();
    } else if (m_allStale) {
        measureAll();
    } else if (!m_touched.empty()) {
        measureTouched();
    } else if (m_jumpsStale) {
        gatherJumps();
    } else {
        arrange();
    }
    emit busyChanged();
}

void FaceListing::measureAll()
{
    m_allStale = false;
    m_touched.clear();
    const ChannelChoice channel = channelOf(m_settings, m_document.texels().format());
    m_job = &m_jobs.run(
        tr("Measuring the faces…"),
        [surface = m_document.surface(), texels = m_document.texels(), channel](
            Progress& progress) {
            return FaceFigures::measure(surface->mesh(), texels, channel, Threads::all(), progress)
                .map([](FaceFigures&& figures) {
                    return std::make_shared<const FaceFigures>(std::move(figures));
                });
        },
        [this, generation = m_generation](Result<Figures> figures) {
            if (generation != m_generation) {
                return;
            }
            if (!figures) {
                m_isStopped = true;
                m_allStale = true;
            } else {
                takeFigures(std::move(*figures));
            }
            ended();
        });
}

/// Only the touched faces are held on to, so that painting on need not copy the others.
void FaceListing::measureTouched()
{
    std::ranges::sort(m_touched);
    const auto rest = std::ranges::unique(m_touched);
    m_touched.erase(rest.begin(), rest.end());
    std::vector<TouchedFace> touched;
    touched.reserve(m_touched.size());
    for (const FaceId face : std::exchange(m_touched, {})) {
        touched.push_back({face, m_document.texels().face(face)});
    }
    m_job = &m_quickJobs.run(
        QString(),
        [surface = m_document.surface(), before = m_figures, touched = std::move(touched)](
            Progress& progress) -> Result<Figures> {
            auto figures = std::make_shared<FaceFigures>(*before);
            for (const auto& [face, texels] : touched) {
                if (!progress.report(0)) {
                    return cancelled();
                }
                figures->set(
                    face,
                    figureOf(surface->mesh(), face, texels, before->format(), before->channel()));
            }
            return figures;
        },
        [this, generation = m_generation](Result<Figures> figures) {
            if (generation == m_generation) {
                if (figures) {
                    takeFigures(std::move(*figures));
                }
                ended();
            }
        });
}

void FaceListing::gatherJumps()
{
    using Jumps = std::shared_ptr<const std::vector<float>>;
    m_jumpsStale = false;
    m_job = &m_quickJobs.run(
        QString(),
        [report = m_seams, faces = m_figures->faceCount()](Progress&) -> Result<Jumps> {
            return report ? std::make_shared<const std::vector<float>>(
                                jumpsOfFaces(report->jumps, faces))
                          : nullptr;
        },
        [this, generation = m_generation](Result<Jumps> jumps) {
            if (generation != m_generation) {
                return;
            }
            m_jumps = jumps ? std::move(*jumps) : nullptr;
            const bool matters = std::ranges::any_of(m_order.filter.terms, [](const auto& term) {
                return term.column == FaceColumn::Jump;
            });
            m_orderStale = m_orderStale || matters || m_order.by == FaceColumn::Jump;
            emit figuresChanged();
            ended();
        });
}

void FaceListing::arrange()
{
    m_orderStale = false;
    m_job = &m_quickJobs.run(
        QString(),
        [figures = m_figures, jumps = m_jumps, selected = m_selected, order = m_order](
            Progress& progress) {
            const FaceFacts facts{*figures,
                                  jumps ? std::span<const float>(*jumps) : std::span<const float>(),
                                  *selected};
            return arrangeFaces(facts, order, Threads::all(), progress).map([](FaceRows&& rows) {
                return std::make_shared<const FaceRows>(std::move(rows));
            });
        },
        [this, generation = m_generation](Result<Rows> rows) {
            if (generation == m_generation) {
                if (rows) {
                    takeRows(std::move(*rows));
                }
                ended();
            }
        });
}

void FaceListing::takeFigures(Figures figures)
{
    m_figures = std::move(figures);
    m_orderStale = m_orderStale || m_order.asksForTexels();
    emit figuresChanged();
}

void FaceListing::takeRows(Rows rows)
{
    // The same faces in another order keep what views know of their rows.
    const bool same =
        rows->size() == m_rows->size() && (rows->size() == m_figures->faceCount() ||
                                           std::ranges::equal(rows->faces(), m_rows->faces()));
    emit aboutToRearrange(same);
    m_rows = std::move(rows);
    emit rearranged(same);
}

void FaceListing::ended()
{
    m_job = nullptr;
    goOn();
}

} // namespace trixel::ui
