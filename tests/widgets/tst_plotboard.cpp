// SPDX-License-Identifier: GPL-3.0-or-later
#include "plotbench.h"
#include "support/windowtests.h"
#include "widgets/common/numberfield.h"
#include "widgets/plots/plottickers.h"

#include <QComboBox>
#include <QSet>

using namespace mb;
using namespace mb::test;

class TestPlotBoard : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void twoDevicesInOnePlotLookDifferent();
    void aDropGoesToThePaneItWasDroppedOn();
    void aDropBelowThePanesMakesAPaneOfItsOwn();
    void theSecondAxisHasItsOwnScale();
    void statisticsOfTheSelectionAreThoseOfItsSamples();
    void numbersCanBeCopied();
    void theTriggerStandsStillAtTheEventAndGoesOn();
    void aSingleEventStays();
    void pausingDoesNotStopTheRecording();
    void theLevelCanBeDragged();
    void theLevelIsWrittenAsTheLanguageWritesNumbers();
    void aDerivedSignalIsPlottedLikeAnyOther();
    void aWrongFormulaSaysWhy();
    void referencesStayWhereTheyWereSeen();
    void theSpectrumFindsAWave();
    void oneSignalAgainstAnother();
    void anotherUnitOfAChannelIsFollowed();
    void aCursorReadsTheSampleAndNotWhatAColumnDraws();
    void aCaughtEventStaysWhenAReferenceIsKept();
    void theTriggerStaysOnItsSignalWhateverItIsCalled();
    void devicesOfOneNumberAreToldApart();
    void fittingLeavesReferencesOutOfTheTime();
    void noStretchIsShorterThanALayoutMayBe();
    void withoutTracesNothingOldIsLeftInTheOtherViews();
};

void TestPlotBoard::twoDevicesInOnePlotLookDifferent()
{
    PlotBench bench;
    bench.page->addSignal({{2}, channel("velocity")});
    bench.page->addSignal({{2}, channel("position")});
    const TraceStyle &a = bench.trace("#5 velocity").style;
    const TraceStyle &b = bench.trace("#7 velocity").style;
    QCOMPARE(a.strip, b.strip);
    QVERIFY(a.look().colourRole() != b.look().colourRole());
    QCOMPARE(markerOf(a.look()), markerOf(b.look())); // the marker still says what is measured
    std::set<std::pair<TraceRole, TraceDash>> looks;
    for (const auto &trace : bench.board().traces())
        looks.insert({trace.style.look().colourRole(), trace.style.dash});
    QCOMPARE(looks.size(), bench.board().traces().size());
}

void TestPlotBoard::aDropGoesToThePaneItWasDroppedOn()
{
    PlotBench bench;
    bench.pass(0.5, 1000.0);
    const QRect pane = bench.stack().plot().axisRect(2)->rect();
    bench.drop({{2}, channel("temperature")}, bench.stack().plot().mapTo(&bench.stack(), pane.center()));
    QCOMPARE(bench.trace("#7 temperature").style.strip, 2);
    QCOMPARE(bench.stack().plot().axisRectCount(), 4);
}

void TestPlotBoard::aDropBelowThePanesMakesAPaneOfItsOwn()
{
    PlotBench bench;
    bench.pass(0.5, 1000.0);
    bench.drop({{2}, channel("velocity")}, QPoint(bench.stack().width() / 2, bench.stack().height() - 3));
    QCOMPARE(bench.stack().plot().axisRectCount(), 5);
    QVERIFY(bench.trace("#7 velocity").style.strip != bench.trace("#5 velocity").style.strip);
}

void TestPlotBoard::theSecondAxisHasItsOwnScale()
{
    PlotBench bench;
    bench.board().moveToPane(bench.trace("#5 position").id, bench.board().paneOf(0));
    bench.board().setSecondAxis(bench.trace("#5 position").id, true);
    bench.pass(2.0, 60000.0);
    QCPAxisRect *pane = bench.stack().plot().axisRect(0);
    QVERIFY(pane->axis(QCPAxis::atRight)->visible());
    QVERIFY(pane->axis(QCPAxis::atRight)->range().upper > 60000.0);
    QVERIFY(pane->axis(QCPAxis::atLeft)->range().upper < 90000.0);
    const QImage picture = bench.page->grab().toImage();
    QVERIFY(!picture.isNull());
}

void TestPlotBoard::statisticsOfTheSelectionAreThoseOfItsSamples()
{
    PlotBench bench;
    bench.pass(3.0, 60000.0);
    bench.stack().setCursorsShown(true);
    const double now = plotKey(bench.workbench.time);
    bench.stack().setCursorKeys(now - 2.0, now - 1.0);
    const auto found = bench.stack().readings().selection(bench.trace("#5 velocity").id);
    QVERIFY(found);
    QVERIFY2(found->count >= 99 && found->count <= 102, QByteArray::number(static_cast<int>(found->count)));
    QVERIFY(std::abs(found->mean - 60000.0) < 500.0);
    QVERIFY(found->low <= found->mean + 1e-6 && found->mean <= found->high + 1e-6); // of equal samples it is rounded
    const auto &rows = bench.page->findChild<TraceList *>()->rows();
    QVERIFY2(rows.front().statistics.contains(s("mean")), qPrintable(rows.front().statistics));
    const auto duty = bench.stack().readings().selection(bench.trace("#5 duty").id); // shown in percent
    QVERIFY(duty && duty->high > 5.0 && duty->high < 100.0);
}

void TestPlotBoard::numbersCanBeCopied()
{
    PlotBench bench;
    bench.pass(3.0, 60000.0);
    bench.stack().setCursorsShown(true);
    const double now = plotKey(bench.workbench.time);
    bench.stack().setCursorKeys(now - 2.0, now - 1.0);
    const QStringList lines = bench.stack().readings().numbers().split(QLatin1Char('\n'));
    QCOMPARE(lines.first().split(QLatin1Char('\t')).size(), 11);
    QVERIFY(lines.at(2).startsWith(s("#5 velocity\tcounts/s\t")));
    QCOMPARE(lines.at(2).split(QLatin1Char('\t')).size(), 11);
}

void TestPlotBoard::theTriggerStandsStillAtTheEventAndGoesOn()
{
    PlotBench bench;
    bench.pass(1.0, 0.0);
    bench.stack().view().setWindow(2.0);
    bench.page->trigger().bar().setLevel(30000.0);
    bench.page->trigger().armOn(bench.trace("#5 velocity").id);
    QVERIFY(bench.page->trigger().watch().isArmed());
    QVERIFY(!bench.page->trigger().watch().event());
    bench.pass(1.0, 60000.0);
    QTRY_VERIFY(bench.page->trigger().watch().event());
    const double event = *bench.page->trigger().watch().event();
    QVERIFY(std::abs(bench.stack().readings().valueAt(bench.trace("#5 velocity").id, event) - 30000.0) < 1500.0);
    const auto [from, to] = bench.stack().view().range();
    QVERIFY(std::abs((event - from) / (to - from) - 0.2) < 0.02); // 20 % before it
    const auto ticks
        = bench.stack().strips().all().front()->keys().ticker().dynamicCast<TimeTicker>(); // 0 is the trigger
    ticks->setClock(WallClock{});
    QCOMPARE(ticks->text(event - 0.4, 0.1), QString::fromUtf8("−0.4"));
    QCOMPARE(ticks->text(event, 0.1), s("0.0"));
    QVERIFY(ticks->showsSeconds());
    bench.pass(1.5, 0.0);
    QCOMPARE(*bench.page->trigger().watch().event(), event); // downwards is none
    bench.pass(1.0, 60000.0);
    QTRY_VERIFY(*bench.page->trigger().watch().event() > event + 1.0);
    QCOMPARE(bench.page->trigger().watch().events(), 2);
    bench.page->trigger().disarm();
    QVERIFY(ticks->text(event, 1.0) != s("0")); // the time of day again
    bench.pass(0.5, 60000.0);
    QVERIFY(bench.stack().view().range().second >= plotKey(bench.workbench.time) - 0.1);
}

void TestPlotBoard::aSingleEventStays()
{
    PlotBench bench;
    bench.pass(1.0, 0.0);
    bench.stack().view().setWindow(1.0);
    auto *mode = bench.page->trigger().bar().findChild<Segmented *>();
    bench.page->trigger().bar().setLevel(30000.0);
    bench.page->trigger().armOn(bench.trace("#5 velocity").id);
    mode->setCurrent(1);
    for (int i = 0; i < 3; ++i) {
        bench.pass(1.5, 60000.0);
        bench.pass(1.5, 0.0);
    }
    QVERIFY(bench.page->trigger().watch().isDone());
    QCOMPARE(bench.page->trigger().watch().events(), 1);
    QVERIFY(*bench.page->trigger().watch().event() < 1003.0);
}

void TestPlotBoard::pausingDoesNotStopTheRecording()
{
    PlotBench bench;
    bench.pass(1.0, 1000.0);
    const auto before = bench.recording.telemetry()->size(channel("velocity"));
    bench.stack().view().setLive(false);
    const auto range = bench.stack().view().range();
    bench.pass(2.0, 1000.0);
    QCOMPARE(bench.stack().view().range(), range);
    QCOMPARE(bench.recording.telemetry()->size(channel("velocity")), before + 200);
    bench.stack().view().setLive(true);
    bench.pass(0.1, 1000.0);
    QVERIFY(bench.stack().readings().selection(bench.trace("#5 velocity").id) == std::nullopt);
    bench.stack().setCursorsShown(true);
    bench.stack().setCursorKeys(1000.0, 1003.0);
    const auto found = bench.stack().readings().selection(bench.trace("#5 velocity").id);
    QCOMPARE(found->count, std::size_t{301}); // what came while it was paused is there
}

void TestPlotBoard::theLevelCanBeDragged()
{
    PlotBench bench;
    bench.pass(2.0, 60000.0);
    bench.page->trigger().bar().setLevel(30000.0);
    bench.page->trigger().armOn(bench.trace("#5 velocity").id);
    bench.pass(0.2, 60000.0);
    QCustomPlot &plot = bench.stack().plot();
    QCPAxisRect *pane = plot.axisRect(0);
    const QPoint handle(pane->left() + 2, static_cast<int>(pane->axis(QCPAxis::atLeft)->coordToPixel(30000.0)));
    const QPoint target(handle.x(), static_cast<int>(pane->axis(QCPAxis::atLeft)->coordToPixel(10000.0)));
    QTest::mousePress(&plot, Qt::LeftButton, Qt::NoModifier, handle);
    QTest::mouseMove(&plot, target);
    QMouseEvent move(QEvent::MouseMove, target, Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&plot, &move);
    QTest::mouseRelease(&plot, Qt::LeftButton, Qt::NoModifier, target);
    QVERIFY2(std::abs(bench.page->trigger().bar().setup()->level - 10000.0) < 1000.0,
        QByteArray::number(bench.page->trigger().bar().setup()->level));
}

void TestPlotBoard::theLevelIsWrittenAsTheLanguageWritesNumbers()
{
    PlotBench bench;
    const QLocale before;
    QLocale::setDefault(QLocale(QLocale::German));
    bench.page->trigger().bar().setLevel(-0.25);
    const double level = bench.page->trigger().bar().setup()->level;
    const auto *field = bench.page->trigger().bar().findChild<NumberField *>();
    const QString written = field ? field->text() : QString();
    QLocale::setDefault(before);
    QCOMPARE(written, s("-0,2500"));
    QCOMPARE(level, -0.25);
}

void TestPlotBoard::aDerivedSignalIsPlottedLikeAnyOther()
{
    PlotBench bench;
    bench.pass(1.0, 60000.0);
    QVERIFY(bench.board().addDerived(s("sum"), s("counts/s"), s("d5_velocity + d7_velocity")));
    bench.pass(1.0, 60000.0);
    QTRY_VERIFY(bench.trace("sum").source->telemetry().size({0}) > 150);
    QCOMPARE(bench.trace("sum").style.unit, s("counts/s"));
    const auto last = bench.trace("sum").source->latest();
    QVERIFY(last && std::abs(*last) < 1e-6); // one runs forwards, the other backwards
    QVERIFY(!bench.page->panel().signalList().list().findItems(s("sum"), Qt::MatchExactly).isEmpty());
    bench.board().removeDerived(0);
    QVERIFY(bench.page->panel().signalList().list().findItems(s("sum"), Qt::MatchExactly).isEmpty());
    QCOMPARE(bench.page->traceCount(), std::size_t{4});
}

void TestPlotBoard::aWrongFormulaSaysWhy()
{
    PlotBench bench;
    QVERIFY(!bench.board().addDerived(s("x"), {}, s("speed + 1")));
    QVERIFY(!bench.board().addDerived(s(" "), {}, s("d5_velocity")));
    QVERIFY(bench.board().book().whatIsWrong(s("x"), s("d5_velocity + ")).size() > 5);
    QCOMPARE(bench.board().book().whatIsWrong(s("x"), s("average(d5_velocity, 0.1)")), QString());
    QCOMPARE(bench.page->traceCount(), std::size_t{4});
}

void TestPlotBoard::referencesStayWhereTheyWereSeen()
{
    PlotBench bench;
    bench.stack().view().setWindow(2.0);
    bench.pass(2.0, 60000.0);
    const int velocity = bench.trace("#5 velocity").id;
    const double before = bench.stack().readings().valueAt(velocity, bench.stack().view().range().first + 1.0);
    bench.board().keepReferences();
    QCOMPARE(bench.board().references().size(), std::size_t{4});
    bench.pass(3.0, 0.0);
    const int reference = bench.board().references().front().id;
    const double after = bench.stack().readings().valueAt(reference, bench.stack().view().range().first + 1.0);
    QVERIFY2(std::abs(after - before) < 700.0, QByteArray::number(after) + ' ' + QByteArray::number(before));
    QVERIFY(std::abs(bench.stack().readings().valueAt(
                bench.trace("#5 velocity").id, bench.stack().view().range().second - 0.1))
        < 5000.0);
    bench.board().clearReferences();
    QVERIFY(bench.board().references().empty());
}

void TestPlotBoard::theSpectrumFindsAWave()
{
    PlotBench bench;
    for (int i = 0; i < 400; ++i) {
        const Instant time = bench.workbench.time + i * 10ms;
        bench.recording.telemetry()->append(
            {channel("velocity"), time, 500.0 + 40.0 * std::sin(6.283185307 * 5.0 * i / 100.0)});
    }
    bench.recording.telemetry()->commit();
    bench.workbench.time += 4s;
    bench.workbench.publish();
    bench.page->showView(PlotsPage::View::Spectrum);
    const auto &curves = bench.page->curves(PlotsPage::View::Spectrum).curves();
    QVERIFY(!curves.empty());
    const auto peak = std::max_element(curves.front().y.begin(), curves.front().y.end());
    const double frequency = curves.front().x.at(static_cast<int>(peak - curves.front().y.begin()));
    QVERIFY2(std::abs(frequency - 5.0) < 0.3, QByteArray::number(frequency));
    QVERIFY(std::abs(*peak - 40.0) < 4.0);
    QVERIFY2(curves.front().name.startsWith(s("#5 velocity: peak 4")), qPrintable(curves.front().name));
}

void TestPlotBoard::oneSignalAgainstAnother()
{
    PlotBench bench;
    bench.pass(2.0, 60000.0);
    bench.page->showView(PlotsPage::View::Against);
    const auto &curves = bench.page->curves(PlotsPage::View::Against).curves();
    QCOMPARE(curves.size(), std::size_t{1});
    QVERIFY(curves.front().x.size() > 150);
    QCOMPARE(curves.front().x.size(), curves.front().y.size());
    bench.page->showView(PlotsPage::View::Time);
}

void TestPlotBoard::anotherUnitOfAChannelIsFollowed()
{
    static std::vector<Channel> calibrated(dmc60c().channels.begin(), dmc60c().channels.end());
    calibrated[channel("current").value].unit = "mA";
    PlotBench bench;
    bench.pass(0.5, 1000.0);
    QCOMPARE(bench.trace("#5 current").style.unit, s("A"));
    const auto unitInList = [&bench] {
        QListWidget &list = bench.page->panel().signalList().list();
        return list.findItems(s("#5 current"), Qt::MatchExactly).front()->data(Qt::UserRole + 2).toString();
    };
    QCOMPARE(unitInList(), s("A"));
    const int before = bench.trace("#5 current").style.strip;
    bench.board().choose({{2}, channel("current")}, true); // stays in its pane
    bench.recording.telemetry()->useTable(calibrated);
    bench.pass(0.5, 1000.0);
    QCOMPARE(bench.trace("#5 current").style.unit, s("mA"));
    QCOMPARE(bench.trace("#7 current").style.unit, s("A"));
    QVERIFY(bench.trace("#5 current").style.strip != bench.trace("#7 current").style.strip);
    QCOMPARE(unitInList(), s("mA"));
    QVERIFY(before >= 0);
}

void TestPlotBoard::aCursorReadsTheSampleAndNotWhatAColumnDraws()
{
    const PlotBench bench;
    const auto telemetry = std::make_shared<Telemetry>(bench.workbench.shot.devices[0].family->channels);
    const ChannelIndex velocity = *telemetry->find("velocity");
    const auto at = [](int i) { return Instant(std::chrono::milliseconds(i)); };
    for (int i = 0; i < 1000; ++i)
        telemetry->append({velocity, at(i), i % 2 == 0 ? 100.0 : -100.0});
    telemetry->breakLine(velocity);
    telemetry->append({velocity, at(2000), 7.0});
    telemetry->commit();
    const TelemetrySource source(telemetry, velocity);
    QCOMPARE(*source.valueAt(plotKey(at(500))), 100.0);
    QCOMPARE(*source.valueAt(plotKey(at(501))), -100.0);
    QVERIFY(std::abs(*source.valueAt(0.5005)) < 1.0);
    QVERIFY(std::isnan(*source.valueAt(1.5)));
    QVERIFY(std::isnan(*source.valueAt(2.5)));
}

void TestPlotBoard::aCaughtEventStaysWhenAReferenceIsKept()
{
    PlotBench bench;
    bench.pass(1.0, 0.0);
    bench.stack().view().setWindow(1.0);
    bench.page->trigger().bar().setLevel(30000.0);
    bench.page->trigger().armOn(bench.trace("#5 velocity").id);
    bench.page->trigger().bar().findChild<Segmented *>()->setCurrent(1);
    for (int i = 0; i < 2; ++i)
        bench.pass(1.5, i == 0 ? 60000.0 : 0.0);
    QVERIFY(bench.page->trigger().watch().isDone());
    const double event = *bench.page->trigger().watch().event();
    bench.board().keepReferences();
    QVERIFY(bench.page->trigger().watch().isDone());
    QCOMPARE(*bench.page->trigger().watch().event(), event);
    QVERIFY(bench.stack().strips().trigger()); // its line is there, on the trace of now
    QCOMPARE(bench.stack().strips().trigger()->trace, bench.trace("#5 velocity").id);
    bench.page->trigger().bar().setLevel(20000.0);
    Q_EMIT bench.page->trigger().bar().changed(); // what a person sets is armed anew
    QVERIFY(!bench.page->trigger().watch().isDone());
}

void TestPlotBoard::theTriggerStaysOnItsSignalWhateverItIsCalled()
{
    PlotBench bench;
    bench.page->addSignal({{2}, channel("velocity")});
    bench.pass(1.0, 0.0);
    const auto traceOf = [&bench](const Signal &signal) {
        const auto &traces = bench.board().traces();
        return std::find_if(
            traces.begin(), traces.end(), [&](const PlotBoard::Trace &trace) { return trace.signal == signal; });
    };
    bench.page->trigger().armOn(traceOf({{2}, channel("velocity")})->id);
    auto *upwards = [&bench] {
        const auto boxes = bench.page->findChildren<QComboBox *>();
        return *std::find_if(boxes.begin(), boxes.end(),
            [](const QComboBox *box) { return box->accessibleName() == s("Signal upwards"); });
    }();
    upwards->setCurrentIndex(4);
    bench.workbench.device(1).identity.edit().address = 5; // another #5
    bench.workbench.publish();
    bench.board().keepReferences();
    QCOMPARE(bench.page->trigger().bar().trace(), traceOf({{2}, channel("velocity")})->id);
    QCOMPARE(upwards->currentIndex(), 4);
    bench.page->removeSignal({{2}, channel("velocity")}); // it is armed on no other one
    QVERIFY(!bench.page->trigger().watch().isArmed());
}

void TestPlotBoard::devicesOfOneNumberAreToldApart()
{
    PlotBench bench;
    bench.workbench.device(0).link = "sim:can";
    bench.workbench.device(1).link = "sim:serial";
    bench.workbench.device(1).identity.edit().address = 5;
    bench.workbench.publish();
    bench.page->addSignal({{2}, channel("velocity")});
    QSet<QString> names;
    for (const auto &trace : bench.board().traces())
        names << trace.style.name;
    QCOMPARE(names.size(), static_cast<int>(bench.board().traces().size()));
    QListWidget &list = bench.page->panel().signalList().list();
    names.clear();
    for (int i = 0; i < list.count(); ++i)
        names << list.item(i)->text();
    QCOMPARE(names.size(), list.count());
}

void TestPlotBoard::fittingLeavesReferencesOutOfTheTime()
{
    PlotBench bench;
    bench.pass(2.0, 60000.0);
    bench.board().keepReferences();
    bench.stack().fit();
    QVERIFY(bench.stack().view().isLive());
    bench.pass(0.1, 60000.0);
    QVERIFY(std::abs(bench.stack().view().range().second - plotKey(bench.workbench.time)) < 0.1);
}

void TestPlotBoard::noStretchIsShorterThanALayoutMayBe()
{
    PlotView view;
    view.setRange(10.0, 10.0 + 1e-5);
    QVERIFY(view.span() >= 1e-3 * (1.0 - 1e-9));
    QVERIFY(view.range().first <= 10.0 && view.range().second >= 10.0 + 1e-5); // around what was wished for
    PlotLayout layout;
    layout.window = view.window();
    QVERIFY(PlotLayout::fromJson(layout.toJson()));
}

void TestPlotBoard::withoutTracesNothingOldIsLeftInTheOtherViews()
{
    PlotBench bench;
    bench.pass(2.0, 60000.0);
    for (const auto view : {PlotsPage::View::Against, PlotsPage::View::Spectrum}) {
        bench.page->showView(view);
        QVERIFY(!bench.page->curves(view).curves().empty());
    }
    bench.workbench.shot.devices.clear();
    bench.selection.select({});
    bench.workbench.publish();
    QCOMPARE(bench.page->traceCount(), std::size_t{0});
    for (const auto view : {PlotsPage::View::Against, PlotsPage::View::Spectrum})
        QVERIFY(bench.page->curves(view).curves().empty());
}

MB_WINDOW_TEST(TestPlotBoard);
#include "tst_plotboard.moc"
