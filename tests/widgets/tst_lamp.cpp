// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/windowtests.h"
#include "widgets/common/holdbutton.h"
#include "widgets/common/lamp.h"
#include "widgets/common/stopbutton.h"

#include <QHBoxLayout>
#include <QSignalSpy>
#include <QTest>
#include <QThread>

using namespace mb;
using namespace std::chrono_literals;

class LampTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void init();
    void aFullHoldAsksForArmingOnce();
    void lettingGoEarlyDoesNothing();
    void lettingGoAfterTheWindowStoodStillDoesNothing();
    void aWindowThatStoodStillCountsForOneTick();
    void leavingTheLampCancels();
    void hidingTheLampCancels();
    void nothingToArmIgnoresTheHold();
    void stoppedCanBeReArmed();
    void noKeyArms();
    void pressingWhileArmedAsksToDisarm();
    void becomingMovingEndsTheHold();
    void assistivePressFillsAndASecondOneCancels();
    void assistivePressHoldsAButtonTooAndASecondOneCancels();
    void theStopKeyThatIsLetGoBeginsNoHoldOfAButtonThatIsStillDown();
    void theLampKeepsItsWidth();
    void whatMayStillTurnIsSaidOnTwoLinesInTheSameWidth();
    void whatMayStillTurnCannotBeArmed();
    void stoppingIsNotStopped();
    void stopActsOnPressWithEveryButton();
    void stopCannotBeDisabled();
    void stopIsNotInTheTabOrder();
    void assistivePressStopsAtOnce();

private:
    ThemeSource m_theme{darkTheme()};
    std::unique_ptr<QWidget> m_window;
    Lamp *m_lamp = nullptr;
    StopButton *m_stop = nullptr;
};

void LampTest::init()
{
    m_window = std::make_unique<QWidget>();
    auto *row = new QHBoxLayout(m_window.get());
    m_lamp = new Lamp(m_theme);
    m_lamp->setHoldMilliseconds(20);
    m_stop = new StopButton(m_theme);
    row->addWidget(m_lamp);
    row->addWidget(m_stop);
    m_window->show();
    QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
}

void LampTest::aFullHoldAsksForArmingOnce()
{
    QSignalSpy armed(m_lamp, &Lamp::armRequested);
    QSignalSpy holding(m_lamp, &Lamp::holdingChanged);
    QTest::mousePress(m_lamp, Qt::LeftButton);
    QVERIFY(armed.wait(2000));
    QTest::mouseRelease(m_lamp, Qt::LeftButton);
    QCOMPARE(armed.count(), 1);
    QCOMPARE(holding.count(), 2);
    QCOMPARE(m_lamp->holdProgress(), 0.0);
}

void LampTest::lettingGoEarlyDoesNothing()
{
    m_lamp->setHoldMilliseconds(60'000);
    QSignalSpy armed(m_lamp, &Lamp::armRequested);
    QSignalSpy holding(m_lamp, &Lamp::holdingChanged);
    QTest::mousePress(m_lamp, Qt::LeftButton);
    QCOMPARE(holding.count(), 1);
    QTest::mouseRelease(m_lamp, Qt::LeftButton);
    QCOMPARE(armed.count(), 0);
    QCOMPARE(holding.count(), 2);
}

void LampTest::lettingGoAfterTheWindowStoodStillDoesNothing()
{
    QSignalSpy armed(m_lamp, &Lamp::armRequested);
    QTest::mousePress(m_lamp, Qt::LeftButton);
    QThread::msleep(50); // the window that stands still
    QTest::mouseRelease(m_lamp, Qt::LeftButton);
    QCOMPARE(armed.count(), 0);
}

void LampTest::aWindowThatStoodStillCountsForOneTick()
{
    m_lamp->setHoldMilliseconds(400);
    HoldButton button(m_theme, Symbol::Add, QStringLiteral("Send"));
    button.setHoldNeeded(true);
    button.setHoldMilliseconds(400);
    QSignalSpy armed(m_lamp, &Lamp::armRequested);
    QSignalSpy activated(&button, &HoldButton::activated);
    QTest::mousePress(m_lamp, Qt::LeftButton);
    QTest::mousePress(&button, Qt::LeftButton);
    QThread::msleep(500);
    QCoreApplication::processEvents();
    QCOMPARE(armed.count(), 0);
    QCOMPARE(activated.count(), 0);
    QVERIFY(m_lamp->holdProgress() > 0.0);
    QVERIFY(armed.wait(5000));
    QTRY_COMPARE(activated.count(), 1);
}

void LampTest::leavingTheLampCancels()
{
    m_lamp->setHoldMilliseconds(60'000);
    QSignalSpy holding(m_lamp, &Lamp::holdingChanged);
    QTest::mousePress(m_lamp, Qt::LeftButton);
    QMouseEvent move(QEvent::MouseMove, QPointF(5, 500), Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(m_lamp, &move);
    QCOMPARE(holding.count(), 2);
    QCOMPARE(holding.last().at(0).toBool(), false);
}

void LampTest::hidingTheLampCancels()
{
    m_lamp->setHoldMilliseconds(60'000);
    QSignalSpy holding(m_lamp, &Lamp::holdingChanged);
    QTest::mousePress(m_lamp, Qt::LeftButton);
    m_lamp->hide();
    QCOMPARE(holding.count(), 2);
}

void LampTest::nothingToArmIgnoresTheHold()
{
    m_lamp->setStatus({LampState::Safe, QStringLiteral("nothing to arm"), {}, false});
    QSignalSpy holding(m_lamp, &Lamp::holdingChanged);
    QTest::mousePress(m_lamp, Qt::LeftButton);
    QCOMPARE(holding.count(), 0);
}

void LampTest::stoppedCanBeReArmed()
{
    m_lamp->setStatus({LampState::Stopped, {}, {}, true});
    QSignalSpy armed(m_lamp, &Lamp::armRequested);
    QTest::mousePress(m_lamp, Qt::LeftButton);
    QVERIFY(armed.wait(2000));
}

void LampTest::noKeyArms()
{
    QSignalSpy armed(m_lamp, &Lamp::armRequested);
    QSignalSpy holding(m_lamp, &Lamp::holdingChanged);
    for (const Qt::Key key : {Qt::Key_Space, Qt::Key_Return, Qt::Key_Enter, Qt::Key_A})
        QTest::keyClick(m_lamp, key);
    QCOMPARE(holding.count(), 0);
    QCOMPARE(armed.count(), 0);
    QCOMPARE(m_lamp->focusPolicy(), Qt::NoFocus);
}

void LampTest::pressingWhileArmedAsksToDisarm()
{
    m_lamp->setStatus({LampState::Armed, QStringLiteral("#5 velocity"), 272s, true});
    QSignalSpy disarm(m_lamp, &Lamp::disarmRequested);
    QSignalSpy holding(m_lamp, &Lamp::holdingChanged);
    QTest::mousePress(m_lamp, Qt::LeftButton);
    QCOMPARE(disarm.count(), 1);
    QCOMPARE(holding.count(), 0);
    QVERIFY(m_lamp->accessibleDescription().contains(QStringLiteral("4:32")));
}

void LampTest::becomingMovingEndsTheHold()
{
    m_lamp->setHoldMilliseconds(60'000);
    QSignalSpy holding(m_lamp, &Lamp::holdingChanged);
    QTest::mousePress(m_lamp, Qt::LeftButton);
    m_lamp->setStatus({LampState::Moving, QStringLiteral("4 motors"), {}, true});
    QCOMPARE(holding.count(), 2);
}

void LampTest::assistivePressFillsAndASecondOneCancels()
{
    m_lamp->setHoldMilliseconds(60'000);
    QSignalSpy holding(m_lamp, &Lamp::holdingChanged);
    QSignalSpy armed(m_lamp, &Lamp::armRequested);
    m_lamp->click();
    QCOMPARE(holding.count(), 1);
    m_lamp->click();
    QCOMPARE(holding.count(), 2);
    QCOMPARE(armed.count(), 0);
    m_lamp->setHoldMilliseconds(20);
    m_lamp->click();
    QVERIFY(armed.wait(2000));
}

void LampTest::theStopKeyThatIsLetGoBeginsNoHoldOfAButtonThatIsStillDown()
{
    HoldButton button(m_theme, Symbol::Add, QStringLiteral("Send"), m_window.get());
    button.show();
    button.setHoldNeeded(true);
    button.setHoldMilliseconds(60'000);
    QSignalSpy activated(&button, &HoldButton::activated);
    QTest::mousePress(&button, Qt::LeftButton);
    button.giveUp(); // Space was pressed
    button.setHoldMilliseconds(1);
    button.setDown(true); // by the next move of the mouse
    QTest::keyRelease(&button, Qt::Key_Space);
    QVERIFY(!activated.wait(50));
}

void LampTest::assistivePressHoldsAButtonTooAndASecondOneCancels()
{
    HoldButton button(m_theme, Symbol::Add, QStringLiteral("Send"), m_window.get());
    button.show();
    button.setHoldNeeded(true);
    button.setHoldMilliseconds(60'000);
    QSignalSpy activated(&button, &HoldButton::activated);
    button.click();
    button.click();
    button.setHoldMilliseconds(20);
    button.click();
    button.giveUp(); // somebody said STOP
    QCOMPARE(activated.count(), 0);
    button.click();
    QVERIFY(activated.wait(2000));
    QCOMPARE(activated.count(), 1);
}

void LampTest::theLampKeepsItsWidth()
{
    const int width = m_lamp->sizeHint().width();
    const LampStatus others[]
        = {{LampState::Safe, {}, {}, false}, {LampState::Moving, QStringLiteral("4 motors"), {}, true},
            {LampState::Armed, QStringLiteral("#5 velocity"), 272s, true},
            {LampState::Stopped, QStringLiteral("not sent to #9, #11, #12, #13"), {}, true}};
    for (const LampStatus &status : others) {
        m_lamp->setStatus(status);
        QCOMPARE(m_lamp->sizeHint().width(), width);
    }
}

void LampTest::whatMayStillTurnIsSaidOnTwoLinesInTheSameWidth()
{
    const QSize size = m_lamp->sizeHint();
    m_lamp->setStatus({LampState::MayTurn, QStringLiteral("#3: cut its power"), {}, false});
    QCOMPARE(m_lamp->sizeHint(), size);
    QVERIFY(m_lamp->accessibleName().contains(QStringLiteral("MAY STILL TURN")));
    QVERIFY(m_lamp->accessibleDescription().contains(QStringLiteral("cut its power")));
}

void LampTest::whatMayStillTurnCannotBeArmed()
{
    m_lamp->setStatus({LampState::MayTurn, {}, {}, false});
    QSignalSpy holding(m_lamp, &Lamp::holdingChanged);
    QSignalSpy disarm(m_lamp, &Lamp::disarmRequested);
    QTest::mousePress(m_lamp, Qt::LeftButton);
    QCOMPARE(holding.count(), 0);
    QCOMPARE(disarm.count(), 1);
}

void LampTest::stoppingIsNotStopped()
{
    m_lamp->setStatus({LampState::Stopping, {}, {}, true});
    QVERIFY(m_lamp->accessibleName().contains(QStringLiteral("STOPPING")));
    m_lamp->setStatus({LampState::Stopped, {}, {}, true});
    QVERIFY(m_lamp->accessibleName().contains(QStringLiteral("STOPPED")));
}

void LampTest::stopActsOnPressWithEveryButton()
{
    QSignalSpy stop(m_stop, &StopButton::stopPressed);
    for (const Qt::MouseButton button : {Qt::LeftButton, Qt::RightButton, Qt::MiddleButton})
        QTest::mousePress(m_stop, button);
    QCOMPARE(stop.count(), 3);
    QTest::mouseRelease(m_stop, Qt::LeftButton);
    QCOMPARE(stop.count(), 3);
    QTest::mouseDClick(m_stop, Qt::LeftButton);
    QVERIFY(stop.count() >= 4);
}

void LampTest::stopCannotBeDisabled()
{
    m_stop->setEnabled(false);
    QVERIFY(m_stop->isEnabled());
    QSignalSpy stop(m_stop, &StopButton::stopPressed);
    QTest::mousePress(m_stop, Qt::LeftButton);
    QCOMPARE(stop.count(), 1);
}

void LampTest::stopIsNotInTheTabOrder()
{
    QCOMPARE(m_stop->focusPolicy(), Qt::NoFocus);
    QVERIFY(!m_stop->accessibleName().isEmpty());
}

void LampTest::assistivePressStopsAtOnce()
{
    QSignalSpy stop(m_stop, &StopButton::stopPressed);
    m_stop->click();
    QCOMPARE(stop.count(), 1);
}

MB_WINDOW_TEST(LampTest);
#include "tst_lamp.moc"
