// SPDX-License-Identifier: GPL-3.0-or-later
#include <QSignalSpy>
#include <QTest>

#include "tests/ui/look/look_fixture.h"
#include "ui/document/document.h"
#include "ui/look/look_words.h"
#include "ui/look/value_survey.h"
#include "ui/viewport/view_settings.h"

#include <array>

namespace trixel::ui {

class ValueSurveyTest : public QObject
{
    Q_OBJECT

private slots:
    void init()
    {
        m_document = std::make_unique<Document>();
        m_settings = std::make_unique<ViewSettings>();
        m_survey = std::make_unique<ValueSurvey>(*m_document, *m_settings);
    }

    void cleanup()
    {
        m_survey.reset();
        m_settings.reset();
        m_document.reset();
    }

    void countsNothingUntilItIsWanted()
    {
        m_document->open(wildProject(), {}, "wild");
        QTest::qWait(50);
        QVERIFY(!m_survey->isCurrent());
        m_survey->setWanted(true);
        QTRY_VERIFY(m_survey->isCurrent());
        QCOMPARE(histogram(0)->summary().total, std::uint64_t{512});
        QCOMPARE(histogram(0)->summary().notANumber, std::uint64_t{1});
        QVERIFY(histogram(3));
    }

    void countsAgainWhenTexelsHoldStill()
    {
        openWanted();
        const auto before = histogram(0);
        m_document->fillFaces(std::array{FaceId{0}}, {3, 0, 0, 1});
        QVERIFY(!m_survey->isCurrent());
        QCOMPARE(histogram(0), before); // until there is another
        QTRY_VERIFY(m_survey->isCurrent());
        QCOMPARE(histogram(0)->summary().greatest, 3.0F);
        m_document->undoStack().undo();
        QTRY_VERIFY(m_survey->isCurrent());
        QCOMPARE(histogram(0)->summary().greatest, before->summary().greatest);
    }

    void leavesChangesAloneWhileNobodyWantsToKnow()
    {
        openWanted();
        m_survey->setWanted(false);
        m_document->fillFaces(std::array{FaceId{0}}, {3, 0, 0, 1});
        QTest::qWait(ValueSurvey::kPauseMs + 100);
        QVERIFY(!m_survey->isCurrent());
        m_survey->setWanted(true);
        QTRY_VERIFY(m_survey->isCurrent());
        QCOMPARE(histogram(0)->summary().greatest, 3.0F);
    }

    void countsWhatALookShowsForTheFirstTime()
    {
        openWanted();
        const TexelNumber luminance{0, render::kLuminanceWeights};
        QVERIFY(!m_survey->histogram(luminance));
        const auto red = histogram(0);
        render::Look look;
        look.luminance = true;
        m_settings->setLook(look);
        QTRY_VERIFY(m_survey->histogram(luminance));
        QCOMPARE(histogram(0), red); // not counted again
    }

    void forgetsTheDocumentBefore()
    {
        openWanted();
        m_document->open(gridProject(), {}, "grid");
        QVERIFY(!m_survey->isCurrent());
        QTRY_VERIFY(m_survey->isCurrent());
        QCOMPARE(histogram(0)->summary().total, std::uint64_t{128 * 64});
        QVERIFY(!histogram(3));
    }

    void diesWhileItCounts()
    {
        m_document->open(wildProject(40), {}, "large");
        m_survey->setWanted(true);
        m_survey.reset();
    }

private:
    void openWanted()
    {
        m_document->open(wildProject(), {}, "wild");
        m_survey->setWanted(true);
        QTRY_VERIFY(m_survey->isCurrent());
    }
    std::shared_ptr<const ValueHistogram> histogram(std::uint16_t channel) const
    {
        return m_survey->histogram({channel, {}});
    }

    std::unique_ptr<Document> m_document;
    std::unique_ptr<ViewSettings> m_settings;
    std::unique_ptr<ValueSurvey> m_survey;
};

} // namespace trixel::ui

QTEST_MAIN(trixel::ui::ValueSurveyTest)
#include "tst_value_survey.moc"
