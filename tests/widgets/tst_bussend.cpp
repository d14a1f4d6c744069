// SPDX-License-Identifier: GPL-3.0-or-later
// Sending frames on the Bus page as a person does it; above all, that no click alone makes a motor move.
#include "buspagebench.h"
#include "support/timers.h"
#include "support/windowtests.h"

using namespace mb;
using namespace mb::test;
using namespace std::chrono_literals;

class BusSendTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void init() { QApplication::setDoubleClickInterval(0); }
    void anOrdinaryFrameGoesByAClick();
    void successIsSaidOnlyWhenTheLinkTookIt();
    void aControlFrameNeedsArmingAndAHeldButton();
    void aShortPressSendsNoControlFrame();
    void whatIsRefusedSaysWhy();
    void stopEndsARepetitionAndStopsTheMotor();
    void aLostFocusEndsARepetitionThatMovesAMotor();
    void leavingThePageEndsARepetition();
    void aDoubleClickDoesNotEndTheRepetitionThatItBegan();
    void aLinkThatDoesNotTakeFramesEndsARepetition();
    void typedFramesAreChecked_data();
    void typedFramesAreChecked();
    void aFrameFromTheTableIsSentAgain();
};

void BusSendTest::anOrdinaryFrameGoesByAClick()
{
    BusBench bench;
    bench.type("240", "");
    QVERIFY(!bench.sendButton().isHoldNeeded());
    QTest::mouseClick(&bench.sendButton(), Qt::LeftButton);
    QCOMPARE(bench.sent(), std::size_t{1});
    const auto call = bench.workbench.given<orders::SendFrame>().front();
    QCOMPARE(call.link, std::string("sim:can"));
    QVERIFY(sameContent(call.frame, canFrameFromText("240#").value()));
    bench.type("02061805", "34 12 3D"); // PARAMREQ
    QVERIFY(bench.panelText().contains(QStringLiteral("PARAMREQ of DMC60C #5")));
    QTest::mouseClick(&bench.sendButton(), Qt::LeftButton);
    QCOMPARE(bench.sent(), std::size_t{2});
}

void BusSendTest::successIsSaidOnlyWhenTheLinkTookIt()
{
    BusBench bench;
    bench.type("123", "01 02");
    QTest::mouseClick(&bench.sendButton(), Qt::LeftButton);
    QVERIFY(!bench.panelText().contains(QStringLiteral("1 sent")));
    bench.workbench.given<orders::SendFrame>().front().finished({});
    QVERIFY(bench.panelText().contains(QStringLiteral("1 sent")));
    QTest::mouseClick(&bench.sendButton(), Qt::LeftButton);
    bench.workbench.given<orders::SendFrame>().back().finished(fail(Fault::LinkLost, say("can0 is down")));
    QVERIFY(bench.panelText().contains(QStringLiteral("can0 is down")));
}

void BusSendTest::aControlFrameNeedsArmingAndAHeldButton()
{
    BusBench bench;
    bench.type("02060005", "71 00 00 00 00 28 00 00");
    QVERIFY(bench.sendButton().isHoldNeeded());
    QVERIFY(!bench.sendButton().isEnabled());
    QVERIFY(bench.panelText().contains(QStringLiteral("DMC60C #5 is not armed")));
    bench.hold(50);
    bench.arming.arm({2}); // another one helps nothing
    QVERIFY(!bench.sendButton().isEnabled());
    bench.arming.arm({1});
    QVERIFY(bench.sendButton().isEnabled());
    QVERIFY(bench.panelText().contains(QStringLiteral("Makes a motor move: CANCTRL0 of DMC60C #5")));
    QTest::mouseClick(&bench.sendButton(), Qt::LeftButton);
    QTest::keyClick(&bench.sendButton(), Qt::Key_Space);
    QTest::keyClick(&bench.sendButton(), Qt::Key_Return);
    bench.sendButton().click();
    bench.sendButton().animateClick(1);
    passTimers(20ms);
    QCOMPARE(bench.sent(), std::size_t{0});
    QCOMPARE(bench.sendButton().holdMilliseconds(), 1000);
    bench.sendButton().setHoldMilliseconds(40);
    QVERIFY(bench.holdUntil([&bench] { return bench.sent() > 0; }));
    QCOMPARE(bench.sent(), std::size_t{1});
    QVERIFY(
        sameContent(bench.workbench.given<orders::SendFrame>().front().frame, canFrameFromText(controlOf5).value()));
}

void BusSendTest::aShortPressSendsNoControlFrame()
{
    BusBench bench;
    bench.arming.arm({1});
    bench.type("02060005", "71 00 00 00 00 28 00 00");
    bench.sendButton().setHoldMilliseconds(60'000);
    bench.hold(40);
    bench.sendButton().setHoldMilliseconds(400);
    QTest::mousePress(&bench.sendButton(), Qt::LeftButton);
    bench.arming.stopAll(QStringLiteral("test")); // STOP while it is held
    passTimers(500ms);
    QTest::mouseRelease(&bench.sendButton(), Qt::LeftButton);
    QCOMPARE(bench.sent(), std::size_t{0});
}

void BusSendTest::whatIsRefusedSaysWhy()
{
    BusBench bench;
    bench.arming.arm({1});
    bench.workbench.device(0).busy = say("firmware update");
    bench.type("02060005", "71 00 00 00 00 28 00 00");
    QVERIFY(!bench.sendButton().isEnabled());
    QVERIFY(bench.panelText().contains(QStringLiteral("DMC60C #5 is busy: firmware update")));
}

void BusSendTest::stopEndsARepetitionAndStopsTheMotor()
{
    BusBench bench;
    bench.arming.arm({1});
    bench.type("02060005", "71 00 00 00 00 28 00 00");
    bench.page->findChild<QCheckBox *>()->setChecked(true);
    bench.named<QSpinBox>("Period")->setValue(5);
    bench.sendButton().setHoldMilliseconds(1);
    std::size_t answered = 0;
    const auto someWent = [&] {
        const auto calls = bench.workbench.given<orders::SendFrame>();
        for (; answered < calls.size(); ++answered) // else the panel gives up after fifty
            calls[answered].finished({});
        return answered > 3;
    };
    QVERIFY(bench.holdUntil(someWent));
    QVERIFY(bench.panel().isRepeating());
    QVERIFY(bench.workbench.given<orders::StopMotion>().empty());
    bench.arming.stopAll(QStringLiteral("test"));
    QVERIFY(!bench.panel().isRepeating());
    QCOMPARE(bench.workbench.given<orders::StopMotion>().size(), std::size_t{1});
    QCOMPARE(bench.workbench.given<orders::StopMotion>().front().device.value, 1U);
}

void BusSendTest::aLostFocusEndsARepetitionThatMovesAMotor()
{
    BusBench bench;
    bench.arming.arm({1});
    bench.type("02060005", "71 00 00 00 00 28 00 00");
    bench.page->findChild<QCheckBox *>()->setChecked(true);
    bench.sendButton().setHoldMilliseconds(1);
    QVERIFY(bench.holdUntil([&bench] { return bench.panel().isRepeating(); }));
    Q_EMIT qApp->applicationStateChanged(Qt::ApplicationInactive);
    QVERIFY(!bench.panel().isRepeating());
    QCOMPARE(bench.workbench.given<orders::StopMotion>().size(), std::size_t{1});
    bench.type("123", "00"); // moves nothing, and may go on behind another window
    QTest::mouseClick(&bench.sendButton(), Qt::LeftButton);
    Q_EMIT qApp->applicationStateChanged(Qt::ApplicationInactive);
    QVERIFY(bench.panel().isRepeating());
}

void BusSendTest::leavingThePageEndsARepetition()
{
    BusBench bench;
    bench.type("123", "00");
    bench.page->findChild<QCheckBox *>()->setChecked(true);
    QTest::mouseClick(&bench.sendButton(), Qt::LeftButton);
    QVERIFY(bench.panel().isRepeating());
    bench.page->hide();
    QVERIFY(!bench.panel().isRepeating());
    QVERIFY(bench.workbench.given<orders::StopMotion>().empty()); // it moved nothing
}

void BusSendTest::aDoubleClickDoesNotEndTheRepetitionThatItBegan()
{
    BusBench bench;
    bench.type("123", "00");
    bench.page->findChild<QCheckBox *>()->setChecked(true);
    QApplication::setDoubleClickInterval(60'000);
    QTest::mouseClick(&bench.sendButton(), Qt::LeftButton);
    QTest::mouseClick(&bench.sendButton(), Qt::LeftButton);
    QVERIFY(bench.panel().isRepeating());
}

void BusSendTest::aLinkThatDoesNotTakeFramesEndsARepetition()
{
    BusBench bench;
    bench.type("123", "00");
    bench.page->findChild<QCheckBox *>()->setChecked(true);
    bench.named<QSpinBox>("Period")->setValue(5);
    QTest::mouseClick(&bench.sendButton(), Qt::LeftButton);
    QTRY_VERIFY(!bench.panel().isRepeating()); // the fake workbench never says that a frame went
    QCOMPARE(bench.sent(), std::size_t{50});
    QVERIFY(bench.panelText().contains(QStringLiteral("does not take frames")));
}

void BusSendTest::typedFramesAreChecked_data()
{
    QTest::addColumn<QString>("id");
    QTest::addColumn<bool>("extended");
    QTest::addColumn<QString>("data");
    QTest::addColumn<QString>("result");
    const auto row = [](const char *id, bool extended, const char *data, const char *result) {
        QTest::newRow(result) << QString::fromLatin1(id) << extended << QString::fromLatin1(data)
                              << QString::fromLatin1(result);
    };
    row("7FF", false, "", "7FF#");
    row("0x123", false, "0a 0B.0c", "123#0A0B0C");
    row("123", true, "00", "00000123#00");
    row("02061405#8125", false, "", "02061405#8125");
    row("(1.0) can0 123#R", true, "", "123#R");
    row("800", false, "", "has more than 11 bits: choose 29 bits");
    row("20000000", true, "", "has more than 29 bits");
    row("12G", false, "", "is hexadecimal");
    row("123", false, "123", "pairs of hexadecimal digits");
    row("123", false, "00 11 22 33 44 55 66 77 88", "at most 8");
    row("123#0", false, "", "is no frame such as");
}

void BusSendTest::typedFramesAreChecked()
{
    QFETCH(QString, id);
    QFETCH(bool, extended);
    QFETCH(QString, data);
    QFETCH(QString, result);
    const TypedFrame typed = readTypedFrame(id, extended, data);
    const QString got = typed.frame ? QString::fromStdString(toText(*typed.frame)) : typed.problem;
    QVERIFY2(typed.frame ? got == result : got.contains(result), qPrintable(got));
}

void BusSendTest::aFrameFromTheTableIsSentAgain()
{
    BusBench bench;
    bench.traffic.add("123#0A0B");
    bench.publish();
    auto *table = bench.named<TrafficView>("Frames");
    table->selectRow(0);
    for (QAbstractButton *button : bench.page->findChildren<QAbstractButton *>()) {
        if (button->text().startsWith(QStringLiteral("Send again")))
            button->click();
    }
    QVERIFY(bench.panel().isVisible());
    QCOMPARE(bench.named<QLineEdit>("Identifier")->text(), QStringLiteral("123"));
    QCOMPARE(bench.named<QLineEdit>("Data")->text(), QStringLiteral("0A 0B"));
    QCOMPARE(bench.sent(), std::size_t{0});
}

MB_WINDOW_TEST(BusSendTest);
#include "tst_bussend.moc"
