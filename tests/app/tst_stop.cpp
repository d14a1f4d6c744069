// SPDX-License-Identifier: GPL-3.0-or-later
// What ends a motion, and what may begin one: the real window against a simulated motor.
#include "windowbench.h"

#include "support/windowtests.h"
#include "widgets/common/holdbutton.h"
#include "widgets/common/scanfield.h"
#include "widgets/common/searchfield.h"
#include "widgets/control/tunepage.h"
#include "widgets/parameters/parameterspage.h"

#include <QAbstractItemView>
#include <QComboBox>
#include <QDialog>
#include <QKeyEvent>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QSignalSpy>
#include <QTimer>
#include <QVBoxLayout>
#include <QWindow>

using namespace mb;
using namespace mb::test;

/// As a drag of the pointer: a child of where it began, whose own filter takes every key.
class KeyEater : public QObject {
public:
    using QObject::QObject;

protected:
    bool eventFilter(QObject *, QEvent *event) override
    {
        return event->type() == QEvent::KeyPress || event->type() == QEvent::ShortcutOverride;
    }
};

class StopTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void init();
    void cleanup() { m_bench.reset(); }
    void everyStopKeyStopsTheMotor_data();
    void everyStopKeyStopsTheMotor();
    void aDragDoesNotTakeTheStopKeys_data() { everyStopKeyStopsTheMotor_data(); }
    void aDragDoesNotTakeTheStopKeys();
    void spaceIsTextWhereTextIsEditedAndEscStillStops();
    void spaceStopsInAFieldForNumbers();
    void spaceStopsWhateverIsHeldWithItAndPressesNoButton_data();
    void spaceStopsWhateverIsHeldWithItAndPressesNoButton();
    void spaceThatIsHeldTicksNothingAndOpensNothing();
    void spaceIsTextInProductionOnlyWhileAScannerTypes();
    void theButtonStopsOnPress();
    void closingTheWindowStops();
    void aWindowThatHangsStopsTheMotor();
    void nothingMovesUnarmed();
    void holdingTheLampArms();
    void lettingTheLampGoEarlyDoesNotArm();
    void aStopEndsWhatIsHeldToArmOrToBegin();
    void enterHeldIsAHoldAndATapIsNone();
    void holdingTheArmKeysArms();
    void lettingAnyOfTheArmKeysGoEarlyDoesNothing_data();
    void lettingAnyOfTheArmKeysGoEarlyDoesNothing();
    void theArmKeysDoNothingBehindADialogOrWhileArmed();
    void aUnitInItsBootloaderCannotBeArmed();

private:
    void drive();
    /// The motor stands because somebody said STOP, not because the lease ran out.
    void verifyStopped(const QString &reason);

    std::unique_ptr<WindowBench> m_bench;
};

void StopTest::init()
{
    m_bench = std::make_unique<WindowBench>();
    QTRY_VERIFY_WITH_TIMEOUT(m_bench->isFound(), patience);
    m_bench->select(WindowBench::tuned);
    m_bench->window().showPage(PageId::Tune);
}

void StopTest::drive()
{
    m_bench->arming().arm(m_bench->device(WindowBench::tuned)->id);
    m_bench->run();
    QTRY_VERIFY_WITH_TIMEOUT(m_bench->isOutputOn(), patience);
    QTRY_VERIFY_WITH_TIMEOUT(m_bench->device(WindowBench::tuned)->motion.running, patience);
}

void StopTest::verifyStopped(const QString &reason)
{
    QTRY_VERIFY_WITH_TIMEOUT(!m_bench->isOutputOn(), patience);
    QCOMPARE(m_bench->arming().state(), LampState::Stopped);
    QCOMPARE(m_bench->arming().reason(), reason);
    QTRY_VERIFY_WITH_TIMEOUT(!m_bench->device(WindowBench::tuned)->motion.running, patience);
    QVERIFY(m_bench->device(WindowBench::tuned)->motion.end == SetPointStream::End::Stopped);
    m_bench->run(); // latched
    QCOMPARE(m_bench->arming().state(), LampState::Stopped);
}

void StopTest::everyStopKeyStopsTheMotor_data()
{
    QTest::addColumn<int>("key");
    QTest::addColumn<QString>("name");
    QTest::newRow("Esc") << static_cast<int>(Qt::Key_Escape) << QStringLiteral("Esc");
    QTest::newRow("Pause") << static_cast<int>(Qt::Key_Pause) << QStringLiteral("Pause");
    QTest::newRow("Space") << static_cast<int>(Qt::Key_Space) << QStringLiteral("Space");
}

void StopTest::everyStopKeyStopsTheMotor()
{
    QFETCH(int, key);
    QFETCH(QString, name);
    drive();
    QTest::keyPress(m_bench->window().windowHandle(), static_cast<Qt::Key>(key));
    verifyStopped(name);
}

void StopTest::aDragDoesNotTakeTheStopKeys()
{
    QFETCH(int, key);
    QFETCH(QString, name);
    drive();
    KeyEater drag(&m_bench->window());
    qApp->installEventFilter(&drag);
    QCoreApplication::processEvents(); // of the drag
    QTest::keyPress(m_bench->window().windowHandle(), static_cast<Qt::Key>(key));
    verifyStopped(name);
}

void StopTest::spaceIsTextWhereTextIsEditedAndEscStillStops()
{
    auto &field = *m_bench->page<ParametersPage>(PageId::Parameters).findChild<SearchField *>();
    QTRY_VERIFY_WITH_TIMEOUT(field.isVisible(), patience);
    drive();
    field.setFocus();
    QVERIFY(field.hasFocus());
    QTest::keyClick(m_bench->window().windowHandle(), Qt::Key_Space);
    QCOMPARE(field.text(), QStringLiteral(" "));
    QVERIFY(m_bench->arming().isMoving());
    QVERIFY(m_bench->isOutputOn());
    QTest::keyPress(m_bench->window().windowHandle(), Qt::Key_Escape);
    verifyStopped(QStringLiteral("Esc"));
}

void StopTest::spaceStopsInAFieldForNumbers()
{
    m_bench->page<TunePage>(PageId::Tune).showLive(true);
    drive();
    QLineEdit *field = nullptr;
    for (auto *candidate : m_bench->window().findChildren<QLineEdit *>()) {
        if (candidate->accessibleName() == QStringLiteral("Set-point"))
            field = candidate;
    }
    QVERIFY(field && field->isVisible());
    field->setFocus();
    field->selectAll();
    QTest::keyClicks(field, QStringLiteral("250"));
    QCOMPARE(field->text(), QStringLiteral("250"));
    QTest::keyClick(m_bench->window().windowHandle(), Qt::Key_Space);
    QCOMPARE(field->text(), QStringLiteral("250"));
    verifyStopped(QStringLiteral("Space"));
}

void StopTest::spaceStopsWhateverIsHeldWithItAndPressesNoButton_data()
{
    QTest::addColumn<int>("held");
    QTest::newRow("Shift") << static_cast<int>(Qt::ShiftModifier);
    QTest::newRow("Ctrl") << static_cast<int>(Qt::ControlModifier);
    QTest::newRow("Alt") << static_cast<int>(Qt::AltModifier);
    QTest::newRow("Meta") << static_cast<int>(Qt::MetaModifier);
    QTest::newRow("keypad") << static_cast<int>(Qt::KeypadModifier);
}

void StopTest::spaceStopsWhateverIsHeldWithItAndPressesNoButton()
{
    QFETCH(const int, held);
    QPushButton button(&m_bench->window());
    button.show();
    drive();
    button.setFocus();
    QVERIFY(button.hasFocus());
    QSignalSpy pressed(&button, &QPushButton::pressed);
    QTest::keyClick(m_bench->window().windowHandle(), Qt::Key_Space, static_cast<Qt::KeyboardModifier>(held));
    QVERIFY(pressed.isEmpty());
    verifyStopped(QStringLiteral("Space"));
}

void StopTest::spaceThatIsHeldTicksNothingAndOpensNothing()
{
    QListWidget list(&m_bench->window());
    list.addItem(QStringLiteral("unit"));
    list.item(0)->setCheckState(Qt::Unchecked);
    list.setCurrentRow(0);
    QComboBox box(&m_bench->window());
    box.addItems({QStringLiteral("a"), QStringLiteral("b")});
    drive();
    for (QWidget *const focus : {static_cast<QWidget *>(&list), static_cast<QWidget *>(&box)}) {
        focus->show();
        focus->setFocus();
        QVERIFY(focus->hasFocus());
        for (const bool again : {false, true, true, true}) {
            QKeyEvent press(QEvent::KeyPress, Qt::Key_Space, Qt::NoModifier, QStringLiteral(" "), again);
            QApplication::sendEvent(focus, &press);
        }
    }
    QCOMPARE(list.item(0)->checkState(), Qt::Unchecked);
    QVERIFY(!box.view()->isVisible());
    verifyStopped(QStringLiteral("Space"));
}

void StopTest::spaceIsTextInProductionOnlyWhileAScannerTypes()
{
    drive();
    QTest::keyClick(&m_bench->window(), Qt::Key_F11);
    auto &field = m_bench->part<ScanField>();
    QTRY_VERIFY(field.isVisible());
    field.setFocus();
    const auto press = [&field](int key, const QString &text, unsigned long milliseconds) {
        QKeyEvent event(QEvent::KeyPress, key, Qt::NoModifier, text);
        event.setTimestamp(milliseconds);
        QApplication::sendEvent(&field, &event);
    };
    press(Qt::Key_A, QStringLiteral("A"), 10'000);
    press(Qt::Key_Space, QStringLiteral(" "), 10'049);
    press(Qt::Key_7, QStringLiteral("7"), 10'098);
    QCOMPARE(field.text(), QStringLiteral("A 7"));
    QVERIFY(m_bench->arming().isMoving());
    press(Qt::Key_Space, QStringLiteral(" "), 10'148);
    QCOMPARE(field.text(), QStringLiteral("A 7"));
    verifyStopped(QStringLiteral("Space"));
}

void StopTest::theButtonStopsOnPress()
{
    drive();
    QTest::mousePress(&m_bench->part<StopButton>(), Qt::LeftButton);
    verifyStopped(QStringLiteral("button"));
}

void StopTest::closingTheWindowStops()
{
    drive();
    QVERIFY2(!m_bench->window().close(), "it stays until the motor is seen stopped");
    QTRY_VERIFY_WITH_TIMEOUT(!m_bench->window().isVisible(), patience);
    QVERIFY(!m_bench->isOutputOn());
    QCOMPARE(m_bench->arming().state(), LampState::Safe);
}

void StopTest::aWindowThatHangsStopsTheMotor()
{
    drive();
    const Instant limit = m_bench->engine().now() + std::chrono::milliseconds(patience);
    while (m_bench->isOutputOn() && m_bench->engine().now() < limit) { } // no event of the window is served here
    QVERIFY(!m_bench->isOutputOn());
    QTRY_COMPARE_WITH_TIMEOUT(m_bench->arming().state(), LampState::Stopped, patience);
    QVERIFY(m_bench->device(WindowBench::tuned)->motion.end == SetPointStream::End::LeaseExpired);
    QVERIFY2(!m_bench->isOutputOn(), "a window that comes back must not start the motor again");
}

void StopTest::nothingMovesUnarmed()
{
    m_bench->run();
    auto *tune = qobject_cast<TunePage *>(m_bench->window().page(PageId::Tune));
    tune->showLive(true);
    tune->run();
    const auto before = m_bench->engine().snapshot().time;
    QTRY_VERIFY_WITH_TIMEOUT(m_bench->engine().snapshot().time > before + std::chrono::milliseconds(200), patience);
    QVERIFY(!m_bench->isOutputOn());
    QCOMPARE(m_bench->arming().state(), LampState::Safe);
    QVERIFY(m_bench->device(WindowBench::tuned)->motion.end == SetPointStream::End::None);
}

void StopTest::holdingTheLampArms()
{
    auto &lamp = m_bench->part<Lamp>();
    lamp.setHoldMilliseconds(50);
    QTRY_VERIFY_WITH_TIMEOUT(lamp.status().armable, patience);
    QTest::mousePress(&lamp, Qt::LeftButton);
    QTRY_COMPARE_WITH_TIMEOUT(m_bench->arming().state(), LampState::Armed, patience);
    QTest::mouseRelease(&lamp, Qt::LeftButton);
    QVERIFY(m_bench->arming().isArmed(m_bench->device(WindowBench::tuned)->id));
    QVERIFY(!m_bench->isOutputOn());
    QTest::mousePress(&lamp, Qt::LeftButton);
    QCOMPARE(m_bench->arming().state(), LampState::Safe);
}

void StopTest::lettingTheLampGoEarlyDoesNotArm()
{
    auto &lamp = m_bench->part<Lamp>();
    QCOMPARE(lamp.holdMilliseconds(), 1000);
    lamp.setHoldMilliseconds(600'000);
    QTRY_VERIFY_WITH_TIMEOUT(lamp.status().armable, patience);
    QTest::mousePress(&lamp, Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(lamp.holdProgress() > 0.0, patience);
    QTest::mouseRelease(&lamp, Qt::LeftButton);
    QCOMPARE(lamp.holdProgress(), 0.0);
    QCOMPARE(m_bench->arming().state(), LampState::Safe);
}

void StopTest::aStopEndsWhatIsHeldToArmOrToBegin()
{
    auto &lamp = m_bench->part<Lamp>();
    lamp.setHoldMilliseconds(600'000);
    QTRY_VERIFY_WITH_TIMEOUT(lamp.status().armable, patience);
    QTest::mousePress(&lamp, Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(lamp.holdProgress() > 0.0, patience);
    QTest::keyPress(m_bench->window().windowHandle(), Qt::Key_Pause);
    QCOMPARE(lamp.holdProgress(), 0.0);
    QTest::mouseRelease(&lamp, Qt::LeftButton);

    const ThemeSource theme(darkTheme());
    QDialog dialog(&m_bench->window());
    HoldButton begin(theme, Symbol::Play, QStringLiteral("Turn"), &dialog);
    begin.setHoldNeeded(true);
    begin.setHoldMilliseconds(600'000);
    dialog.show();
    QTest::mousePress(&begin, Qt::LeftButton);
    QVERIFY(begin.isDown());
    QTest::mousePress(&m_bench->part<StopButton>(), Qt::LeftButton);
    QVERIFY(!begin.isDown());
}

void StopTest::enterHeldIsAHoldAndATapIsNone()
{
    const ThemeSource theme(darkTheme());
    QDialog dialog(&m_bench->window());
    auto *const column = new QVBoxLayout(&dialog);
    QLineEdit field;
    HoldButton begin(theme, Symbol::Play, QStringLiteral("Turn"));
    column->addWidget(&field);
    column->addWidget(&begin);
    begin.setHoldNeeded(true);
    begin.setHoldMilliseconds(60);
    const QSignalSpy begun(&begin, &HoldButton::activated);
    dialog.show();
    QApplication::setActiveWindow(&dialog);
    const auto wait = [] {
        QTimer later; // than a hold would have ended
        later.start(200);
        QSignalSpy(&later, &QTimer::timeout).wait();
    };
    field.setFocus();
    QTest::keyClick(&field, Qt::Key_Return);
    wait();
    QVERIFY2(begun.isEmpty(), "it is nobody's default button");
    begin.setFocus();
    QTest::keyClick(&begin, Qt::Key_Return);
    wait();
    QVERIFY2(begun.isEmpty(), "it was not held");
    QTest::keyPress(&begin, Qt::Key_Return);
    QTRY_COMPARE(begun.count(), 1);
    QTest::keyRelease(&begin, Qt::Key_Return);
    begin.setHoldNeeded(false);
    QTest::keyClick(&begin, Qt::Key_Return);
    QTRY_COMPARE(begun.count(), 2);
}

void StopTest::holdingTheArmKeysArms()
{
    Lamp &lamp = m_bench->part<Lamp>();
    lamp.setHoldMilliseconds(50);
    QTest::keyPress(&m_bench->window(), Qt::Key_F12, Qt::ControlModifier | Qt::ShiftModifier);
    QTRY_COMPARE_WITH_TIMEOUT(m_bench->arming().state(), LampState::Armed, patience);
    QTest::keyRelease(&m_bench->window(), Qt::Key_F12, Qt::ControlModifier | Qt::ShiftModifier);
    QCOMPARE(m_bench->arming().state(), LampState::Armed);
}

void StopTest::lettingAnyOfTheArmKeysGoEarlyDoesNothing_data()
{
    QTest::addColumn<int>("key");
    QTest::newRow("F12") << static_cast<int>(Qt::Key_F12);
    QTest::newRow("Ctrl") << static_cast<int>(Qt::Key_Control);
    QTest::newRow("Shift") << static_cast<int>(Qt::Key_Shift);
}

void StopTest::lettingAnyOfTheArmKeysGoEarlyDoesNothing()
{
    QFETCH(int, key);
    Lamp &lamp = m_bench->part<Lamp>();
    lamp.setHoldMilliseconds(60'000);
    QSignalSpy holding(&lamp, &Lamp::holdingChanged);
    QSignalSpy asked(&lamp, &Lamp::armRequested);
    QTest::keyPress(&m_bench->window(), Qt::Key_F12, Qt::ControlModifier | Qt::ShiftModifier);
    QCOMPARE(holding.count(), 1);
    QTest::keyRelease(&m_bench->window(), static_cast<Qt::Key>(key), Qt::ControlModifier | Qt::ShiftModifier);
    QCOMPARE(holding.count(), 2);
    QCOMPARE(asked.count(), 0);
    QCOMPARE(m_bench->arming().state(), LampState::Safe);
}

void StopTest::theArmKeysDoNothingBehindADialogOrWhileArmed()
{
    Lamp &lamp = m_bench->part<Lamp>();
    QSignalSpy holding(&lamp, &Lamp::holdingChanged);
    {
        QDialog dialog(&m_bench->window());
        dialog.setModal(true);
        dialog.show();
        QTest::keyPress(&m_bench->window(), Qt::Key_F12, Qt::ControlModifier | Qt::ShiftModifier);
        QTest::keyRelease(&m_bench->window(), Qt::Key_F12, Qt::ControlModifier | Qt::ShiftModifier);
    }
    QTest::keyPress(&m_bench->window(), Qt::Key_F12, Qt::ControlModifier); // two of three
    QTest::keyPress(&m_bench->window(), Qt::Key_F12, Qt::ControlModifier | Qt::ShiftModifier | Qt::AltModifier);
    QCOMPARE(holding.count(), 0);
    m_bench->arming().arm(m_bench->device(WindowBench::tuned)->id);
    QTRY_COMPARE_WITH_TIMEOUT(m_bench->arming().state(), LampState::Armed, patience);
    QApplication::setActiveWindow(&m_bench->window());
    QTest::keyPress(&m_bench->window(), Qt::Key_F12, Qt::ControlModifier | Qt::ShiftModifier);
    QCOMPARE(holding.count(), 0);
    QCOMPARE(m_bench->arming().state(), LampState::Armed);
}

void StopTest::aUnitInItsBootloaderCannotBeArmed()
{
    m_bench->select(WindowBench::inBootloader);
    m_bench->arming().arm(m_bench->device(WindowBench::inBootloader)->id);
    QCOMPARE(m_bench->arming().state(), LampState::Safe);
    QVERIFY(!m_bench->part<Lamp>().status().armable);
}

MB_WINDOW_TEST(StopTest);
#include "tst_stop.moc"
