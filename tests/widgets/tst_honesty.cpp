// SPDX-License-Identifier: GPL-3.0-or-later
// What the window says of gaps, losses, units and noise; and that nothing moves under the mouse.
#include "parameterbench.h"
#include "support/utf8.h"
#include "support/windowtests.h"
#include "widgets/common/displayunits.h"
#include "widgets/common/headerbar.h"
#include "widgets/common/losses.h"
#include "widgets/common/noticestrip.h"
#include "widgets/common/valuelabel.h"
#include "widgets/connection/devicecard.h"
#include "widgets/connection/devicetree.h"
#include "widgets/control/arming.h"
#include "widgets/plots/autorange.h"
#include "widgets/plots/fixedtrace.h"
#include "widgets/plots/plotlabels.h"
#include "widgets/plots/plotstack.h"
#include "widgets/plots/plottickers.h"
#include "widgets/plots/telemetrysource.h"

#include <QPushButton>
#include <QTreeView>

#include <algorithm>

using namespace mb;
using namespace mb::test;

class HonestyTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void noiseDoesNotFillTheStrip();
    void noMoreDigitsAreSaidThanMeanSomething();
    void aStripHasTwoLabelsAtLeast();
    void gapLabelsMergeInsteadOfOverlapping();
    void wordsGiveWayToWords();
    void wordsInAStripNeverOverlap_data();
    void wordsInAStripNeverOverlap();
    void anIdleSetPointIsNoGap();
    void aLineThatBeginsAnewIsNoGap_data();
    void aLineThatBeginsAnewIsNoGap();
    void lossIsOneCount();
    void aStripOfNoticesKeepsItsHeight_data();
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
    QVERIFY(span(TraceRole::Duty, 0.0, 0.0) >= 1.0); // in %, as it is shown
}

void HonestyTest::noMoreDigitsAreSaidThanMeanSomething()
{
    ThemeSource theme{darkTheme()};
    PlotStack stack(theme);
    stack.resize(600, 300);
    stack.show();
    const auto still = std::make_shared<FixedTrace>(std::vector<PlotPoint>{{0, 0}, {3, 0}});
    TraceStyle counts{s("position"), s("counts"), TraceRole::Position, 0};
    counts.mostDecimals = mostDecimals(Quantity::Position, shownUnit(Quantity::Position, "counts", {}));
    TraceStyle duty{s("duty"), s("%"), TraceRole::Duty, 1};
    duty.mostDecimals = mostDecimals(Quantity::Duty, shownUnit(Quantity::Duty, "fraction", {}));
    stack.strips().addTrace(counts, still);
    stack.strips().addTrace(duty, still);
    stack.view().setRange(0, 3);
    stack.refresh(0);
    QCOMPARE(stack.readings().valueText(counts, 0.0), QString::fromUtf8("0\u00A0counts"));
    QCOMPARE(stack.readings().valueText(duty, 0.0), QString::fromUtf8("0.0\u00A0%"));
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

void HonestyTest::wordsInAStripNeverOverlap_data()
{
    QTest::addColumn<QSize>("size");
    QTest::newRow("large") << QSize(900, 500);
    QTest::newRow("flat") << QSize(600, 120);
    QTest::newRow("narrow") << QSize(180, 300);
}

void HonestyTest::wordsInAStripNeverOverlap()
{
    QFETCH(QSize, size);
    QCustomPlot plot;
    plot.resize(size);
    plot.xAxis->setRange(0, 10);
    plot.yAxis->setRange(0, 100);
    plot.replot();
    const Theme theme = lightTheme();
    const QRectF box = plot.axisRect()->rect();
    StripDecor decor;
    decor.first = true;
    decor.gaps = {{1.0, 1.2}, {5.0, 6.0}};
    decor.limits = {{60, s("peak limit 60 A"), TraceRole::Current},
        {61, s("continuous limit 61 A"), TraceRole::Current}, {99, s("highest"), TraceRole::Current}};
    decor.trigger = TriggerLine{60, s("trigger, 0.5 s before"), false};
    decor.bands = {{58, 60, s("±2 % band"), Tone::Ok}};
    decor.spans = {{0.9, 1.4, s("duty at limit, 107 ms"), TraceRole::Current},
        {1.1, 1.6, s("duty at limit, 90 ms"), TraceRole::Current},
        {5.0, 5.2, s("current at limit"), TraceRole::Current}};
    decor.notes = {{1.0, 5, s("settles 286 ms"), {12, -12}, true}, {1.1, 5, s("peak 4 %"), {12, -12}, false},
        {9.9, 60, s("settles 300 ms"), {12, -12}, false}};
    decor.marks = {{5.0, s("first")}, {5.1, s("second")}, {9.9, s("at the end")}};
    const auto words = stripWords(decor, *plot.axisRect(), plot.font(), theme);
    std::vector<QRectF> taken;
    for (const GapLabel &gap : gapLabels(decor, *plot.xAxis, box, QFontMetrics(plot.font()), theme))
        taken.push_back(gap.place);
    for (const StripWord &word : words) {
        for (const QRectF &other : taken)
            QVERIFY(!other.intersects(word.place));
        taken.push_back(word.place);
    }
    QVERIFY(!words.empty());
    const auto all
        = decor.limits.size() + 1 + decor.bands.size() + decor.spans.size() + decor.notes.size() + decor.marks.size();
    if (size.height() >= 500)
        QCOMPARE(words.size(), all); // where there is room nobody gives way
}

void HonestyTest::anIdleSetPointIsNoGap()
{
    const ThemeSource theme(lightTheme());
    const auto summaryOf = [&theme](TraceRole role) {
        PlotStack stack(theme);
        TraceStyle style;
        style.name = QStringLiteral("x");
        style.role = role;
        stack.strips().setStrip(0, {});
        stack.strips().addTrace(style,
            std::make_shared<FixedTrace>(
                std::vector<PlotPoint>{{1.0, 5.0}, {2.0, 5.0}, PlotPoint::gap(2.0), {6.0, 5.0}, {7.0, 5.0}}));
        stack.resize(400, 300);
        stack.view().setRange(0.0, 8.0);
        stack.show();
        stack.refresh(8.0);
        return stack.readings().summary();
    };
    QVERIFY(summaryOf(TraceRole::Velocity).contains(QStringLiteral("1 gap")));
    QVERIFY(!summaryOf(TraceRole::Setpoint).contains(QStringLiteral("gap")));
}

void HonestyTest::aLineThatBeginsAnewIsNoGap_data()
{
    QTest::addColumn<int>("lost");
    QTest::addColumn<int>("milliseconds");
    QTest::addColumn<bool>("isGap");
    QTest::newRow("another period") << 0 << 20 << false;
    QTest::newRow("a lost sample") << 1 << 20 << true;
    QTest::newRow("a silence") << 0 << 600 << true;
}

void HonestyTest::aLineThatBeginsAnewIsNoGap()
{
    QFETCH(int, lost);
    QFETCH(int, milliseconds);
    const auto telemetry = std::make_shared<Telemetry>(dmc60c().channels);
    Instant time{std::chrono::seconds(1)};
    const auto add = [&](int count) {
        for (int i = 0; i < count; ++i, time += std::chrono::milliseconds(10))
            telemetry->append({ChannelIndex{0}, time, 5.0});
    };
    add(50);
    telemetry->lost(ChannelIndex{0}, static_cast<std::uint64_t>(lost));
    time += std::chrono::milliseconds(milliseconds - 10);
    add(50);
    telemetry->commit();
    const ThemeSource theme(lightTheme());
    PlotStack stack(theme);
    TraceStyle style;
    style.name = QStringLiteral("x");
    style.role = TraceRole::Velocity;
    stack.strips().setStrip(0, {});
    stack.strips().addTrace(style, std::make_shared<TelemetrySource>(telemetry, ChannelIndex{0}));
    stack.resize(800, 300);
    stack.view().setRange(0.5, 3.0);
    stack.show();
    stack.refresh(3.0);
    QFETCH(bool, isGap);
    QCOMPARE(stack.readings().summary().contains(QStringLiteral("1 gap")), isGap);
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

void HonestyTest::aStripOfNoticesKeepsItsHeight_data()
{
    QTest::addColumn<int>("width");
    QTest::newRow("one line") << 1280;
    QTest::newRow("two lines") << 700;
}

void HonestyTest::aStripOfNoticesKeepsItsHeight()
{
    QFETCH(int, width);
    const ThemeSource theme(lightTheme());
    QWidget page;
    auto *column = new QVBoxLayout(&page);
    auto *strip = new NoticeStrip(theme, &page);
    auto *below = new QPushButton(QStringLiteral("below"), &page);
    column->addWidget(strip);
    column->addWidget(below);
    page.resize(width, 400);
    page.show();
    QCoreApplication::processEvents();
    const QRect place = below->geometry();
    const QString longWords = QStringLiteral("words that go on and on ").repeated(20);
    const auto verifySame = [&] {
        QCoreApplication::processEvents();
        QCOMPARE(below->geometry(), place);
        QCOMPARE(page.width(), width);
    };
    strip->stripe().setSources(QStringLiteral("simulated bench"), {longWords});
    verifySame();
    for (const char *key : {"a", "b", "c"}) {
        strip->banners().post(
            QString::fromLatin1(key), BannerKind::Danger, longWords, longWords, QStringLiteral("Do it"));
        verifySame();
    }
    for (const QPushButton *button : strip->findChildren<QPushButton *>()) {
        if (button->isVisible()) // what can be pressed is whole
            QVERIFY(strip->rect().contains(QRect(button->mapTo(strip, QPoint()), button->size())));
    }
    for (const char *key : {"a", "b", "c"})
        strip->banners().clear(QString::fromLatin1(key));
    strip->stripe().setSources({}, {});
    verifySame();
    QVERIFY(strip->isVisible());
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
    motion.workbench.device(0).motion.reason = say("nobody renewed the motion lease");
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
