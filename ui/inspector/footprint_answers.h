// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFutureWatcher>
#include <QObject>

#include "core/filter/contributions.h"
#include "core/filter/footprint_net.h"
#include "ui/document/background_job.h"

#include <memory>
#include <optional>
#include <vector>

namespace trixel::ui {

class Document;
class FilterSceneSource;
class ViewSettings;

/// What one method makes of a footprint.
struct MethodAnswer
{
    std::vector<float> values; ///< one a channel; empty until it is known
    float level = 0;           ///< that was read
    std::uint32_t taps = 0;    ///< kRefusedTaps where it refuses the footprint
    double microseconds = 0;   ///< the quickest of a few goes

    bool isKnown() const { return !values.empty(); }
    bool isRefused() const { return taps == kRefusedTaps; }
};

/// What filters make of a footprint, as far as it is known.
struct FootprintAnswer
{
    PlacedFootprint asked;
    MethodChoice method;
    MethodAnswer own;
    MethodAnswer exact;
    double difference = 0;      ///< largest of a channel; once both are known
    double differenceShare = 0; ///< the same in parts of the value range
    std::optional<Contributions> weights;
    bool weightsAreExact = false; ///< those of `exact`, not of the method
    QString noWeights;            ///< why there are none; empty while they may come
};

/// Asks the filters about a footprint in the background: the chosen method first, then the exact
/// answer, then the weights of the texels. The newest question counts.
class FootprintAnswers : public QObject
{
    Q_OBJECT

public:
    FootprintAnswers(const Document& document,
                     ViewSettings& settings,
                     FilterSceneSource& source,
                     QObject* parent = nullptr);
    ~FootprintAnswers() override;

    /// Whether weights are looked for, and whose.
    void wantWeights(bool wanted, bool ofExact);

    /// Nothing ends the asking and gives the scene back.
    void ask(const std::optional<PlacedFootprint>& footprint);

    /// Of the newest question, or of the one before while that has no answer yet.
    const std::optional<FootprintAnswer>& answer() const { return m_answer; }
    /// Why there is none: a sentence, or empty.
    const QString& reason() const { return m_reason; }
    /// Whether more is to come.
    bool isBusy() const { return m_isAsked || m_watcher.isRunning(); }

signals:
    /// Another answer, more of it, or none.
    void changed();

private:
    struct Question
    {
        PlacedFootprint footprint;
        MethodChoice method;
        double range = 0;
        bool weights = false;
        bool exactWeights = false;
    };
    /// What only the work in the background uses, one at a time.
    struct Bench
    {
        std::shared_ptr<const FilterScene> scene; ///< that the meter was last seen to fit
        std::optional<ContributionMeter> meter;
    };

    void askAgain();
    void decide();
    void start();
    static void compute(QPromise<FootprintAnswer>& promise,
                        const std::shared_ptr<const FilterScene>& scene,
                        const std::shared_ptr<Bench>& bench,
                        const Question& question);
    static void weigh(QPromise<FootprintAnswer>& promise,
                      const std::shared_ptr<const FilterScene>& scene,
                      Bench& bench,
                      const Question& question,
                      FootprintAnswer& answer);

    const Document& m_document;
    ViewSettings& m_settings;
    FilterSceneSource& m_source;
    BackgroundJobs m_jobs;
    QFutureWatcher<FootprintAnswer> m_watcher;
    std::shared_ptr<Bench> m_bench;
    std::optional<PlacedFootprint> m_question; ///< the newest
    std::optional<FootprintAnswer> m_answer;
    QString m_reason;
    bool m_isAsked = false; ///< it has not been begun
    bool m_wantsWeights = false;
    bool m_wantsExactWeights = false;
    bool m_hasDecided = false; ///< whether the scene may be built for this
    quint64 m_generation = 0;
};

} // namespace trixel::ui
