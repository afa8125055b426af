// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/look/value_survey.h"

#include "ui/document/document.h"
#include "ui/look/look_words.h"
#include "ui/viewport/view_settings.h"

#include <algorithm>
#include <utility>

namespace trixel::ui {

ValueSurvey::ValueSurvey(const Document& document, const ViewSettings& settings, QObject* parent)
    : QObject(parent)
    , m_document(document)
    , m_settings(settings)
{
    m_pause.setSingleShot(true);
    m_pause.setInterval(kPauseMs);
    connect(&m_pause, &QTimer::timeout, this, &ValueSurvey::begin);
    connect(&document, &Document::opened, this, &ValueSurvey::forget);
    connect(&document, &Document::changed, this, &ValueSurvey::outdate);
    connect(&settings, &ViewSettings::lookChanged, this, &ValueSurvey::takeLook);
}

ValueSurvey::~ValueSurvey()
{
    cancel();
}

void ValueSurvey::setWanted(bool wanted)
{
    if (std::exchange(m_isWanted, wanted) == wanted) {
        return;
    }
    if (!wanted) {
        m_pause.stop();
        cancel();
    } else if (!m_isCurrent || !missing().empty()) {
        begin();
    }
}

std::shared_ptr<const ValueHistogram> ValueSurvey::histogram(const TexelNumber& number) const
{
    const auto found = std::ranges::find(m_answers, number, &Answer::number);
    return found == m_answers.end() ? nullptr : found->histogram;
}

double ValueSurvey::fraction() const
{
    return m_job != nullptr ? m_job->fraction() : 1;
}

/// Another document.
void ValueSurvey::forget()
{
    cancel();
    m_answers.clear();
    m_isCurrent = false;
    emit changed();
    if (m_isWanted) {
        begin();
    }
}

void ValueSurvey::outdate()
{
    const bool wasCurrent = std::exchange(m_isCurrent, false);
    cancel();
    if (m_isWanted) {
        m_pause.start();
    }
    if (wasCurrent) {
        emit changed();
    }
}

void ValueSurvey::takeLook()
{
    if (m_isWanted && m_document.isOpen() && m_isCurrent && !missing().empty()) {
        cancel();
        begin();
    }
}

/// Numbers that the look shows and nothing is known of.
std::vector<TexelNumber> ValueSurvey::missing() const
{
    std::vector<TexelNumber> numbers;
    if (!m_document.isOpen()) {
        return numbers;
    }
    const TexelFormat& format = m_document.texels().format();
    for (const auto& wanted :
         {numbersShown(format, m_settings.look()), numbersMarked(format, m_settings.look())}) {
        for (const TexelNumber& number : wanted) {
            if (histogram(number) == nullptr &&
                std::ranges::find(numbers, number) == numbers.end()) {
                numbers.push_back(number);
            }
        }
    }
    return numbers;
}

void ValueSurvey::cancel()
{
    ++m_generation;
    if (m_job != nullptr) {
        std::exchange(m_job, nullptr)->cancel();
    }
}

void ValueSurvey::begin()
{
    m_pause.stop();
    cancel();
    if (!m_document.isOpen()) {
        return;
    }
    // What is known of the present texels stays; what was of those before is counted again.
    std::vector<TexelNumber> numbers = missing();
    if (!m_isCurrent) {
        const std::vector<Answer> before = std::exchange(m_answers, {});
        numbers = missing();
        m_answers = before; // shown until there are others
    }
    m_job = &m_jobs.run(
        QString(),
        [store = m_document.texels(), numbers](Progress& progress) {
            return countValues(store, numbers, Threads::all(), progress);
        },
        [this, numbers, generation = m_generation](Result<std::vector<ValueHistogram>> histograms) {
            if (generation != m_generation) {
                return;
            }
            m_job = nullptr;
            if (!histograms) {
                return; // for want of memory: what was known stays
            }
            if (!m_isCurrent) {
                m_answers.clear();
            }
            for (std::size_t k = 0; k < numbers.size(); ++k) {
                m_answers.push_back(
                    {numbers[k],
                     std::make_shared<const ValueHistogram>(std::move((*histograms)[k]))});
            }
            m_isCurrent = true;
            emit changed();
            takeLook(); // which may have become another meanwhile
        });
    connect(m_job, &BackgroundJob::progressed, this, &ValueSurvey::progressed);
}

} // namespace trixel::ui
