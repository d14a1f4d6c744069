// SPDX-License-Identifier: GPL-3.0-or-later
// What the lamp says of a stop: told, seen, or nobody knows.
// Who may be armed, and what ends it.
#include "support/windowtests.h"
#include "trialbench.h"
#include "widgets/control/batterydialog.h"

#include <QSlider>
#include <QTest>

using namespace mb;
using namespace mb::test;

class TestArming : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void init();
    void stopIsOfTheUserAndGoesOutFirst();
    void aStopWhereNothingMovesIsNoCaution();
    void stopForAnotherCauseIsOfTheProgram();
    void aStopIsNotShownAsDoneBeforeItIsSeen();
    void aMotorThatMayStillTurnIsNamedUntilItIsSeen();
    void aMotorThatMayStillTurnKeepsEverythingFromBeingArmed();
    void aStopOwedToADeviceThatIsGoneIsNamedToo();
    void theLampNamesWhomStopLeavesOutForAMomentAndTheLogSaysWhy();
    void noHandReachesIntoARunningExperiment();
    void aUnitIsArmedAgainOnceItsExperimentHasEnded();
    void anExperimentThatEndsIsNoEndOfWhatAnotherUnitDoes();
    void whoAsksForAnExperimentThatCannotBeginIsAnswered();
    void aRunThatWaitsForAWriteDoesNotOutliveAStop();
    void anAxisThatIsRefusedIsNoEndOfWhatAnotherDoes();
    void theBatteryIsWhatThePageSaysWhenItIsRun();
    void silenceAndARestartEndAnArming_data();
    void silenceAndARestartEndAnArming();
    void aComputerThatSleptIsArmedAnew();
    void anExperimentThatEndsAfterTheComputerSleptLeavesNothingArmed();
    void anUnknownPositionIsNoPlaceToStartFrom();

private:
    [[nodiscard]] LampStatus lamp() { return m_bench->arming.status({1}); }

    std::unique_ptr<TuneBench> m_bench;
};

void TestArming::init()
{
    m_bench = std::make_unique<TuneBench>();
    m_bench->arm();
}

void TestArming::stopIsOfTheUserAndGoesOutFirst()
{
    m_bench->workbench.sent.clear();
    m_bench->arming.stopAll(QStringLiteral("Esc"));
    QCOMPARE(m_bench->workbench.stops.size(), std::size_t{1});
    QCOMPARE(m_bench->workbench.stops.front().ordersBefore, std::size_t{0});
    QVERIFY(m_bench->workbench.stops.front().cause == StopCause::User);
    QCOMPARE(m_bench->arming.state(), LampState::Stopped);
}

/// Esc closes a dialog, too; the stop goes out all the same.
void TestArming::aStopWhereNothingMovesIsNoCaution()
{
    FakeWorkbench &workbench = m_bench->workbench;
    m_bench->arming.stopAll(QStringLiteral("Esc"));
    QVERIFY(workbench.lines.back().severity == Severity::Caution); // it was armed
    m_bench->arming.disarm();
    m_bench->arming.stopAll(QStringLiteral("Esc"));
    QCOMPARE(workbench.stops.size(), std::size_t{2});
    QCOMPARE(workbench.lines.back().text, QStringLiteral("STOP: Esc"));
    QVERIFY(workbench.lines.back().severity == Severity::Info);
    m_bench->device().liveness.moving = true; // by another program, or by itself
    workbench.publish();
    m_bench->arming.stopAll(QStringLiteral("Esc"));
    QVERIFY(workbench.lines.back().severity == Severity::Caution);
}

void TestArming::stopForAnotherCauseIsOfTheProgram()
{
    m_bench->workbench.sent.clear();
    m_bench->arming.stopMoved(QStringLiteral("the window lost the focus"));
    QCOMPARE(m_bench->workbench.stops.size(), std::size_t{1});
    QCOMPARE(m_bench->workbench.stops.front().ordersBefore, std::size_t{0});
    QVERIFY(m_bench->workbench.stops.front().cause == StopCause::Program);
    QCOMPARE(m_bench->arming.state(), LampState::Stopped);
}

void TestArming::aStopIsNotShownAsDoneBeforeItIsSeen()
{
    m_bench->arming.stopAll(QStringLiteral("Esc"));
    m_bench->device().stop = StopState::Stopping;
    m_bench->device().stopsMotion = true;
    QVERIFY(lamp().state == LampState::Stopping);
    m_bench->device().stop = StopState::Seen;
    m_bench->device().stopsMotion = false;
    QVERIFY(lamp().state == LampState::Stopped);
}

void TestArming::aMotorThatMayStillTurnIsNamedUntilItIsSeen()
{
    m_bench->arming.stopAll(QStringLiteral("Esc"));
    m_bench->device().stop = StopState::Unconfirmed;
    m_bench->device().mayTurn = true;
    QVERIFY(lamp().state == LampState::MayTurn);
    QCOMPARE(lamp().detail, QStringLiteral("#5: cut its power"));
    m_bench->device().mayTurn = false;
    QVERIFY(lamp().state == LampState::Stopped);
}

void TestArming::aMotorThatMayStillTurnKeepsEverythingFromBeingArmed()
{
    m_bench->arming.stopAll(QStringLiteral("Esc"));
    m_bench->device().mayTurn = true;
    QVERIFY(!lamp().armable);
    m_bench->arming.arm({1});
    QCOMPARE(m_bench->arming.state(), LampState::Stopped);
    QVERIFY(m_bench->workbench.lines.back().text.contains(QStringLiteral("may still turn")));
}

void TestArming::aStopOwedToADeviceThatIsGoneIsNamedToo()
{
    m_bench->workbench.shot.owedStops = {{"socketcan:can0/abstractdc:3", false}};
    QVERIFY(lamp().state == LampState::MayTurn);
    QCOMPARE(lamp().detail, QStringLiteral("abstractdc:3: cut its power"));
    m_bench->workbench.shot.owedStops[0].elsewhere = true; // another abstractdc:3 may answer there
    QCOMPARE(lamp().detail, QStringLiteral("abstractdc:3 on the adapter before: cut its power"));
}

void TestArming::theLampNamesWhomStopLeavesOutForAMomentAndTheLogSaysWhy()
{
    m_bench->device().mayNotBeStopped = say("bootloader");
    m_bench->arming.stopAll(QStringLiteral("Esc"));
    QCOMPARE(lamp().detail, QStringLiteral("not sent to #5"));
    QVERIFY(m_bench->workbench.lines.back().text.contains(QStringLiteral("not sent to #5 (bootloader)")));
    m_bench->workbench.time += std::chrono::seconds(8);
    QCOMPARE(lamp().detail, QString()); // which gives the instruction to re-arm
}

void TestArming::noHandReachesIntoARunningExperiment()
{
    TrialBench bench;
    bench.choose(60'000.0);
    bench.arm();
    bench.page->run();
    QVERIFY(bench.arming.isOnTrial());
    bench.device().motion.running = true;
    bench.device().liveness.moving = true;
    bench.page->showLive(true);
    bench.workbench.publish();
    QVERIFY(!bench.page->status().mayRun);
    bench.page->run();
    bench.find<QSlider>("Set-point, slider")->setValue(400);
    SetPoint held;
    held.mode = Mode::RampPosition;
    bench.arming.run(held);
    QVERIFY(bench.workbench.given<orders::UpdateMotion>().empty());
    QVERIFY(bench.workbench.given<orders::StartMotion>().empty());
}

void TestArming::aUnitIsArmedAgainOnceItsExperimentHasEnded()
{
    TrialBench bench;
    bench.choose(60'000.0);
    bench.arm();
    bench.page->run();
    bench.arming.disarm();
    bench.arming.arm({1});
    QVERIFY(bench.arming.state() == LampState::Safe);
    QVERIFY2(bench.workbench.lines.back().text.contains(QStringLiteral("experiment")),
        qPrintable(bench.workbench.lines.back().text));
    QVERIFY(!bench.arming.status({1}).armable);
    bench.finish(0.5);
    bench.arming.arm({1});
    QVERIFY(bench.arming.isArmed({1}));
}

void TestArming::anExperimentThatEndsIsNoEndOfWhatAnotherUnitDoes()
{
    TrialBench bench;
    bench.workbench.shot.devices.push_back(tunableDrive(bench.recording.telemetry(), 2, 7));
    bench.choose(60'000.0);
    bench.arm();
    bench.page->run();
    const auto planned = bench.workbench.given<orders::RunTrial>().back();
    bench.selection.select({2}); // disarms
    bench.page->showLive(true);
    bench.arming.arm({2});
    bench.page->run();
    QVERIFY(bench.arming.isMoving());
    QCOMPARE(bench.workbench.given<orders::StartMotion>().back().device, DeviceId{2});
    const auto stops = bench.workbench.given<orders::StopMotion>().size();
    bench.page->halt();
    QCOMPARE(bench.workbench.given<orders::StopMotion>().size(), stops + 1);
    QVERIFY2(!bench.arming.isMoving(), "a motion by hand is over at once, whatever another unit still does");
    bench.page->run();
    tuning::Trial trial = responseOf(planned.plan, 1, 0.5, bench.unit());
    trial.reason = tuning::EndReason::Speed;
    planned.finished(trial);
    QVERIFY(bench.arming.isMoving());
    QCOMPARE(bench.arming.device(), DeviceId{2});
}

void TestArming::whoAsksForAnExperimentThatCannotBeginIsAnswered()
{
    m_bench->arming.disarm();
    std::optional<Result<tuning::Trial>> ended;
    m_bench->arming.runTrial({}, {}, [&ended](const Result<tuning::Trial> &trial) { ended = trial; });
    QVERIFY(ended && !*ended);
    QVERIFY(m_bench->workbench.given<orders::RunTrial>().empty());
}

void TestArming::aRunThatWaitsForAWriteDoesNotOutliveAStop()
{
    TuneBench bench;
    bench.arm();
    EditDesk::of(bench.workbench).editsOf(bench.device()).stageAll({{named("slot0.d"), 25}}, QStringLiteral("by hand"));
    bench.page->run();
    QCOMPARE(bench.workbench.given<orders::WriteParameters>().size(), 1U);
    bench.arming.stopAll(QStringLiteral("Esc"));
    bench.arm();
    QVERIFY(bench.arming.isArmed({1}));
    const auto finished = bench.workbench.given<orders::WriteParameters>().back().finished;
    finished({});
    QVERIFY(bench.workbench.given<orders::StartMotion>().empty());
}

void TestArming::anAxisThatIsRefusedIsNoEndOfWhatAnotherDoes()
{
    TuneBench bench;
    bench.arm();
    SetPoint setPoint;
    setPoint.mode = Mode::Velocity;
    setPoint.target = 1000.0;
    bench.arming.run(setPoint);
    setPoint.axis = 2;
    bench.arming.run(setPoint);
    const auto another = bench.workbench.given<orders::UpdateMotion>().back().finished;
    another(fail(Fault::OutOfRange, say("too fast")));
    QVERIFY(bench.arming.isMoving());
    const auto first = bench.workbench.given<orders::StartMotion>().back().finished;
    first(fail(Fault::OutOfRange, say("too fast")));
    QVERIFY(!bench.arming.isMoving());
    QVERIFY(bench.arming.isArmed({1}));
}

void TestArming::theBatteryIsWhatThePageSaysWhenItIsRun()
{
    TrialBench bench;
    bench.choose(60'000.0);
    bench.arm();
    QTest::keyClick(bench.page.get(), Qt::Key_F7);
    auto *const dialog = bench.page->findChild<BatteryDialog *>();
    QVERIFY(dialog);
    bench.choose(30'000.0);
    dialog->run();
    QCOMPARE(bench.workbench.given<orders::RunTrial>().size(), 1U);
    QCOMPARE(bench.workbench.given<orders::RunTrial>().back().plan.to, 6'000.0);
}

void TestArming::silenceAndARestartEndAnArming_data()
{
    QTest::addColumn<bool>("restart");
    QTest::newRow("silence") << false;
    QTest::newRow("a restart") << true;
}

void TestArming::silenceAndARestartEndAnArming()
{
    QFETCH(bool, restart);
    (restart ? m_bench->device().liveness.restarted : m_bench->device().liveness.heard) = restart;
    m_bench->workbench.publish();
    QVERIFY(m_bench->arming.state() == LampState::Stopped);
    QVERIFY(!m_bench->arming.reason().isEmpty());
    m_bench->arming.arm({1});
    QVERIFY2(m_bench->arming.state() == LampState::Stopped, "as long as that is so");
}

void TestArming::aComputerThatSleptIsArmedAnew()
{
    FakeWorkbench &workbench = m_bench->workbench;
    const auto slept = [&workbench](std::chrono::nanoseconds inAll) {
        workbench.time += std::chrono::milliseconds(10);
        workbench.slept.look(workbench.time, inAll);
        workbench.publish();
    };
    slept({});
    slept(std::chrono::milliseconds(5)); // two clocks are not read at one instant
    QVERIFY(m_bench->arming.isArmed({1}));
    slept(std::chrono::hours(2));
    QCOMPARE(m_bench->arming.state(), LampState::Stopped);
    QCOMPARE(m_bench->arming.reason(), s("the computer slept"));
    m_bench->arm();
    workbench.publish();
    QVERIFY(m_bench->arming.isArmed({1}));
}

void TestArming::anExperimentThatEndsAfterTheComputerSleptLeavesNothingArmed()
{
    TrialBench bench;
    bench.workbench.slept.look(bench.workbench.time, {});
    bench.choose(60'000.0);
    bench.arm();
    bench.page->run();
    const auto planned = bench.workbench.given<orders::RunTrial>().back();
    bench.workbench.time += std::chrono::milliseconds(10);
    bench.workbench.slept.look(bench.workbench.time, std::chrono::hours(1));
    planned.finished(responseOf(planned.plan, 1, 0.5, bench.unit()));
    bench.workbench.publish();
    QCOMPARE(bench.arming.state(), LampState::Stopped);
}

void TestArming::anUnknownPositionIsNoPlaceToStartFrom()
{
    m_bench->page->form().choose(Mode::Position, 1000.0);
    m_bench->arm();
    QVERIFY(!m_bench->page->status().mayRun);
    QVERIFY2(problemOf(*m_bench).contains(QStringLiteral("position")), qPrintable(problemOf(*m_bench)));
    m_bench->page->run();
    QVERIFY(m_bench->workbench.given<orders::StartMotion>().empty());
    m_bench->pass(1.0, 500.0);
    m_bench->page->run();
    QCOMPARE(m_bench->workbench.given<orders::StartMotion>().size(), 1U);
}

MB_WINDOW_TEST(TestArming);
#include "tst_arming.moc"
