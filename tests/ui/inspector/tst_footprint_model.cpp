// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAbstractItemModelTester>
#include <QSignalSpy>
#include <QTest>

#include "tests/ui/fixtures.h"
#include "ui/inspector/footprint_model.h"

#include <memory>

namespace trixel::ui {

namespace {

/// A footprint on a face of a grid, and what is known of it.
struct Case
{
    Project project = gridProject(4, 2);
    ProbedFootprint probed;
    FootprintNet net;
    FootprintAnswer answer;

    explicit Case(double width)
    {
        probed.placed = {faceId(9), {0.3, 0.3}, {{width, 0}, {0, 0.5 * width}}};
        const Surface& surface = *project.surface;
        net = footprintNet(surface.mesh(), surface.adjacency(), project.texels, probed.placed);
        answer.own.values = {0.25F, 0.5F, 1.0F};
        answer.own.taps = 7;
    }

    FootprintFacts facts(bool answered = false) const
    {
        return {probed, net, answered ? &answer : nullptr, {}, TexelType::UInt8};
    }
};

} // namespace

class FootprintModelTest : public QObject
{
    Q_OBJECT

private slots:
    void modelKeepsItsPromisesWhateverIsShown()
    {
        FootprintModel model;
        const QAbstractItemModelTester tester(
            &model, QAbstractItemModelTester::FailureReportingMode::QtTest);
        const Case thin(0.1);
        const Case wide(0.7);
        for (const bool beside : {false, true}) {
            model.setFrozenBeside(beside);
            model.show(thin.facts());
            model.show(wide.facts(true));
            model.showFrozen(thin.facts());
            QCOMPARE(model.columnCount(), beside ? 3 : 2);
            model.showFrozen(wide.facts(true));
            model.setFrozenBeside(!beside);
            QCOMPARE(model.columnCount(), beside ? 2 : 3);
            model.showFrozen(std::nullopt);
            QCOMPARE(model.columnCount(), 2);
            QCOMPARE(model.rowCount(), static_cast<int>(kFootprintRows));
            model.show(std::nullopt);
        }
    }

    void everyRowHasANameATipAndWordsForScreenReaders()
    {
        FootprintModel model;
        const Case shown(0.2);
        model.show(shown.facts(true));
        for (int row = 0; row < model.rowCount(); ++row) {
            const QModelIndex name = model.index(row, FootprintModel::Name);
            const QModelIndex value = model.index(row, FootprintModel::Value);
            QVERIFY(!name.data().toString().isEmpty());
            QVERIFY(name.data(Qt::ToolTipRole).toString().size() > 10);
            QVERIFY(!value.data().toString().isEmpty());
            QVERIFY(value.data(Qt::AccessibleTextRole)
                        .toString()
                        .startsWith(name.data().toString().trimmed()));
        }
    }

    void onlyCellsWithOtherTextAreToldOf()
    {
        FootprintModel model;
        const Case shown(0.2);
        model.show(shown.facts());
        QSignalSpy changes(&model, &QAbstractItemModel::dataChanged);
        model.show(shown.facts());
        QCOMPARE(changes.count(), 0);
        model.show(shown.facts(true));
        QStringList rows;
        for (const QList<QVariant>& change : changes) {
            rows +=
                model.index(change[0].value<QModelIndex>().row(), 0).data().toString().trimmed();
        }
        QCOMPARE(rows, QStringList({"Level", "Method", "its cost"}));
    }

    void frozenNumbersStandBelowOrBesideTheLiveOnes()
    {
        FootprintModel model;
        const Case live(0.2);
        const Case frozen(0.6);
        model.show(live.facts());
        model.showFrozen(frozen.facts());
        const int row = 2 * static_cast<int>(FootprintRow::First);
        QCOMPARE(model.index(row, 1).data().toString(), model.text(FootprintRow::First));
        QCOMPARE(model.index(row + 1, 1).data().toString(), model.frozenText(FootprintRow::First));
        QVERIFY(model.index(row + 1, 1).data(FootprintModel::kFrozenRole).toBool());
        model.setFrozenBeside(true);
        QCOMPARE(model.index(static_cast<int>(FootprintRow::First), 2).data().toString(),
                 model.frozenText(FootprintRow::First));
        QVERIFY(model.text().contains("W1: " + model.text(FootprintRow::First) + " | " +
                                      model.frozenText(FootprintRow::First)));
    }
};

} // namespace trixel::ui

QTEST_GUILESS_MAIN(trixel::ui::FootprintModelTest)
#include "tst_footprint_model.moc"
