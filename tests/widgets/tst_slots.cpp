// SPDX-License-Identifier: GPL-3.0-or-later
// The gain slot is one choice; editing one while another runs is a deliberate act that stays in sight.
#include "support/windowtests.h"
#include "tunehand.h"
#include "widgets/common/iconbutton.h"
#include "widgets/common/labels.h"
#include "widgets/control/gainspanel.h"
#include "widgets/control/modepanel.h"

using namespace mb;
using namespace mb::test;

class SlotsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void oneChoiceEditsAndRunsASlot();
    void gainsEditedInTheChosenSlotAreWrittenBeforeItRuns();
    void splittingIsSaidInAmberUntilJoined();
    void joiningEditsTheSlotThatRunsAndDoesNotDisarm();
    void aMotorLeftSplitComesBackSplit();
};

namespace {

const QLabel *note(TuneBench &bench)
{
    return bench.page->findChild<QLabel *>(s("splitSlots"));
}

void split(TuneBench &bench)
{
    click(bench, "Edit one slot while another runs");
    slot(bench, "Gain slot that is edited", 1)->click();
}

} // namespace

void SlotsTest::oneChoiceEditsAndRunsASlot()
{
    TuneBench bench;
    QVERIFY(!bench.find<QWidget>("Gain slot that is edited")->isVisible());
    QVERIFY(!note(bench)->isVisible());
    slot(bench, "Gain slot, edit and run", 1)->click();
    QCOMPARE(bench.page->column().modePanel().editedSlot(), 1);
    QCOMPARE(bench.page->column().modePanel().runningSlot(), 1);
    QCOMPARE(*bench.page->column().gainsPanel().row(Role::FeedForward)->number(), 0.5); // of slot 1
    QVERIFY(!note(bench)->isVisible());
}

void SlotsTest::gainsEditedInTheChosenSlotAreWrittenBeforeItRuns()
{
    TuneBench bench;
    slot(bench, "Gain slot, edit and run", 1)->click();
    bench.arm();
    type(bench.find<QLineEdit>("P"), "2");
    bench.page->run();
    const auto writes = bench.workbench.given<orders::WriteParameters>();
    QCOMPARE(writes.size(), 1U);
    QCOMPARE(writes[0].changes[0].index.value, named("slot1.p").value);
    writes[0].finished({});
    QCOMPARE(bench.workbench.given<orders::StartMotion>().at(0).setPoint.slot, 1);
}

void SlotsTest::splittingIsSaidInAmberUntilJoined()
{
    TuneBench bench;
    split(bench);
    QVERIFY(note(bench)->isVisible());
    QCOMPARE(note(bench)->text(), s("Split: edits go to slot 1, slot 0 runs."));
    QCOMPARE(note(bench)->property("tone").toString(), s("caution"));
    QVERIFY(!bench.find<QWidget>("Gain slot, edit and run")->isVisible());
    click(bench, "Edit the slot that runs");
    QVERIFY(!note(bench)->isVisible());
    QVERIFY(bench.find<QWidget>("Gain slot, edit and run")->isVisible());
}

void SlotsTest::joiningEditsTheSlotThatRunsAndDoesNotDisarm()
{
    TuneBench bench;
    split(bench);
    bench.arm();
    click(bench, "Edit the slot that runs");
    QCOMPARE(bench.page->column().modePanel().editedSlot(), 0);
    QCOMPARE(bench.page->column().modePanel().runningSlot(), 0);
    QVERIFY(bench.arming.isArmed({1}));
}

void SlotsTest::aMotorLeftSplitComesBackSplit()
{
    TuneBench bench;
    bench.workbench.shot.devices.push_back(tunableDrive(bench.recording.telemetry(), 2, 7));
    bench.workbench.publish();
    split(bench);
    bench.selection.select({2});
    QVERIFY(!note(bench)->isVisible());
    bench.selection.select({1});
    QVERIFY(note(bench)->isVisible());
    QCOMPARE(bench.page->column().modePanel().editedSlot(), 1);
    QCOMPARE(bench.page->column().modePanel().runningSlot(), 0);
}

MB_WINDOW_TEST(SlotsTest);
#include "tst_slots.moc"
