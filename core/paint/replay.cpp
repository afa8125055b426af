// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/paint/paint_surface.h"
#include "core/paint/stroke_file.h"

#include <algorithm>

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

} // namespace

Status replayStrokes(std::span<const RecordedStroke> strokes,
                     const std::shared_ptr<const Surface>& surface,
                     std::span<const std::byte> fill,
                     TexelStore& store,
                     Threads threads,
                     Progress& progress,
                     CreaseAngle creases)
{
    for (std::size_t k = 0; k < strokes.size(); ++k) {
        if (const Status valid = validate(strokes[k].brush); !valid) {
            return prefixed("stroke " + std::to_string(k + 1) + ", brush", valid.error());
        }
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
    TexelStore painted = store; // cheap; cancelling leaves the store as it was
    StageProgress painting(progress, limit ? 0.5 : 0.0, 1.0);
    ReplayProgress watched(strokes, painting);
    for (const RecordedStroke& recorded : strokes) {
        Stroke stroke(surface,
                      recorded.brush,
                      {fill.begin(), fill.end()},
                      threads,
                      recorded.onLimit ? limit : nullptr);
        for (const StrokeSample& sample : recorded.samples) {
            if (!watched.step()) {
                return cancelled();
            }
            stroke.add(sample, painted);
        }
    }
    store = std::move(painted);
    return {};
}

} // namespace trixel
