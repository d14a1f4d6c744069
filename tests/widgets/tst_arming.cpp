// SPDX-License-Identifier: GPL-3.0-or-later
// What the lamp says of a stop: told, seen, or nobody knows.
#include "support/windowtests.h"
#include "tunebench.h"

#include <QTest>

using namespace mb;
using namespace mb::test;

class TestArming : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void init();
    void stopIsOfTheUserAndGoesOutFirst();
    void stopForAnotherCauseIsOfTheProgram();
    void aStopIsNotShownAsDoneBeforeItIsSeen();
    void aMotorThatMayStillTurnIsNamedUntilItIsSeen();
    void aMotorThatMayStillTurnKeepsEverythingFromBeingArmed();
    void aStopOwedToADeviceThatIsGoneIsNamedToo();
    void theLampNamesWhomStopLeavesOut();

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
    m_bench->workbench.shot.owedStops = {"socketcan:can0/abstractdc:3"};
    QVERIFY(lamp().state == LampState::MayTurn);
    QCOMPARE(lamp().detail, QStringLiteral("abstractdc:3: cut its power"));
}

void TestArming::theLampNamesWhomStopLeavesOut()
{
    m_bench->device().mayNotBeStopped = say("bootloader");
    m_bench->arming.stopAll(QStringLiteral("Esc"));
    QCOMPARE(lamp().detail, QStringLiteral("not sent to #5"));
    QVERIFY(m_bench->workbench.lines.back().text.contains(QStringLiteral("not sent to #5")));
}

MB_WINDOW_TEST(TestArming);
#include "tst_arming.moc"
