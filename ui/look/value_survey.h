// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTimer>

#include "core/texture/value_histogram.h"
#include "ui/document/background_job.h"

#include <memory>
#include <vector>

namespace trixel::ui {

class Document;
class ViewSettings;

/// How often each value occurs in the document's texels: counted in the background for the numbers
/// that the look shows, while somebody wants to know, and again when texels have changed and hold
/// still.
class ValueSurvey : public QObject
{
    Q_OBJECT

public:
    /// Texels that change are left alone: counting begins when they hold still for so long.
    static constexpr int kPauseMs = 250;

    ValueSurvey(const Document& document, const ViewSettings& settings, QObject* parent = nullptr);
    ~ValueSurvey() override;

    /// Counts as long as it is wanted. Nobody does at first.
    void setWanted(bool wanted);

    /// The last answer about a number, of the present texels or of those before; null while there
    /// is none.
    std::shared_ptr<const ValueHistogram> histogram(const TexelNumber& number) const;
    /// Whether answers are about the texels as they are now.
    bool isCurrent() const { return m_isCurrent; }
    /// How far the counting is, in [0, 1]; 1 when nothing is counted.
    double fraction() const;

signals:
    /// There are other answers, or they are no longer current.
    void changed();
    void progressed();

private:
    struct Answer
    {
        TexelNumber number;
        std::shared_ptr<const ValueHistogram> histogram;
    };

    void forget();
    void outdate();
    void takeLook();
    void begin();
    void cancel();
    std::vector<TexelNumber> missing() const;

    const Document& m_document;
    const ViewSettings& m_settings;
    BackgroundJobs m_jobs;
    BackgroundJob* m_job = nullptr; ///< that counts now
    QTimer m_pause;
    std::vector<Answer> m_answers;
    bool m_isWanted = false;
    bool m_isCurrent = false;
    quint64 m_generation = 0;
};

} // namespace trixel::ui
