// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inspector/footprint_answers.h"

#include <QElapsedTimer>

#include "ui/document/document.h"
#include "ui/document/filter_scene_source.h"
#include "ui/document/released_elsewhere.h"
#include "ui/document/run_within_memory.h"
#include "ui/viewport/hover_filter.h"
#include "ui/viewport/view_settings.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace trixel::ui {

namespace {

/// One query takes less than clocks and caches tell apart: it is asked a few times.
constexpr int kMostGoes = 32;
constexpr qint64 kTimingNs = 1'000'000;

const MethodChoice kExact{"exact", std::nullopt};

class PromiseProgress final : public Progress
{
public:
    explicit PromiseProgress(const QPromise<FootprintAnswer>& promise)
        : m_promise(promise)
    {
    }
    bool report(double) override { return !m_promise.isCanceled(); }

private:
    const QPromise<FootprintAnswer>& m_promise;
};

QueryArrays queryOf(const PlacedFootprint& footprint)
{
    QueryArrays query;
    query.add(footprint.face,
              glm::vec2(footprint.uv),
              glm::vec2(footprint.footprint.w1),
              glm::vec2(footprint.footprint.w2));
    return query;
}

MethodAnswer
answerOf(const FilterMethod& method, const FilterScene& scene, const PlacedFootprint& footprint)
{
    const QueryArrays query = queryOf(footprint);
    ResultArrays results(1, scene.channels());
    qint64 quickest = -1;
    QElapsedTimer whole;
    whole.start();
    for (int go = 0; go < kMostGoes && (go == 0 || whole.nsecsElapsed() < kTimingNs); ++go) {
        QElapsedTimer clock;
        clock.start();
        method.filter(scene, query.queries(), results.results());
        const qint64 taken = clock.nsecsElapsed();
        quickest = quickest < 0 ? taken : std::min(quickest, taken);
    }
    return {results.values,
            results.levels.front(),
            results.taps.front(),
            static_cast<double>(quickest) / 1e3};
}

double largestDifference(const MethodAnswer& a, const MethodAnswer& b)
{
    double largest = 0;
    for (std::size_t c = 0; c < a.values.size(); ++c) {
        largest = std::max(largest, std::abs(double{a.values[c]} - double{b.values[c]}));
    }
    return largest;
}

} // namespace

FootprintAnswers::FootprintAnswers(const Document& document,
                                   ViewSettings& settings,
                                   FilterSceneSource& source,
                                   QObject* parent)
    : QObject(parent)
    , m_document(document)
    , m_settings(settings)
    , m_source(source)
    , m_bench(releasedElsewhere(std::make_unique<Bench>()))
{
    connect(&settings, &ViewSettings::methodChanged, this, &FootprintAnswers::askAgain);
    connect(&source, &FilterSceneSource::changed, this, &FootprintAnswers::askAgain);
    connect(&document, &Document::opened, this, [this] {
        ++m_generation;
        m_hasDecided = false;
        ask(std::nullopt);
    });
    connect(&m_watcher, &QFutureWatcherBase::resultReadyAt, this, [this](int index) {
        // A newer question does not make what is known of this one wrong: while the pointer moves
        // on, something is shown.
        m_answer = m_watcher.resultAt(index);
        m_reason.clear();
        emit changed();
    });
    connect(&m_watcher, &QFutureWatcherBase::finished, this, &FootprintAnswers::start);
}

FootprintAnswers::~FootprintAnswers()
{
    m_watcher.disconnect(this);
    m_watcher.cancel();
    m_watcher.waitForFinished();
}

void FootprintAnswers::wantWeights(bool wanted, bool ofExact)
{
    const bool more = wanted && (!m_wantsWeights || m_wantsExactWeights != ofExact);
    m_wantsWeights = wanted;
    m_wantsExactWeights = ofExact;
    if (more) {
        askAgain();
    }
}

void FootprintAnswers::ask(const std::optional<PlacedFootprint>& footprint)
{
    m_question = footprint;
    if (!footprint || !m_document.isOpen()) {
        m_isAsked = false;
        m_watcher.cancel();
        m_answer.reset();
        m_reason.clear();
        m_source.want(*this, false);
        m_bench = releasedElsewhere(std::make_unique<Bench>()); // which keeps a scene
        m_hasDecided = false;
        emit changed();
        return;
    }
    if (!std::exchange(m_hasDecided, true)) {
        decide();
    }
    askAgain();
}

void FootprintAnswers::askAgain()
{
    m_isAsked = m_question.has_value();
    if (m_isAsked && m_watcher.isRunning()) {
        m_watcher.cancel(); // `finished` begins the next
    }
    start();
}

/// As `HoverFilter` does: a large document is not filtered just because someone looks at it.
void FootprintAnswers::decide()
{
    m_jobs.run(
        QString(),
        [store = m_document.texels()](Progress& /*progress*/) -> Result<std::uint64_t> {
            return FilterSceneSource::expectedBytes(store);
        },
        [this, generation = m_generation](const Result<std::uint64_t>& bytes) {
            if (generation != m_generation || !bytes || !m_question) {
                return;
            }
            if (*bytes <= HoverFilter::kMostBytes) {
                m_source.want(*this, true);
            } else if (!m_source.scene()) {
                m_reason = tr("%1 MB of texels are prepared for filters when a map or the seams "
                              "need them.")
                               .arg(*bytes >> 20U);
                emit changed();
            }
        });
}

void FootprintAnswers::start()
{
    if (!m_isAsked || m_watcher.isRunning() || !m_source.isCurrent()) {
        return;
    }
    m_isAsked = false;
    const Question question{*m_question,
                            m_settings.method(),
                            m_source.valueRange(),
                            m_wantsWeights,
                            m_wantsExactWeights};
    m_watcher.setFuture(runWithinMemory<FootprintAnswer>(
        [scene = m_source.scene(), bench = m_bench, question](QPromise<FootprintAnswer>& promise) {
            compute(promise, scene, bench, question);
        }));
}

void FootprintAnswers::compute(QPromise<FootprintAnswer>& promise,
                               const std::shared_ptr<const FilterScene>& scene,
                               const std::shared_ptr<Bench>& bench,
                               const Question& question)
{
    FootprintAnswer answer;
    answer.asked = question.footprint;
    answer.method = question.method;
    answer.weightsAreExact = question.exactWeights;
    answer.own = answerOf(*makeMethod(question.method), *scene, question.footprint);
    promise.addResult(answer);
    if (promise.isCanceled()) {
        return;
    }
    answer.exact = answerOf(*makeMethod(kExact), *scene, question.footprint);
    answer.difference = largestDifference(answer.own, answer.exact);
    answer.differenceShare = question.range > 0 ? answer.difference / question.range : 0;
    promise.addResult(answer);
    if (question.weights && !promise.isCanceled()) {
        weigh(promise, scene, *bench, question, answer);
    }
}

void FootprintAnswers::weigh(QPromise<FootprintAnswer>& promise,
                             const std::shared_ptr<const FilterScene>& scene,
                             Bench& bench,
                             const Question& question,
                             FootprintAnswer& answer)
{
    PromiseProgress progress(promise);
    if (bench.scene != scene) { // painted on, or with other levels
        if (bench.meter && !bench.meter->fits(*scene)) {
            bench.meter.reset();
        }
        bench.scene = scene;
    }
    if (!bench.meter) {
        auto made = ContributionMeter::build(scene, Threads{1}, progress);
        if (!made) {
            bench.scene.reset();
            return;
        }
        bench.meter = std::move(*made);
    }
    const auto method = makeMethod(question.exactWeights ? kExact : question.method);
    auto weights =
        bench.meter->measure(*method, queryOf(question.footprint).queries(), {}, progress);
    if (weights) {
        answer.weights = std::move(*weights);
    } else if (weights.error().kind != ErrorKind::Cancelled) {
        answer.noWeights = QString::fromStdString(weights.error().message);
    } else {
        return;
    }
    promise.addResult(answer);
}

} // namespace trixel::ui
