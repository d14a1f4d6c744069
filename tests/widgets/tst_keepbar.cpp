// SPDX-License-Identifier: GPL-3.0-or-later
// Values that go back unless somebody keeps them, as the window asks.
#include "model/unit.h"
#include "support/fakeworkbench.h"
#include "support/windowtests.h"
#include "widgets/common/iconbutton.h"
#include "widgets/common/theme.h"
#include "widgets/parameters/keepbar.h"

#include <QApplication>
#include <QLabel>
#include <QMouseEvent>
#include <QProgressBar>
#include <QPushButton>
#include <QTest>

#include <tuple>
#include <utility>

using namespace mb;
using namespace mb::test;

namespace {

struct KeepBench {
    FakeWorkbench workbench;
    ThemeSource theme{darkTheme()};
    QWidget window;
    KeepBar bar{workbench, theme, &window};

    KeepBench()
    {
        window.resize(1200, 80);
        bar.resize(1200, 60);
        window.show();
        QApplication::setActiveWindow(&window);
    }
    void wait(std::int64_t change, UnconfirmedView::State state, double left, std::string unit = {})
    {
        workbench.shot.unconfirmed.push_back(
            {{1}, change, say("%1: %2 → %3", "current_limit.peak", 60, 80), state, left, std::move(unit)});
        workbench.publish();
    }
};

} // namespace

class TestKeepBar : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void init() { QApplication::setDoubleClickInterval(0); }
    void thereIsNoneWhileNothingWaits();
    void theTimeIsSaidAndShown();
    void theTimeIsNeverCut();
    void keepAndPutBackAreOrders();
    void whatGoesFirstIsAskedFirst();
    void theKeyKeepsOnlyWhatIsAsked();
    void whatNobodyHasReadIsNotKept();
    void aPressThatIsHeldIsForTheChangeThatItWasMadeOn();
    void whatIsLeftOverOfAPlaceIsSaidToBeSo();
};

void TestKeepBar::thereIsNoneWhileNothingWaits()
{
    KeepBench bench;
    QVERIFY(bench.bar.isHidden());
    bench.wait(4, UnconfirmedView::State::Counting, 18.0);
    QVERIFY(!bench.bar.isHidden());
    bench.workbench.shot.unconfirmed.clear();
    bench.workbench.publish();
    QVERIFY(bench.bar.isHidden());
}

void TestKeepBar::theTimeIsSaidAndShown()
{
    KeepBench bench;
    bench.wait(4, UnconfirmedView::State::Counting, 17.4);
    QVERIFY2(bench.bar.question().contains(QStringLiteral("18 s")), qPrintable(bench.bar.question()));
    auto *time = bench.bar.findChild<QProgressBar *>();
    QCOMPARE(time->value(), 17400);
    QCOMPARE(time->maximum(), 30000);
    QVERIFY(!time->accessibleName().isEmpty());
    QVERIFY(bench.bar.accessibleDescription().contains(QStringLiteral("60 → 80")));
}

void TestKeepBar::theTimeIsNeverCut()
{
    KeepBench bench;
    bench.wait(4, UnconfirmedView::State::Counting, 17.4);
    bench.bar.resize(320, 60);
    QTest::qWait(0);
    const auto labels = bench.bar.findChildren<QLabel *>();
    const auto time = std::find_if(labels.begin(), labels.end(),
        [](const QLabel *label) { return label->text().contains(QStringLiteral("18 s")); });
    QVERIFY(time != labels.end());
    const int needed = QFontMetrics((*time)->font()).horizontalAdvance((*time)->text());
    const int right = (*time)->mapTo(&bench.bar, QPoint(0, 0)).x() + needed;
    QVERIFY2((*time)->width() >= needed && right <= bench.bar.width(),
        qPrintable(QStringLiteral("%1 px for %2").arg((*time)->width()).arg(needed)));
}

void TestKeepBar::keepAndPutBackAreOrders()
{
    KeepBench bench;
    bench.wait(4, UnconfirmedView::State::Counting, 17.4);
    for (auto *button : bench.bar.findChildren<QPushButton *>())
        button->click();
    const auto kept = bench.workbench.given<orders::KeepChange>();
    const auto back = bench.workbench.given<orders::PutBackChange>();
    QCOMPARE(kept.size(), 1U);
    QCOMPARE(kept.front().change, 4);
    QVERIFY(kept.front().device == DeviceId{1});
    QCOMPARE(back.size(), 1U);
    QCOMPARE(back.front().change, 4);
}

void TestKeepBar::whatGoesFirstIsAskedFirst()
{
    KeepBench bench;
    bench.wait(4, UnconfirmedView::State::Offered, 0.0);
    bench.wait(6, UnconfirmedView::State::Counting, 20.0);
    bench.wait(5, UnconfirmedView::State::Counting, 10.0);
    bench.bar.keep();
    QCOMPARE(bench.workbench.given<orders::KeepChange>().front().change, 5);
}

void TestKeepBar::theKeyKeepsOnlyWhatIsAsked()
{
    KeepBench bench;
    QTest::keyClick(&bench.window, Qt::Key_Return, Qt::ControlModifier);
    QVERIFY(bench.workbench.given<orders::KeepChange>().empty());
    bench.wait(4, UnconfirmedView::State::AwaitsStandstill, 0.0);
    QTest::keyClick(&bench.window, Qt::Key_Return, Qt::ControlModifier);
    QCOMPARE(bench.workbench.given<orders::KeepChange>().size(), 1U);
}

void TestKeepBar::whatNobodyHasReadIsNotKept()
{
    KeepBench bench;
    for (std::int64_t change = 4; change <= 8; ++change)
        bench.wait(change, UnconfirmedView::State::Counting, static_cast<double>(change));
    const auto buttons = bench.bar.findChildren<CommandButton *>(); // Keep, Revert
    const auto orderAll = [&bench, &buttons] {
        for (CommandButton *button : buttons)
            QTest::mouseClick(button, Qt::LeftButton);
        QTest::keyClick(&bench.window, Qt::Key_Return, Qt::ControlModifier);
    };
    orderAll();
    QCOMPARE(bench.workbench.sent.size(), 3U);
    QTest::simulateEvent(&bench.window, true, Qt::Key_Return, Qt::ControlModifier, {}, true);
    QCOMPARE(bench.workbench.sent.size(), 3U); // a key that is held is pressed once
    QApplication::setDoubleClickInterval(60'000);
    bench.workbench.shot.unconfirmed.erase(bench.workbench.shot.unconfirmed.begin());
    bench.workbench.publish();
    QCOMPARE(bench.bar.question().contains(QStringLiteral("5 s")), true);
    orderAll();
    QCOMPARE(bench.workbench.sent.size(), 3U);
}

void TestKeepBar::aPressThatIsHeldIsForTheChangeThatItWasMadeOn()
{
    KeepBench bench;
    for (std::int64_t change = 4; change <= 6; ++change)
        bench.wait(change, UnconfirmedView::State::Counting, static_cast<double>(change));
    for (CommandButton *button : bench.bar.findChildren<CommandButton *>()) { // Keep, Revert
        QTest::mousePress(button, Qt::LeftButton);
        bench.workbench.shot.unconfirmed.erase(bench.workbench.shot.unconfirmed.begin()); // it went back by itself
        bench.workbench.publish();
        QMouseEvent moves(QEvent::MouseMove, button->rect().center(), Qt::NoButton, Qt::LeftButton,
            Qt::NoModifier); // and is down again
        QApplication::sendEvent(button, &moves);
        QTest::mouseRelease(button, Qt::LeftButton);
    }
    QVERIFY(bench.workbench.sent.empty());
    QTest::mouseClick(bench.bar.findChild<CommandButton *>(), Qt::LeftButton);
    QCOMPARE(bench.workbench.given<orders::KeepChange>().front().change, 6);
}

void TestKeepBar::whatIsLeftOverOfAPlaceIsSaidToBeSo()
{
    const std::string place = "place usb-1.2 supermodified:4";
    for (const auto &[state, unit, isSaid] :
        {std::tuple(UnconfirmedView::State::Offered, place, true), {UnconfirmedView::State::Counting, place, false},
            {UnconfirmedView::State::Offered, taggedUnitKey(place, "left arm"), false}}) {
        KeepBench bench;
        bench.wait(4, state, 17.4, unit);
        QCOMPARE(bench.bar.accessibleDescription().startsWith(QStringLiteral("this place, not this unit")), isSaid);
    }
}

MB_WINDOW_TEST(TestKeepBar);
#include "tst_keepbar.moc"
