// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/paint/paint_surface.h"
#include "core/paint/stroke_file.h"

#include <algorithm>
#include <set>
#include <utility>

namespace trixel {

namespace {

constexpr std::size_t kSamplesPerReport = 64;

class ReplayProgress
{
public:
    ReplayProgress(std::span<const RecordedStroke> strokes, Progress& progress)
        : m_progress(progress)
    {
        for (const RecordedStroke& stroke : strokes) {
            m_total += stroke.samples.size();
        }
    }

    /// One more sample; false when the work is to stop.
    bool step()
    {
        const bool due = m_done % kSamplesPerReport == 0;
        const double fraction = static_cast<double>(m_done) / static_cast<double>(m_total);
        ++m_done;
        return !due || m_progress.report(fraction);
    }

private:
    Progress& m_progress;
    std::size_t m_total = 0;
    std::size_t m_done = 0;
};

std::string countOf(std::size_t layers)
{
    switch (layers) {
    case 0:
        return "no layers";
    case 1:
        return "one layer";
    default:
        return std::to_string(layers) + " layers";
    }
}

Status checkStrokes(std::span<const RecordedStroke> strokes, const LayerStack& layers)
{
    const std::size_t count = layers.layers().size();
    for (std::size_t k = 0; k < strokes.size(); ++k) {
        const std::string stroke = "stroke " + std::to_string(k + 1);
        if (const Status valid = validate(strokes[k].brush); !valid) {
            return prefixed(stroke + ", brush", valid.error());
        }
        if (strokes[k].layer > count) {
            return contentsError(stroke + ": layer " + std::to_string(strokes[k].layer) +
                                 " is not there; the project has " + countOf(count));
        }
    }
    return {};
}

/// Paints strokes onto the layers they name, and remembers the faces they touched.
class Replay
{
public:
    Replay(std::shared_ptr<const Surface> surface,
           std::shared_ptr<const LimitMesh> limit,
           std::span<const std::byte> fill,
           Layered painted,
           Threads threads)
        : m_surface(std::move(surface))
        , m_limit(std::move(limit))
        , m_fill(fill.begin(), fill.end())
        , m_painted(std::move(painted))
        , m_threads(threads)
    {
    }

    Status paint(const RecordedStroke& recorded, ReplayProgress& progress)
    {
        Stroke stroke(m_surface,
                      recorded.brush,
                      recorded.layer == 0 ? Ground(m_fill) : Ground::layer(),
                      m_threads,
                      recorded.onLimit ? m_limit : nullptr);
        TexelStore& store = storeOf(recorded.layer);
        for (const StrokeSample& sample : recorded.samples) {
            if (!progress.step()) {
                return cancelled();
            }
            for (const TouchedRect& touched : stroke.add(sample, store)) {
                m_touched.insert(touched.face);
            }
        }
        return {};
    }

    Layered finish()
    {
        if (!m_painted.layers.isPlain()) {
            const std::vector<FaceId> faces(m_touched.begin(), m_touched.end());
            recompose(m_painted.layers, faces, m_painted.shown, m_threads);
        }
        return std::move(m_painted);
    }

private:
    TexelStore& storeOf(std::uint32_t layer)
    {
        LayerStack& layers = m_painted.layers;
        if (layers.isPlain()) {
            return m_painted.shown;
        }
        return layers.texels(layer == 0 ? kBaseLayer : layers.layers()[layer - 1].id);
    }

    std::shared_ptr<const Surface> m_surface;
    std::shared_ptr<const LimitMesh> m_limit;
    std::vector<std::byte> m_fill;
    Layered m_painted;
    Threads m_threads;
    std::set<FaceId> m_touched;
};

} // namespace

Status replayStrokes(std::span<const RecordedStroke> strokes,
                     const std::shared_ptr<const Surface>& surface,
                     std::span<const std::byte> fill,
                     Layered& painted,
                     Threads threads,
                     Progress& progress,
                     CreaseAngle creases)
{
    if (Status possible = checkStrokes(strokes, painted.layers); !possible) {
        return possible;
    }
    std::shared_ptr<const LimitMesh> limit;
    if (std::ranges::any_of(strokes, &RecordedStroke::onLimit)) {
        StageProgress preparing(progress, 0.0, 0.5);
        auto made = limitToPaintOn(*surface, creases, threads, preparing);
        if (!made) {
            return prefixed("limit surface", made.error());
        }
        limit = std::move(*made);
    }
    StageProgress painting(progress, limit ? 0.5 : 0.0, 1.0);
    ReplayProgress watched(strokes, painting);
    Replay replay(surface, limit, fill, painted, threads); // on a cheap copy: cancelling undoes all
    for (const RecordedStroke& recorded : strokes) {
        if (Status done = replay.paint(recorded, watched); !done) {
            return done;
        }
    }
    painted = replay.finish();
    return {};
}

Status replayStrokes(std::span<const RecordedStroke> strokes,
                     const std::shared_ptr<const Surface>& surface,
                     std::span<const std::byte> fill,
                     TexelStore& store,
                     Threads threads,
                     Progress& progress,
                     CreaseAngle creases)
{
    Layered painted{store, {}};
    Status done = replayStrokes(strokes, surface, fill, painted, threads, progress, creases);
    store = std::move(painted.shown);
    return done;
}

} // namespace trixel
