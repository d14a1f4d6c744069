// SPDX-License-Identifier: GPL-3.0-or-later
// The model of the table and its filter.
#include "parameterbench.h"
#include "support/windowtests.h"

#include <QAbstractItemModelTester>
#include <QSignalSpy>

using namespace mb;
using namespace mb::test;

class TestParameterModel : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void modelHoldsThroughEditsFaultsAndSnapshots();
    void snapshotsNeverResetTheModel();
    void statesHaveAWordEach();
    void countersCannotBeEdited();
    void filterWantsAllWords();
    void filterKeepsTheRowThatIsBeingEdited();
};

void TestParameterModel::modelHoldsThroughEditsFaultsAndSnapshots()
{
    StagedEdits edits(dmc60c());
    auto entries = *readDrive().parameters;
    edits.setEntries(entries);
    ParameterModel model;
    QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::Fatal);
    model.show(&dmc60c(), &edits, true);
    QCOMPARE(model.rowCount(), 9);
    const QModelIndex fault = model.indexOf(named("slot1.max_forward"), 0);
    QVERIFY(!model.hasChildren(fault));
    edits.stage(named("slot1.max_forward"), QStringLiteral("40000"));
    QCOMPARE(model.rowCount(fault), 1);
    QVERIFY(model.index(0, 0, fault).data().toString().contains(QStringLiteral("above 32767")));
    QVERIFY(model.index(0, 0, fault).parent() == fault);
    entries[named("slot1.p").value] = {rawOf("slot1.p", 3), ParameterState::Ram};
    edits.setEntries(entries);
    model.refresh();
    QCOMPARE(model.indexOf(named("slot1.p")).data().toString(), QStringLiteral("3.000"));
    edits.stage(named("slot1.max_forward"), QStringLiteral("3"));
    QCOMPARE(model.rowCount(fault), 0);
    QVERIFY(model.setData(model.indexOf(named("slot1.i")), QStringLiteral("0,5")));
    QVERIFY(!model.setData(model.indexOf(named("faults.active")), QStringLiteral("1")));
    model.setReference({QStringLiteral("file"), {}});
    model.show(nullptr, nullptr, false);
    QCOMPARE(model.rowCount(), 0);
}

void TestParameterModel::snapshotsNeverResetTheModel()
{
    ParameterBench bench;
    QSignalSpy resets(&bench.model(), &QAbstractItemModel::modelReset);
    QSignalSpy changes(&bench.model(), &QAbstractItemModel::dataChanged);
    bench.workbench.publish();
    QCOMPARE(changes.count(), 0);
    bench.set("slot1.p", 3, ParameterState::Ram);
    QCOMPARE(resets.count(), 0);
    QCOMPARE(changes.count(), 1);
}

void TestParameterModel::statesHaveAWordEach()
{
    ParameterBench bench;
    const auto word = [&bench] { return bench.shown("slot1.p", ParameterModel::State); };
    QCOMPARE(word(), QStringLiteral("stored"));
    bench.set("slot1.p", 1, ParameterState::Ram);
    QCOMPARE(word(), QStringLiteral("RAM, not in flash"));
    bench.set("slot1.p", 1, ParameterState::Assumed);
    QCOMPARE(word(), QStringLiteral("assumed"));
    bench.set("slot1.p", 1, ParameterState::Failed);
    QCOMPARE(word(), QStringLiteral("no answer, retry"));
    QCOMPARE(bench.shown("slot1.p", ParameterModel::ValueColumn), QStringLiteral("–"));
    bench.stage("slot1.p", "7");
    QCOMPARE(word(), QStringLiteral("edited, was unknown"));
    bench.stage("slot1.max_forward", "500");
    QCOMPARE(bench.shown("slot1.max_forward", ParameterModel::State), QStringLiteral("edited, was 32767"));
    QCOMPARE(bench.shown("slot1.max_forward", ParameterModel::Raw), QStringLiteral("0x1F4"));
    bench.stage("slot1.max_forward", "50000");
    QCOMPARE(bench.shown("slot1.max_forward", ParameterModel::State), QStringLiteral("out of range"));
    QCOMPARE(bench.shown("slot1.max_forward", ParameterModel::Raw), QStringLiteral("–"));
    QCOMPARE(bench.shown("status.general.period", ParameterModel::State), QStringLiteral("volatile"));
    QCOMPARE(bench.shown("slot1.max_reverse", ParameterModel::ValueColumn), QStringLiteral("−32768"));
    QCOMPARE(bench.shown("slot1.max_reverse", ParameterModel::Raw), QStringLiteral("0xFFFF8000"));
}

void TestParameterModel::countersCannotBeEdited()
{
    ParameterBench bench;
    QVERIFY((bench.model().indexOf(named("faults.sticky")).flags() & Qt::ItemIsEditable) == 0);
    QVERIFY((bench.model().indexOf(named("faults.active")).flags() & Qt::ItemIsEditable) == 0);
    QVERIFY((bench.model().indexOf(named("slot0.p")).flags() & Qt::ItemIsEditable) != 0);
}

void TestParameterModel::filterWantsAllWords()
{
    ParameterBench bench;
    ParameterFilter filter;
    filter.words = QStringLiteral("slot1 MAX");
    bench.view().setFilter(filter);
    QCOMPARE(bench.view().shownRows(), 2);
    filter.words = QStringLiteral("friction"); // only the help says so
    bench.view().setFilter(filter);
    QCOMPARE(bench.view().shownRows(), 2);
    filter.words = QStringLiteral("friction nowhere");
    bench.view().setFilter(filter);
    QCOMPARE(bench.view().shownRows(), 0);
    filter = {};
    filter.segment = ParameterFilter::Changed;
    bench.set("slot0.p", 4, ParameterState::Stored);
    bench.view().setFilter(filter);
    QCOMPARE(bench.view().shownRows(), 1);
    filter.segment = ParameterFilter::Errors;
    bench.stage("slot0.max_forward", "99999");
    bench.set("slot0.i", 0, ParameterState::Failed);
    bench.view().setFilter(filter);
    QCOMPARE(bench.view().shownRows(), 2);
}

void TestParameterModel::filterKeepsTheRowThatIsBeingEdited()
{
    ParameterBench bench;
    ParameterFilter filter;
    filter.segment = ParameterFilter::Errors;
    bench.stage("slot0.max_forward", "99999");
    bench.view().setFilter(filter);
    bench.edits().type(named("slot0.max_forward"), QStringLiteral("9"));
    QCOMPARE(bench.view().shownRows(), 1);
    bench.edits().endTyping(true);
    QCOMPARE(bench.view().shownRows(), 0);
}

MB_WINDOW_TEST(TestParameterModel);
#include "tst_parametermodel.moc"
