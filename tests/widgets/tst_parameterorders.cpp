// SPDX-License-Identifier: GPL-3.0-or-later
// What the page asks of the device, and what it shows of the answer.
#include "parameterbench.h"
#include "support/windowtests.h"

using namespace mb;
using namespace mb::test;

class TestParameterOrders : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void writeSendsExactlyWhatIsStaged();
    void undoTakesBackWhatIsStagedBeforeWhatWasWritten();
    void undoAfterADiscardStagesAgain();
    void writeIsRefusedWhileAnErrorIsStaged();
    void writeOfAnOpenFieldTakesItAlong();
    void aFailedWriteKeepsTheRestAndSaysWhy();
    void readBackEndsTheEditAndShowsRam();
    void storeIsOfferedAfterTheCountdown();
    void unknownValuesAreReadOnce();
    void progressOfReadingIsShown();
    void bootloaderHasNoParameters();
};

void TestParameterOrders::writeSendsExactlyWhatIsStaged()
{
    ParameterBench bench;
    bench.stage("slot1.p", "2");
    bench.stage("current_limit.peak", "80");
    bench.stage("slot1.i", "3");
    bench.edits().setIncluded(named("slot1.i"), false);
    QTest::keyClick(bench.page.get(), Qt::Key_W, Qt::ControlModifier | Qt::ShiftModifier);
    const auto calls = bench.workbench.given<orders::WriteParameters>();
    QCOMPARE(calls.size(), std::size_t{1});
    QVERIFY(calls[0].device == DeviceId{1});
    QCOMPARE(calls[0].changes.size(), std::size_t{2});
    QVERIFY(calls[0].changes[0].index == named("current_limit.peak"));
    QCOMPARE(calls[0].changes[0].raw, rawOf("current_limit.peak", 80));
    QVERIFY(calls[0].changes[1].index == named("slot1.p"));
    calls[0].finished({});
    QCOMPARE(bench.edits().count(), 1);
    QVERIFY(bench.edits().find(named("slot1.i")));
}

void TestParameterOrders::undoTakesBackWhatIsStagedBeforeWhatWasWritten()
{
    for (const bool leftComesFirst : {false, true}) {
        ParameterBench bench;
        bench.stage(leftComesFirst ? "slot1.i" : "slot0.p", leftComesFirst ? "3" : "2");
        bench.stage(leftComesFirst ? "slot0.p" : "slot1.i", leftComesFirst ? "2" : "3");
        bench.edits().setIncluded(named("slot1.i"), false);
        QTest::keyClick(bench.page.get(), Qt::Key_W, Qt::ControlModifier | Qt::ShiftModifier);
        const auto written = bench.workbench.given<orders::WriteParameters>();
        QCOMPARE(written.size(), std::size_t{1});
        bench.stage("slot1.p", "4"); // between the order and its answer
        written[0].finished({});
        QVERIFY2(!bench.edits().find(named("slot1.i"))->included, "it stays as it was chosen");
        for (const int left : {1, 0}) {
            QTest::keyClick(bench.page.get(), Qt::Key_Z, Qt::ControlModifier);
            QCOMPARE(bench.edits().count(), left);
            QVERIFY2(!bench.edits().find(named("slot0.p")), "its former value is not staged");
            QVERIFY2(bench.workbench.given<orders::UndoWrite>().empty(), "the unit keeps what was written");
        }
        QTest::keyClick(bench.page.get(), Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(bench.workbench.given<orders::UndoWrite>().size(), std::size_t{1});
    }
}

void TestParameterOrders::undoAfterADiscardStagesAgain()
{
    ParameterBench bench;
    bench.stage("slot0.p", "2");
    bench.edits().discard();
    QTest::keyClick(bench.page.get(), Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(bench.edits().count(), 1);
    QVERIFY(bench.workbench.given<orders::UndoWrite>().empty());
}

void TestParameterOrders::writeIsRefusedWhileAnErrorIsStaged()
{
    ParameterBench bench;
    bench.stage("slot1.p", "2");
    bench.stage("slot1.max_forward", "40000");
    QTest::keyClick(bench.page.get(), Qt::Key_W, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(bench.workbench.given<orders::WriteParameters>().empty());
    const auto *writing = bench.page->findChild<QAbstractButton *>(QStringLiteral("writeButton"));
    QVERIFY(!writing->isEnabled());
    QVERIFY(writing->accessibleName().contains(QStringLiteral("fix 1 value first")));
}

void TestParameterOrders::writeOfAnOpenFieldTakesItAlong()
{
    ParameterBench bench;
    open(bench, "slot1.p");
    QTest::keyClicks(field(bench), QStringLiteral("2"));
    bench.page->write();
    const auto calls = bench.workbench.given<orders::WriteParameters>();
    QCOMPARE(calls.size(), std::size_t{1});
    QCOMPARE(calls[0].changes.size(), std::size_t{1});
    QCOMPARE(calls[0].changes[0].raw, rawOf("slot1.p", 2));
}

void TestParameterOrders::aFailedWriteKeepsTheRestAndSaysWhy()
{
    ParameterBench bench;
    bench.stage("slot1.p", "2");
    bench.stage("current_limit.peak", "80");
    bench.page->write();
    bench.set("current_limit.peak", 80, ParameterState::Ram);
    bench.workbench.given<orders::WriteParameters>()[0].finished(
        fail(Fault::BadCheck, say("slot1.p was written as 2 but reads 1")));
    QCOMPARE(bench.edits().count(), 1);
    QVERIFY(bench.edits().find(named("slot1.p")));
    QVERIFY(says(bench, QStringLiteral("slot1.p was written as 2 but reads 1")));
}

void TestParameterOrders::readBackEndsTheEditAndShowsRam()
{
    ParameterBench bench;
    bench.stage("slot1.p", "2");
    bench.page->write();
    bench.set("slot1.p", 2, ParameterState::Ram);
    QCOMPARE(bench.edits().count(), 0);
    QCOMPARE(bench.shown("slot1.p", ParameterModel::State), QStringLiteral("RAM, not in flash"));
    QVERIFY(says(bench, QStringLiteral("0 → <b>2.000</b>")));
    bench.set("slot1.p", 2, ParameterState::Stored);
    QCOMPARE(bench.shown("slot1.p", ParameterModel::State), QStringLiteral("stored"));
    QVERIFY(!says(bench, QStringLiteral("0 → <b>2.000</b>")));
}

void TestParameterOrders::storeIsOfferedAfterTheCountdown()
{
    ParameterBench bench;
    bench.set("slot1.p", 2, ParameterState::Ram);
    QVERIFY(says(bench, QStringLiteral("15 s to go")));
    QVERIFY(!button(bench, QStringLiteral("Store and prove")));
    bench.workbench.time += std::chrono::seconds(9);
    bench.set("slot0.p", 2, ParameterState::Ram); // starts it again
    bench.workbench.time += std::chrono::seconds(14);
    bench.set("slot0.i", 2, ParameterState::Volatile);
    QVERIFY(says(bench, QStringLiteral("1 s to go")));
    bench.workbench.time += std::chrono::seconds(1);
    bench.set("slot0.i", 3, ParameterState::Volatile);
    QAbstractButton *store = button(bench, QStringLiteral("Store and prove"));
    QVERIFY(store);
    QTest::mouseClick(store, Qt::LeftButton);
    QCOMPARE(bench.workbench.given<orders::StoreParameters>().size(), std::size_t{1});
}

void TestParameterOrders::unknownValuesAreReadOnce()
{
    DeviceView device = readDrive();
    device.parameters.edit().assign(device.parameters->size(), {});
    ParameterBench bench(device);
    QCOMPARE(bench.workbench.given<orders::ReadParameters>().size(), std::size_t{1});
    QCOMPARE(bench.shown("slot1.p", ParameterModel::ValueColumn), QStringLiteral("–"));
    bench.workbench.publish();
    bench.page->hide();
    bench.page->show();
    QApplication::setActiveWindow(bench.page.get());
    QCOMPARE(bench.workbench.given<orders::ReadParameters>().size(), std::size_t{1});
    QTest::keyClick(bench.page.get(), Qt::Key_F5);
    QCOMPARE(bench.workbench.given<orders::ReadParameters>().size(), std::size_t{2});
}

void TestParameterOrders::progressOfReadingIsShown()
{
    ParameterBench bench;
    OperationView operation;
    operation.id = {4};
    operation.device = {1};
    operation.status.title = say("Read parameters");
    operation.status.kind = OperationKind::ReadParameters;
    operation.status.done = 23;
    operation.status.total = 55;
    bench.workbench.shot.operations.push_back(operation);
    bench.workbench.publish();
    QVERIFY(says(bench, QStringLiteral("Reading 23 of 55")));
    bench.stage("slot1.p", "2");
    bench.page->write();
    QVERIFY(bench.workbench.given<orders::WriteParameters>().empty()); // one thing at a time
    bench.workbench.shot.operations[0].status.state = OperationStatus::State::Done;
    bench.workbench.shot.operations[0].status.endedAt += std::chrono::milliseconds(70);
    bench.workbench.publish();
    QVERIFY(says(bench, QStringLiteral("all 55 read in 70")));
}

void TestParameterOrders::bootloaderHasNoParameters()
{
    DeviceView device = readDrive();
    device.parameters.edit().assign(device.parameters->size(), {});
    device.identity.edit().state = DeviceState::Bootloader;
    ParameterBench bench(device);
    QVERIFY(says(bench, QStringLiteral("No parameters in the bootloader")));
    QVERIFY(bench.workbench.given<orders::ReadParameters>().empty());
}

MB_WINDOW_TEST(TestParameterOrders);
#include "tst_parameterorders.moc"
