// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFutureWatcher>
#include <QObject>

#include "core/filter/filter_method.h"
#include "ui/document/background_job.h"
#include "ui/viewport/hovered_texel.h"

#include <memory>
#include <optional>
#include <vector>

namespace trixel::ui {

class Document;
class FilterSceneSource;
class ViewSettings;

/// What the pixel under the pointer comes to: by the chosen filter method, and by the exact answer
/// as soon as that is there.
struct FilteredTexel
{
    MethodChoice method;
    std::vector<float> values; ///< one a channel
    float level = 0;           ///< that was read
    std::uint32_t taps = 0;    ///< kRefusedTaps where the method refuses the footprint
    std::vector<float> exact;  ///< empty until it is known
    std::uint32_t exactTaps = 0;
    double difference =
        0; ///< largest channel's, in parts of the value range; once `exact` is there
};

/// Filters the pixel under the pointer in the background; the newest question counts.
class HoverFilter : public QObject
{
    Q_OBJECT

public:
    /// What the scene may take in memory to be built for this alone.
    static constexpr std::uint64_t kMostBytes = 512U << 20U;

    HoverFilter(const Document& document,
                ViewSettings& settings,
                FilterSceneSource& source,
                QObject* parent = nullptr);
    ~HoverFilter() override;

    /// Nothing under the pointer keeps the last answer.
    void ask(const std::optional<HoveredTexel>& texel);

signals:
    /// Twice for a question: without the exact answer, then with it.
    void answered(const trixel::ui::FilteredTexel& texel);
    /// There is no answer for what is under the pointer: a sentence says why, or it is empty
    /// because the answer may come.
    void unanswered(const QString& sentence);

private:
    void decide();
    void start();
    static void compute(QPromise<FilteredTexel>& promise,
                        const std::shared_ptr<const FilterScene>& scene,
                        const MethodChoice& method,
                        double range,
                        const PixelQuery& question);

    const Document& m_document;
    ViewSettings& m_settings;
    FilterSceneSource& m_source;
    BackgroundJobs m_jobs;
    QFutureWatcher<FilteredTexel> m_watcher;
    std::optional<PixelQuery> m_question; ///< the newest
    bool m_isAsked = false;               ///< it has not been begun
    bool m_hasDecided = false;            ///< whether the scene may be built for this
    quint64 m_generation = 0;
};

} // namespace trixel::ui
