// SPDX-License-Identifier: GPL-3.0-or-later
#include "settings/history.h"
#include "support/windowtests.h"
#include "trialbench.h"
#include "widgets/common/iconbutton.h"
#include "widgets/control/axespanel.h"
#include "widgets/control/gainspanel.h"
#include "widgets/control/gainunits.h"
#include "widgets/parameters/editdesk.h"
#include "widgets/parameters/valuetext.h"
#include "wire/fixedpoint.h"

#include <QSlider>

using namespace mb;
using namespace mb::test;

namespace {

/// A board with four axes beside the drive, armed.
struct BoardBench : TrialBench {
    BoardBench()
    {
        workbench.shot.devices.push_back(boardAt("sim:can"));
        look(1);
        arming.arm({2});
        workbench.publish();
    }
    void look(int axis)
    {
        selection.select({2}, axis);
        workbench.publish();
    }
};

} // namespace

class TestTuneGains : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void anEditedGainGoesOutWithItsRawValue();
    void gainsGoOutInAnOrderThatIsNeverLivelier();
    void aGainOutOfRangeIsSaidAndNotWritten();
    void theSliderStagesAndRevertBringsBack();
    void editsOfAnotherSlotStayStaged();
    void aGainHasTheSameDigitsInEveryPlace();
    void writeAndRunWaitsForTheGains();
    void gainsThatWereNotWrittenStartNothing();
    void disarmedDuringTheWriteStartsNothing();
    void adviceOnATrialOfAnotherSlotIsStagedIntoTheOneThatIsEdited();
    void ofATrialThatIsUsedOnlyTheGainsOfItsLoopAreStaged();
    void everyTurnRunsWhatWasOrderedWhicheverAxisIsShownWhenItComes_data();
    void everyTurnRunsWhatWasOrderedWhicheverAxisIsShownWhenItComes();
};

void TestTuneGains::anEditedGainGoesOutWithItsRawValue()
{
    TuneBench bench;
    QVERIFY(!bench.find<QAbstractButton>("Write gains")
        || !bench.page->findChild<CommandButton *>(s("writeGains"))->isEnabled());
    type(bench.find<QLineEdit>("P"), "1,2531");
    auto *button = bench.page->findChild<CommandButton *>(s("writeGains"));
    QCOMPARE(button->text(), s("Write P to slot 0"));
    QVERIFY(button->isEnabled());
    button->click();
    const auto writes = bench.workbench.given<orders::WriteParameters>();
    QCOMPARE(writes.size(), 1U);
    QCOMPARE(writes[0].changes.size(), 1U);
    QCOMPARE(writes[0].changes[0].index.value, named("slot0.p").value);
    QCOMPARE(writes[0].changes[0].raw, 82123);
    writes[0].finished({});
    bench.device().parameters.edit()[named("slot0.p").value] = {82123, ParameterState::Ram};
    ++bench.device().parameterRevision;
    bench.workbench.publish();
    QVERIFY(!button->isEnabled());
    QVERIFY(bench.workbench.given<orders::StartMotion>().empty());
}

void TestTuneGains::gainsGoOutInAnOrderThatIsNeverLivelier()
{
    TuneBench bench;
    type(bench.find<QLineEdit>("I"), "0.01");
    type(bench.find<QLineEdit>("P"), "0.5");
    type(bench.find<QLineEdit>("D"), "3");
    bench.page->write();
    const auto writes = bench.workbench.given<orders::WriteParameters>();
    QCOMPARE(writes.size(), 1U);
    QCOMPARE(writes[0].changes.size(), 3U);
    QCOMPARE(writes[0].changes[0].index.value, named("slot0.p").value); // lowered: first
    QCOMPARE(writes[0].changes[1].index.value, named("slot0.d").value);
    QCOMPARE(writes[0].changes[2].index.value, named("slot0.i").value); // raised: last
}

void TestTuneGains::aGainOutOfRangeIsSaidAndNotWritten()
{
    TuneBench bench;
    bench.arm();
    type(bench.find<QLineEdit>("P"), "40000");
    QVERIFY(!bench.page->findChild<CommandButton *>(s("writeGains"))->isEnabled());
    QVERIFY(!bench.page->status().mayRun);
    bench.page->write();
    bench.page->run();
    QVERIFY(bench.workbench.given<orders::WriteParameters>().empty());
    QVERIFY(bench.workbench.given<orders::StartMotion>().empty());
}

void TestTuneGains::theSliderStagesAndRevertBringsBack()
{
    TuneBench bench;
    auto *slider = bench.find<QSlider>("P, one decade either way");
    slider->setFocus();
    QTest::keyClick(slider, Qt::Key_Right);
    const double raised = *bench.page->column().gainsPanel().row(Role::Proportional)->number();
    QVERIFY(std::abs(raised / 1.165 - 1.02) < 1e-3);
    QTest::keyClick(slider, Qt::Key_Left, Qt::ShiftModifier);
    QVERIFY(
        std::abs(*bench.page->column().gainsPanel().row(Role::Proportional)->number() / 1.165 - 1.02 / 1.002) < 1e-3);
    click(bench, "Revert P");
    QCOMPARE(*bench.page->column().gainsPanel().row(Role::Proportional)->number(),
        static_cast<double>(rawOf("slot0.p", 1.165)) / 65536.0);
    QVERIFY(bench.page->column().gainsPanel().toWrite().empty());
}

void TestTuneGains::editsOfAnotherSlotStayStaged()
{
    TuneBench bench;
    type(bench.find<QLineEdit>("P"), "2");
    slot(bench, "Gain slot, edit and run", 1)->click();
    QVERIFY(bench.page->column().gainsPanel().toWrite().empty());
    QCOMPARE(*bench.page->column().gainsPanel().row(Role::FeedForward)->number(), 0.5);
    slot(bench, "Gain slot, edit and run", 0)->click();
    QCOMPARE(*bench.page->column().gainsPanel().row(Role::Proportional)->number(), 2.0);
}

void TestTuneGains::writeAndRunWaitsForTheGains()
{
    TuneBench bench;
    bench.arm();
    type(bench.find<QLineEdit>("P"), "2");
    auto *run = bench.page->findChild<CommandButton *>(s("run"));
    QCOMPARE(run->text(), s("Write and run"));
    run->click();
    QCOMPARE(bench.workbench.given<orders::WriteParameters>().size(), 1U);
    QVERIFY(bench.workbench.given<orders::StartMotion>().empty());
    QVERIFY(!run->isEnabled());
    bench.workbench.given<orders::WriteParameters>().at(0).finished({});
    QCOMPARE(bench.workbench.given<orders::StartMotion>().size(), 1U);
}

void TestTuneGains::gainsThatWereNotWrittenStartNothing()
{
    TuneBench bench;
    bench.arm();
    type(bench.find<QLineEdit>("P"), "2");
    bench.page->run();
    bench.workbench.given<orders::WriteParameters>().at(0).finished(fail(Fault::BadCheck, say("slot0.p reads 1")));
    QVERIFY(bench.workbench.given<orders::StartMotion>().empty());
    QVERIFY(bench.workbench.lines.back().text.contains(QLatin1String("slot0.p reads 1")));
    QCOMPARE(bench.page->column().gainsPanel().stagedNames(), QStringList{s("P")});
}

void TestTuneGains::disarmedDuringTheWriteStartsNothing()
{
    TuneBench bench;
    bench.arm();
    type(bench.find<QLineEdit>("P"), "2");
    bench.page->run();
    bench.arming.stopAll(s("test"));
    bench.workbench.given<orders::WriteParameters>().at(0).finished({});
    QVERIFY(bench.workbench.given<orders::StartMotion>().empty());
    QVERIFY2(problemOf(bench).startsWith(s("Stopped: test")), qPrintable(problemOf(bench)));
}

void TestTuneGains::aGainHasTheSameDigitsInEveryPlace()
{
    TrialBench bench;
    const ParameterIndex gain = named("slot0.i");
    const Parameter &row = dmc60c().parameters[gain.value];
    const std::int64_t raw = 55;
    bench.device().parameters.edit()[gain.value] = {raw, ParameterState::Stored};
    ++bench.device().parameterRevision;
    bench.workbench.publish();
    const QString expected = s("0.0008392");
    QCOMPARE(bench.find<QLineEdit>("I")->text(), expected);
    QCOMPARE(valueText(row, raw), expected);                       // Parameters
    QCOMPARE(shortNumber(row, fromFixed(raw, row.one)), expected); // Design, advice
    settings::SettingsChange change;
    change.values = {{"slot0.i", raw, 2 * raw, settings::Proof::Equal}};
    QVERIFY(messageText(settings::textOf(dmc60c(), change)).contains(expected)); // history and Log
    TrialModel trials(bench.theme);
    trials.setFamily(&dmc60c());
    KeptTrial kept;
    kept.number = 1;
    kept.trial.gains = {{"slot0.i", fromFixed(raw, row.one)}};
    trials.setTrials({kept});
    QCOMPARE(trials.index(0, TrialModel::GainI).data().toString(), expected);
}

void TestTuneGains::ofATrialThatIsUsedOnlyTheGainsOfItsLoopAreStaged()
{
    TrialBench bench;
    KeptTrial kept;
    kept.trial.mode = Mode::Velocity;
    kept.trial.slot = 0;
    kept.trial.gains = {{"slot0.p", 0.75}, {"slot1.p", 9.0}, {"current_limit.p", 40.0}};
    Q_EMIT bench.page->trials().useRequested(kept);
    const auto staged = bench.page->column().gainsPanel().toWrite();
    QCOMPARE(staged.size(), 1U);
    QCOMPARE(staged[0].index.value, named("slot0.p").value);
    QCOMPARE(staged[0].raw, 49152);
}

void TestTuneGains::adviceOnATrialOfAnotherSlotIsStagedIntoTheOneThatIsEdited()
{
    TrialBench bench;
    Q_EMIT bench.page->trials().stageRequested({{"slot1.p", 0.75}, {"slot1.i", 0.0}});
    const auto staged = bench.page->column().gainsPanel().toWrite();
    QCOMPARE(staged.size(), 2U);
    for (const ParameterChange &change : staged)
        QVERIFY(change.index == named("slot0.p") || (change.index == named("slot0.i") && change.raw == 0));
}

void TestTuneGains::everyTurnRunsWhatWasOrderedWhicheverAxisIsShownWhenItComes_data()
{
    QTest::addColumn<int>("shown");
    QTest::newRow("gains are staged on the axis that is shown at F5") << 3;
    QTest::newRow("gains are staged on another") << 1;
}

void TestTuneGains::everyTurnRunsWhatWasOrderedWhicheverAxisIsShownWhenItComes()
{
    QFETCH(const int, shown);
    BoardBench bench;
    bench.look(shown);
    bench.choose(500.0);
    const DeviceView &board = bench.workbench.device(1);
    const auto p = findParameter(board.family->parameters, "ch3.velocity.p");
    EditDesk::of(bench.workbench).editsOf(board).stageAll({{*p, 77}}, s("P"));
    QCOMPARE(bench.page->column().gainsPanel().toWrite().size(), shown == 3 ? 1U : 0U);
    bench.page->column().axesPanel().setTogether({1, 3});
    bench.page->run();
    const auto trials = [&bench] { return bench.workbench.given<orders::RunTrial>(); };
    QVERIFY2(trials().size() == 1, qPrintable(problemOf(bench)));
    QCOMPARE(trials()[0].plan.axis, 1);
    QVERIFY(trials()[0].plan.gains.empty());
    bench.look(shown == 3 ? 1 : 3);
    bench.finish(0.7);
    QCOMPARE(trials().size(), 2U);
    QCOMPARE(trials()[1].plan.axis, 3);
    QCOMPARE(trials()[1].plan.gains.size(), shown == 3 ? 1U : 0U);
}

MB_WINDOW_TEST(TestTuneGains);
#include "tst_tunegains.moc"
