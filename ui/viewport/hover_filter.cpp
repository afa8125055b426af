// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/hover_filter.h"

#include "core/study/views/view_map.h"
#include "ui/document/document.h"
#include "ui/document/filter_scene_source.h"
#include "ui/document/run_within_memory.h"
#include "ui/viewport/view_settings.h"

#include <utility>

namespace trixel::ui {

HoverFilter::HoverFilter(const Document& document,
                         ViewSettings& settings,
                         FilterSceneSource& source,
                         QObject* parent)
    : QObject(parent)
    , m_document(document)
    , m_settings(settings)
    , m_source(source)
{
    const auto askAgain = [this] {
        m_isAsked = m_question.has_value();
        start();
    };
    connect(&settings, &ViewSettings::methodChanged, this, askAgain);
    connect(&source, &FilterSceneSource::changed, this, askAgain);
    connect(&document, &Document::opened, this, [this] {
        ++m_generation;
        m_hasDecided = false;
        m_question.reset();
        m_isAsked = false;
        m_watcher.cancel();
        m_source.want(*this, false);
    });
    connect(&m_watcher, &QFutureWatcherBase::resultReadyAt, this, [this](int index) {
        if (!m_watcher.isCanceled()) {
            emit answered(m_watcher.resultAt(index));
        }
    });
    connect(&m_watcher, &QFutureWatcherBase::finished, this, &HoverFilter::start);
}

HoverFilter::~HoverFilter()
{
    m_watcher.disconnect(this);
    m_watcher.cancel();
    m_watcher.waitForFinished();
}

void HoverFilter::ask(const std::optional<HoveredTexel>& texel)
{
    if (!texel || !texel->pixelQuery || !m_document.isOpen()) {
        return;
    }
    m_question = texel->pixelQuery;
    m_isAsked = true;
    if (!std::exchange(m_hasDecided, true)) {
        decide();
    }
    if (!m_source.isCurrent()) {
        emit unanswered({}); // until the scene is there
    }
    start();
}

/// A large document is not filtered just because the pointer is over it; once a map or the seams
/// have had it prepared, its pixels are answered, too.
void HoverFilter::decide()
{
    m_jobs.run(
        QString(),
        [store = m_document.texels()](Progress& /*progress*/) -> Result<std::uint64_t> {
            return FilterSceneSource::expectedBytes(store);
        },
        [this, generation = m_generation](const Result<std::uint64_t>& bytes) {
            if (generation != m_generation || !bytes) {
                return;
            }
            if (*bytes <= kMostBytes) {
                m_source.want(*this, true);
            } else if (!m_source.scene()) {
                emit unanswered(tr("%1 MB of texels are prepared for filters when a map or the "
                                   "seams need them")
                                    .arg(*bytes >> 20U));
            }
        });
}

void HoverFilter::start()
{
    if (!m_isAsked || m_watcher.isRunning() || !m_source.isCurrent()) {
        return;
    }
    m_isAsked = false;
    m_watcher.setFuture(
        runWithinMemory<FilteredTexel>([scene = m_source.scene(),
                                        method = m_settings.method(),
                                        range = m_source.valueRange(),
                                        question = *m_question](QPromise<FilteredTexel>& promise) {
            compute(promise, scene, method, range, question);
        }));
}

void HoverFilter::compute(QPromise<FilteredTexel>& promise,
                          const std::shared_ptr<const FilterScene>& scene,
                          const MethodChoice& method,
                          double range,
                          const PixelQuery& question)
{
    QueryArrays queries;
    queries.add(question.face, question.uv, question.footprint.w1, question.footprint.w2);
    ResultArrays own(1, scene->channels());
    makeMethod(method)->filter(*scene, queries.queries(), own.results());
    FilteredTexel answer;
    answer.method = method;
    answer.values = own.values;
    answer.level = own.levels.front();
    answer.taps = own.taps.front();
    promise.addResult(answer);
    if (promise.isCanceled()) {
        return;
    }
    ResultArrays exact(1, scene->channels());
    makeMethod({std::string(kExactMethod), std::nullopt})
        ->filter(*scene, queries.queries(), exact.results());
    answer.exact = exact.values;
    answer.exactTaps = exact.taps.front();
    answer.difference = double{differenceOf(own.values, exact.values, range)};
    promise.addResult(answer);
}

} // namespace trixel::ui
