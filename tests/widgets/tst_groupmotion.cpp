// SPDX-License-Identifier: GPL-3.0-or-later
// Moves together: who takes no part any more is stopped, and what was not started is not called so.
#include "support/windowtests.h"
#include "tunebench.h"
#include "widgets/control/groupmotion.h"

#include <QTest>

using namespace mb;
using namespace mb::test;

namespace {

struct GroupBench {
    FakeWorkbench workbench;
    Arming arming{workbench};
    GroupMotion group{workbench, arming};
    Recording recording{workbench.time};

    GroupBench()
    {
        for (const std::uint32_t id : {1U, 2U, 3U})
            workbench.shot.devices.push_back(tunableDrive(recording.telemetry(), id, static_cast<int>(id)));
        arming.arm({1});
    }
    /// The engine has told that these keep their moves.
    void prepare(const std::vector<std::uint32_t> &who)
    {
        std::vector<GroupMotion::Member> members;
        for (const std::uint32_t id : who) {
            SetPoint setPoint;
            setPoint.mode = Mode::Position;
            setPoint.target = 1000.0;
            members.push_back({{id}, setPoint});
        }
        QVERIFY(group.prepare({1}, members));
        for (const std::uint32_t id : who) {
            SetPoint ordered;
            for (const auto &order : workbench.given<orders::StartMotion>()) {
                if (order.device.value == id)
                    ordered = order.setPoint;
            }
            for (const auto &order : workbench.given<orders::UpdateMotion>()) {
                if (order.device.value == id)
                    ordered = order.setPoint;
            }
            DeviceView &view = workbench.device(id - 1);
            view.motion.running = true;
            view.motion.setPoint = ordered;
            view.kept = {KeptMove::State::Acknowledged, ordered};
        }
        workbench.publish();
    }
};

} // namespace

class GroupMotionTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aMemberThatTakesNoPartAnyMoreIsStopped();
    void aMemberThatMovesAlreadyIsPreparedByWhatItKeeps();
    void aStartThatIsRefusedHasNotBegun();
    void aLateAnswerSaysNothingOfMovesThatWerePreparedSince();
    void nothingIsPreparedWhileTheLeadIsOnTrial();
};

void GroupMotionTest::aMemberThatTakesNoPartAnyMoreIsStopped()
{
    GroupBench bench;
    bench.prepare({1, 2, 3});
    QVERIFY(bench.group.isPrepared());
    QVERIFY(bench.workbench.given<orders::StopMotion>().empty());
    bench.prepare({1, 2});
    const auto stops = bench.workbench.given<orders::StopMotion>();
    QCOMPARE(stops.size(), std::size_t{1});
    QCOMPARE(stops.front().device.value, 3U);
    bench.workbench.device(2).motion.running = false;
    bench.workbench.publish();
    QVERIFY2(bench.group.isPrepared(), "the others keep theirs");
}

void GroupMotionTest::aMemberThatMovesAlreadyIsPreparedByWhatItKeeps()
{
    GroupBench bench;
    bench.prepare({1, 2});
    DeviceView &view = bench.workbench.device(1);
    const KeptMove kept = std::exchange(view.kept, {});
    view.liveness.mode = Mode::Position;
    bench.workbench.publish();
    QVERIFY2(!bench.group.isPrepared(), "it moves in this mode already");
    view.kept = {KeptMove::State::Acknowledged, {}};
    bench.workbench.publish();
    QVERIFY2(!bench.group.isPrepared(), "it keeps the one before");
    view.kept = kept;
    view.liveness.mode = Mode::Velocity;
    bench.workbench.publish();
    QVERIFY(bench.group.isPrepared());
}

void GroupMotionTest::aStartThatIsRefusedHasNotBegun()
{
    GroupBench bench;
    bench.prepare({1, 2});
    QVERIFY(bench.group.start());
    QVERIFY(!bench.group.isStarted());
    QVERIFY2(!bench.group.start(), "it is ordered once");
    QCOMPARE(bench.workbench.given<orders::ReleaseMoves>().size(), std::size_t{1});
    bench.workbench.given<orders::ReleaseMoves>().back().finished(fail(Fault::Unsafe, say("another keeps a move")));
    QVERIFY(!bench.group.isStarted());
    QVERIFY(bench.group.isPrepared());
    QVERIFY(bench.group.start());
    bench.workbench.given<orders::ReleaseMoves>().back().finished({});
    QVERIFY(bench.group.isStarted());
}

void GroupMotionTest::aLateAnswerSaysNothingOfMovesThatWerePreparedSince()
{
    GroupBench bench;
    bench.prepare({1, 2});
    QVERIFY(bench.group.start());
    const auto first = bench.workbench.given<orders::ReleaseMoves>().back();
    bench.prepare({1, 2});
    first.finished({});
    QVERIFY(!bench.group.isStarted());
    QVERIFY(bench.group.isPrepared());
}

void GroupMotionTest::nothingIsPreparedWhileTheLeadIsOnTrial()
{
    GroupBench bench;
    bench.arming.runTrial({}, {}, {});
    QVERIFY(bench.arming.isOnTrial(DeviceId{1}));
    SetPoint move;
    move.mode = Mode::Position;
    QVERIFY(!bench.group.prepare({1}, {{{1}, move}, {{2}, move}}));
    QVERIFY(!bench.group.isActive());
    QVERIFY2(bench.workbench.given<orders::StartMotion>().empty(), "the others would be energised for nothing");
    QVERIFY(!bench.workbench.lines.empty());
    QVERIFY(bench.workbench.lines.back().text.contains(QStringLiteral("experiment")));
}

MB_WINDOW_TEST(GroupMotionTest);
#include "tst_groupmotion.moc"
