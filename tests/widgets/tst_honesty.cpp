// SPDX-License-Identifier: GPL-3.0-or-later
// What the window says of gaps, losses, units and noise; and that nothing moves under the mouse.
#include "parameterbench.h"
#include "support/windowtests.h"
#include "widgets/common/banner.h"
#include "widgets/common/losses.h"
#include "widgets/common/valuelabel.h"
#include "widgets/connection/devicecard.h"
#include "widgets/connection/devicetree.h"
#include "widgets/control/arming.h"
#include "widgets/plots/autorange.h"
#include "widgets/plots/plotdecor.h"
#include "widgets/plots/plotstack.h"

#include <QPushButton>
#include <QTreeView>

using namespace mb;
using namespace mb::test;

class HonestyTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void noiseDoesNotFillTheStrip();
    void aStripHasTwoLabelsAtLeast();
    void gapLabelsMergeInsteadOfOverlapping();
    void wordsGiveWayToWords();
    void anIdleSetPointIsNoGap();
    void lossIsOneCount();
    void aStripOfNoticesKeepsItsHeight();
    void newRowsWaitWhileTheMouseIsOverTheTree();
    void aWindowThatHungSaysSoInWordsForPeople();
    void aStopByHandIsNoAlarm();
};

namespace {

/// A ticker as the strips use it, whose steps can be asked for.
class AskedTicker : public NumberTicker {
public:
    using NumberTicker::getTickStep;
};

DeviceView driveAt(std::uint32_t id, int address, const char *link)
{
    DeviceView device = readDrive(id, address);
    device.link = link;
    device.telemetry = std::make_shared<Telemetry>(dmc60c().channels);
    return device;
}

void addLink(Snapshot &shot, const char *address)
{
    LinkView link;
    link.address = address;
    link.name = address;
    shot.links.push_back(link);
}

} // namespace

void HonestyTest::noiseDoesNotFillTheStrip()
{
    const auto span = [](TraceRole role, double low, double high) {
        const auto range = AutoRange::fitted(low, high, leastSpan(role, std::max(std::abs(low), std::abs(high))));
        return range.upper - range.lower;
    };
    QVERIFY(span(TraceRole::Velocity, 59990, 60010) >= 20 * 10);
    QVERIFY(span(TraceRole::Current, -5e-5, 5e-5) >= 0.1);
    QVERIFY(span(TraceRole::Position, 1e6, 1e6 + 100) < 1000); // a step far from zero stays a step
    QVERIFY(span(TraceRole::Velocity, 0, 60000) < 80000);
}

void HonestyTest::aStripHasTwoLabelsAtLeast()
{
    AskedTicker ticker;
    ticker.setTickCount(2);
    for (const QCPRange range : {QCPRange(-0.9, 0.9), QCPRange(0.1, 0.9), QCPRange(59400, 60600), QCPRange(-7, 44),
             QCPRange(3, 3.7), QCPRange(-1e-3, 1e-3)}) {
        const double step = ticker.getTickStep(range);
        QVERIFY(std::floor(range.upper / step) - std::ceil(range.lower / step) >= 1);
    }
}

void HonestyTest::gapLabelsMergeInsteadOfOverlapping()
{
    QCustomPlot plot;
    plot.resize(600, 300);
    plot.xAxis->setRange(0, 60);
    plot.replot();
    const QRectF box = plot.axisRect()->rect();
    const QFontMetrics metrics(plot.font());
    StripDecor decor;
    decor.first = true;
    decor.gaps = {{10.0, 10.1}, {10.6, 10.7}, {11.2, 11.3}, {40.0, 40.5}};
    const auto labels = gapLabels(decor, *plot.xAxis, box, metrics, lightTheme());
    QCOMPARE(labels.size(), std::size_t(2));
    QVERIFY2(labels[0].text.startsWith(QStringLiteral("3 gaps, ")), qPrintable(labels[0].text));
    QVERIFY(labels[1].text.startsWith(QStringLiteral("gap ")));
    QVERIFY(!labels[0].place.intersects(labels[1].place));
}

void HonestyTest::wordsGiveWayToWords()
{
    const QRectF box(0, 0, 200, 36);
    const QRectF wanted(10, 12, 80, 12);
    QCOMPARE(freePlace(wanted, box, {}).value(), wanted);
    const QRectF beside = freePlace(wanted, box, {wanted}).value();
    QVERIFY(!beside.intersects(wanted) && box.contains(beside));
    QVERIFY(!freePlace(wanted, box, {box}));
}

void HonestyTest::anIdleSetPointIsNoGap()
{
    const ThemeSource theme(lightTheme());
    const auto summaryOf = [&theme](TraceRole role) {
        PlotStack stack(theme);
        TraceStyle style;
        style.name = QStringLiteral("x");
        style.role = role;
        stack.setStrip(0, {});
        stack.addTrace(style,
            std::make_shared<FixedTrace>(
                std::vector<PlotPoint>{{1.0, 5.0}, {2.0, 5.0}, PlotPoint::gap(2.0), {6.0, 5.0}, {7.0, 5.0}}));
        stack.resize(400, 300);
        stack.setRange(0.0, 8.0);
        stack.show();
        stack.refresh(8.0);
        return stack.summary();
    };
    QVERIFY(summaryOf(TraceRole::Velocity).contains(QStringLiteral("1 gap")));
    QVERIFY(!summaryOf(TraceRole::Setpoint).contains(QStringLiteral("gap")));
}

void HonestyTest::lossIsOneCount()
{
    Snapshot shot;
    addLink(shot, "sim:can");
    addLink(shot, "sim:serial");
    std::vector<std::shared_ptr<Telemetry>> all;
    for (const auto &[id, link] : {std::pair(1U, "sim:can"), std::pair(2U, "sim:can"), std::pair(3U, "sim:serial")}) {
        DeviceView device = driveAt(id, static_cast<int>(id), link);
        const auto telemetry = std::make_shared<Telemetry>(dmc60c().channels);
        telemetry->lost(ChannelIndex{0}, id * 10);
        telemetry->lost(ChannelIndex{1}, 1);
        telemetry->commit();
        device.telemetry = telemetry;
        shot.devices.push_back(device);
    }
    QCOMPARE(samplesOf(shot.devices[0]).lost, std::uint64_t(11));
    QCOMPARE(samplesOn(shot, "sim:can").lost, std::uint64_t(32));
    QCOMPARE(samplesOn(shot, "sim:serial").lost, std::uint64_t(31));
    QCOMPARE(samplesOn(shot).lost, std::uint64_t(63));
}

void HonestyTest::aStripOfNoticesKeepsItsHeight()
{
    const ThemeSource theme(lightTheme());
    QWidget page;
    auto *column = new QVBoxLayout(&page);
    auto *stack = new BannerStack(theme, &page);
    stack->setReserved(true);
    auto *below = new QPushButton(QStringLiteral("below"), &page);
    column->addWidget(stack);
    column->addWidget(below);
    page.resize(700, 400);
    page.show();
    QCoreApplication::processEvents();
    const QRect place = below->geometry();
    const QString longWords = QStringLiteral("words that go on and on ").repeated(20);
    for (const char *key : {"a", "b", "c"}) {
        stack->post(QString::fromLatin1(key), BannerKind::Danger, longWords, longWords, QStringLiteral("Do it"));
        QCoreApplication::processEvents();
        QCOMPARE(below->geometry(), place);
    }
    for (const char *key : {"a", "b", "c"})
        stack->clear(QString::fromLatin1(key));
    QCoreApplication::processEvents();
    QCOMPARE(below->geometry(), place);
    QVERIFY(stack->isVisible());
}

void HonestyTest::newRowsWaitWhileTheMouseIsOverTheTree()
{
    FakeWorkbench workbench;
    Selection selection;
    const ThemeSource theme(lightTheme());
    addLink(workbench.shot, "can0");
    addLink(workbench.shot, "can1");
    workbench.shot.devices = {driveAt(1, 5, "can0"), driveAt(2, 7, "can1")};
    DeviceTree tree(workbench, selection, theme);
    tree.resize(240, 600);
    tree.show();
    auto *view = tree.findChild<QTreeView *>();
    const QPersistentModelIndex under = tree.model().indexOf({2});
    const QRect place = view->visualRect(under);
    QEvent enter(QEvent::Enter);
    QCoreApplication::sendEvent(view->viewport(), &enter);
    workbench.shot.devices.insert(workbench.shot.devices.begin(), driveAt(3, 3, "can0"));
    workbench.publish();
    QCoreApplication::processEvents();
    QCOMPARE(view->visualRect(under), place);
    QVERIFY(!tree.model().indexOf({3}).isValid());
    const auto buttons = tree.findChildren<QPushButton *>();
    QVERIFY(std::any_of(buttons.begin(), buttons.end(), [](const QPushButton *button) {
        return button->isVisible() && button->text() == QStringLiteral("Show 1 new device");
    }));
    QEvent leave(QEvent::Leave);
    QCoreApplication::sendEvent(view->viewport(), &leave);
    QVERIFY(tree.model().indexOf({3}).isValid());
    QTRY_VERIFY(!view->visualRect(tree.model().indexOf({3})).isEmpty());
}

namespace {

/// Armed and running, as the engine confirms it.
struct Motion {
    FakeWorkbench workbench;
    Arming arming{workbench};

    Motion()
    {
        workbench.shot.devices.push_back(driveAt(1, 5, "can0"));
        arming.arm({1});
        arming.run({});
        workbench.device(0).motion.running = true;
        workbench.publish();
    }
};

} // namespace

void HonestyTest::aWindowThatHungSaysSoInWordsForPeople()
{
    Motion motion;
    motion.workbench.time += std::chrono::milliseconds(640);
    motion.workbench.device(0).motion.running = false;
    motion.workbench.device(0).motion.end = SetPointStream::End::LeaseExpired;
    motion.workbench.device(0).motion.reason = "nobody renewed the motion lease";
    motion.workbench.publish();
    QCOMPARE(motion.arming.state(), LampState::Stopped);
    QCOMPARE(motion.arming.reason(), QStringLiteral("this window did not respond for 0.6 s"));
    QVERIFY(!motion.arming.isStoppedByHand());
}

void HonestyTest::aStopByHandIsNoAlarm()
{
    Motion byHand;
    byHand.arming.stopAll(QStringLiteral("Esc"));
    QVERIFY(byHand.arming.isStoppedByHand());
    Motion byProgram;
    byProgram.arming.stopMoved(QStringLiteral("the window lost the focus"));
    QCOMPARE(byProgram.arming.state(), LampState::Stopped);
    QVERIFY(!byProgram.arming.isStoppedByHand());
}

MB_WINDOW_TEST(HonestyTest);
#include "tst_honesty.moc"
