// SPDX-License-Identifier: GPL-3.0-or-later
#include "plotbench.h"
#include "support/timers.h"
#include "support/utf8.h"
#include "support/windowtests.h"
#include "tunebench.h"
#include "widgets/common/numberformat.h"
#include "widgets/plots/curveplot.h"
#include "widgets/plots/exportbar.h"
#include "widgets/plots/plotspage.h"
#include "widgets/plots/plotstack.h"
#include "widgets/plots/tracelist.h"
#include "widgets/plots/tracepanel.h"
#include "widgets/plots/triggercontrol.h"

#include <QApplication>
#include <QComboBox>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QPushButton>
#include <QSignalSpy>
#include <QStackedWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>

using namespace mb;
using namespace mb::test;
using namespace std::chrono_literals;

namespace {

struct PlotsBench {
    FakeWorkbench workbench;
    Selection selection;
    ThemeSource theme{darkTheme()};
    Recording recording{workbench.time};
    std::unique_ptr<PlotsPage> page;

    PlotsBench()
    {
        workbench.shot.devices.push_back(tunableDrive(recording.telemetry(), 1, 5));
        workbench.shot.devices.push_back(tunableDrive(std::make_shared<Telemetry>(dmc60c().channels), 2, 7));
        selection.select({1});
        page = std::make_unique<PlotsPage>(workbench, selection, theme, nullptr);
        page->resize(1208, 760);
        page->show();
    }
    void pass(double seconds, double velocity)
    {
        recording.run(seconds, velocity);
        workbench.time = recording.now();
        workbench.publish();
    }
    [[nodiscard]] TraceList &traces() const { return *page->findChild<TraceList *>(); }
    [[nodiscard]] QStringList names() const
    {
        QStringList names;
        for (const auto &row : traces().rows())
            names << row.name;
        return names;
    }
    [[nodiscard]] int strips() const { return page->stack().plot().axisRectCount(); }
};

} // namespace

class TestPlotsPage : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void theSelectedDeviceIsPlottedByDefault();
    void theDefaultsFollowTheSelectionUntilSomebodyChooses();
    void oneStripForEachUnit();
    void aDoubleClickAddsAndASecondRemoves();
    void aTraceCanBeRemovedFromItsRow();
    void whatIsRecordedIsShownWithRateAndLoss();
    void theRowAndTheTagOfATraceSayTheSameNumber();
    void aDeviceThatGoesTakesItsTraces();
    void nothingIsDrawnWhenNothingIsNew();
    void nothingIsDrawnWhileHidden();
    void aSpectrumOfWhatStandsStillIsOfWhatIsChosen();
    void theListOfSignalsStaysWhereItIsWhenADeviceComes();
    void underTheMouseWhatComesIsListedBelowAndWhatIsGoneIsNotTicked();
    void aTriggerWithoutALevelWaitsForOne();
    void keysPauseAndFit();
    void whatIsVisibleCanBeExported();
    void theButtonExportsAndNothingElse();
    void withoutDevicesThePageSaysWhatToDo();
    void scrollingShowsWhatAFreshLookWouldShow();
};

void TestPlotsPage::theSelectedDeviceIsPlottedByDefault()
{
    PlotsBench bench;
    QCOMPARE(bench.names(), QStringList({s("#5 velocity"), s("#5 position"), s("#5 current"), s("#5 duty")}));
}

void TestPlotsPage::theDefaultsFollowTheSelectionUntilSomebodyChooses()
{
    PlotsBench bench;
    bench.selection.select({2});
    QCOMPARE(bench.names().first(), s("#7 velocity"));
    bench.page->addSignal({{1}, channel("temperature")});
    bench.selection.select({1});
    QCOMPARE(bench.names().size(), 5);
    QCOMPARE(bench.names().first(), s("#7 velocity"));
}

void TestPlotsPage::oneStripForEachUnit()
{
    PlotsBench bench;
    QCOMPARE(bench.strips(), 4);
    bench.page->addSignal({{2}, channel("velocity")}); // counts/s are there already
    QCOMPARE(bench.strips(), 4);
    bench.page->addSignal({{2}, channel("bus_voltage")});
    QCOMPARE(bench.strips(), 5);
    bench.page->removeSignal({{1}, channel("position")});
    QCOMPARE(bench.strips(), 4);
    bench.page->addSignal({{2}, {200}}); // no such channel
    bench.page->addSignal({{9}, {0}});   // no such device
    QCOMPARE(bench.page->traceCount(), 5U);
}

void TestPlotsPage::aDoubleClickAddsAndASecondRemoves()
{
    PlotsBench bench;
    QListWidget &list = bench.page->panel().signalList().list();
    const auto found = list.findItems(s("#7 temperature"), Qt::MatchExactly);
    QCOMPARE(found.size(), 1);
    Q_EMIT list.itemActivated(found.first());
    QVERIFY(bench.names().contains(s("#7 temperature")));
    QCOMPARE(found.first()->checkState(), Qt::Checked);
    found.first()->setCheckState(Qt::Unchecked); // the box does the same
    QVERIFY(!bench.names().contains(s("#7 temperature")));
}

void TestPlotsPage::aTraceCanBeRemovedFromItsRow()
{
    PlotsBench bench;
    for (auto *button : bench.traces().findChildren<QAbstractButton *>()) {
        if (button->accessibleName() == s("Remove #5 position")) {
            button->click();
            break;
        }
    }
    QCOMPARE(bench.names(), QStringList({s("#5 velocity"), s("#5 current"), s("#5 duty")}));
    const auto found = bench.page->panel().signalList().list().findItems(s("#5 position"), Qt::MatchExactly);
    QCOMPARE(found.first()->checkState(), Qt::Unchecked);
}

void TestPlotsPage::whatIsRecordedIsShownWithRateAndLoss()
{
    PlotsBench bench;
    bench.pass(1.0, 60000.0);
    bench.recording.telemetry()->lost(channel("velocity"), 84);
    bench.pass(1.0, 60000.0);
    QTRY_COMPARE(bench.traces().rows().at(0).lost, s("84 lost"));
    const auto row = bench.traces().rows().at(0);
    QCOMPARE(row.rate, s("100 Hz"));
    QVERIFY(row.lossy);
    QVERIFY2(row.value.endsWith(s("counts/s")), qPrintable(row.value));
    QVERIFY(!bench.traces().rows().at(1).lossy);
    QTRY_VERIFY2(bench.page->stack().readings().summary().contains(s("1 gap")),
        qPrintable(bench.page->stack().readings().summary()));
    for (int i = 0; i < 10; ++i) { // silent: what it was is not what it is
        bench.workbench.time += 1s;
        bench.workbench.publish();
        passTimers(20ms);
    }
    QTRY_COMPARE(bench.traces().rows().at(0).value, QString(UnknownMark));
}

void TestPlotsPage::theRowAndTheTagOfATraceSayTheSameNumber()
{
    PlotsBench bench;
    QStringList seen;
    for (int i = 0; i < 12; ++i) { // a motor that speeds up: more often than numbers are written
        bench.pass(0.02, 5000.0 * i);
        passTimers(20ms);
        const PlotStrip &positions = *bench.page->stack().strips().all().at(1);
        QCOMPARE(positions.decor.tags.size(), std::size_t{1});
        QCOMPARE(bench.traces().rows().at(1).value, positions.decor.tags.front().text);
        seen << positions.decor.tags.front().text;
    }
    QVERIFY(seen.removeDuplicates() < 11); // it went on
}

void TestPlotsPage::aDeviceThatGoesTakesItsTraces()
{
    PlotsBench bench;
    bench.page->addSignal({{2}, channel("velocity")});
    bench.workbench.shot.devices.erase(bench.workbench.shot.devices.begin());
    bench.workbench.publish();
    QCOMPARE(bench.names(), QStringList({s("#7 velocity")}));
    bench.workbench.shot.devices.clear();
    bench.workbench.publish();
    QCOMPARE(bench.page->traceCount(), 0U);
}

void TestPlotsPage::nothingIsDrawnWhenNothingIsNew()
{
    PlotsBench bench;
    bench.pass(1.0, 1000.0);
    QSignalSpy drawn(&bench.page->stack().plot(), &QCustomPlot::afterReplot);
    QTRY_VERIFY(drawn.count() > 0);
    passTimers(16ms, 3);
    drawn.clear();
    passTimers(16ms, 12); // a dozen ticks
    QCOMPARE(drawn.count(), 0);
    bench.pass(0.1, 1000.0);
    QTRY_VERIFY(drawn.count() > 0);
}

void TestPlotsPage::nothingIsDrawnWhileHidden()
{
    PlotsBench bench;
    QTRY_VERIFY(!bench.page->stack().plot().visibleRegion().isEmpty());
    passTimers(16ms, 3); // the layout has settled
    bench.page->hide();
    QSignalSpy drawn(&bench.page->stack().plot(), &QCustomPlot::afterReplot);
    bench.pass(1.0, 1000.0);
    passTimers(16ms, 6);
    QCOMPARE(drawn.count(), 0);
    bench.page->show();
    QTRY_VERIFY(drawn.count() > 0);
}

void TestPlotsPage::aSpectrumOfWhatStandsStillIsOfWhatIsChosen()
{
    PlotsBench bench;
    bench.pass(5.0, 60000.0);
    PlotView &view = bench.page->stack().view();
    bench.page->showView(PlotsPage::View::Spectrum);
    const CurvePlot &spectrum = bench.page->curves(PlotsPage::View::Spectrum);
    view.setLive(false);
    QTRY_COMPARE(spectrum.curves().size(), std::size_t{4});
    bench.page->removeSignal({{1}, channel("duty")});
    QTRY_COMPARE(spectrum.curves().size(), std::size_t{3});
    const int points = spectrum.curves().front().x.size();
    view.setWindow(2.0);
    QTRY_VERIFY(spectrum.curves().front().x.size() < points);
}

void TestPlotsPage::theListOfSignalsStaysWhereItIsWhenADeviceComes()
{
    PlotsBench bench;
    QListWidget &list = bench.page->panel().signalList().list();
    QListWidgetItem *const chosen = list.findItems(s("#7 temperature"), Qt::MatchExactly).first();
    list.setCurrentItem(chosen);
    list.scrollToItem(chosen, QAbstractItemView::PositionAtTop);
    const QString top = list.itemAt(QPoint())->text();
    QVERIFY(top != list.item(0)->text());
    const auto comes = [&bench](std::uint32_t id, int address) {
        auto &devices = bench.workbench.shot.devices;
        devices.insert(devices.begin(), tunableDrive(std::make_shared<Telemetry>(dmc60c().channels), id, address));
        bench.workbench.publish();
    };
    const int before = list.count();
    comes(3, 2);
    QVERIFY(list.count() > before);
    QVERIFY(list.currentItem());
    QCOMPARE(list.currentItem()->text(), s("#7 temperature"));
    QCOMPARE(list.itemAt(QPoint())->text(), top);
    const int listed = list.count();
    list.viewport()->setAttribute(Qt::WA_UnderMouse);
    comes(4, 3);
    QCOMPARE(list.count(), listed);
    list.viewport()->setAttribute(Qt::WA_UnderMouse, false);
    QEvent leaves(QEvent::Leave);
    QApplication::sendEvent(list.viewport(), &leaves);
    QVERIFY(list.count() > listed);
}

void TestPlotsPage::underTheMouseWhatComesIsListedBelowAndWhatIsGoneIsNotTicked()
{
    PlotsBench bench;
    QListWidget &list = bench.page->panel().signalList().list();
    list.viewport()->setAttribute(Qt::WA_UnderMouse);
    const int listed = list.count();
    const auto row = [&list] { return list.findItems(s("#7 temperature"), Qt::MatchExactly).value(0); };
    auto &devices = bench.workbench.shot.devices;
    devices.push_back(tunableDrive(std::make_shared<Telemetry>(dmc60c().channels), 3, 9));
    bench.workbench.publish();
    QVERIFY(list.count() > listed);
    QVERIFY(list.item(listed)->text().startsWith(s("#9 ")));
    const DeviceView unplugged = devices[1];
    devices.erase(devices.begin() + 1);
    bench.workbench.publish();
    QVERIFY(row() && !(row()->flags() & Qt::ItemIsEnabled));
    Q_EMIT list.itemActivated(row()); // by Enter
    QVERIFY(row()->checkState() == Qt::Unchecked);
    devices.insert(devices.begin() + 1, unplugged);
    bench.workbench.publish();
    QVERIFY(row()->flags() & Qt::ItemIsEnabled);
    devices.erase(devices.begin() + 1);
    bench.workbench.publish();
    list.viewport()->setAttribute(Qt::WA_UnderMouse, false);
    QEvent leaves(QEvent::Leave);
    QApplication::sendEvent(list.viewport(), &leaves);
    QVERIFY(!row());
}

void TestPlotsPage::aTriggerWithoutALevelWaitsForOne()
{
    PlotsBench bench;
    bench.pass(1.0, 1000.0);
    TriggerControl &trigger = bench.page->trigger();
    trigger.bar().setLevel(500.0);
    trigger.setOn(true);
    QVERIFY(trigger.watch().isArmed());
    auto *const level = trigger.bar().findChild<QLineEdit *>();
    const auto type = [level](const char *text) {
        level->setText(s(text));
        Q_EMIT level->editingFinished();
    };
    type("abc");
    QVERIFY(!trigger.watch().isArmed());
    QCOMPARE(level->property("state").toString(), s("error"));
    Q_EMIT trigger.bar().changed(); // as another edge does
    QVERIFY(!trigger.watch().isArmed() && !bench.page->stack().strips().trigger());
    bench.page->addSignal({{2}, channel("velocity")});
    QVERIFY(!trigger.watch().isArmed() && trigger.bar().isVisible());
    type("700");
    QVERIFY(trigger.watch().isArmed());
    QCOMPARE(bench.page->stack().strips().trigger()->level, 700.0);
    QCOMPARE(level->property("state").toString(), QString());
}

void TestPlotsPage::keysPauseAndFit()
{
    PlotsBench bench;
    QApplication::setActiveWindow(bench.page.get());
    QVERIFY(bench.page->stack().view().isLive());
    QTest::keyClick(bench.page.get(), Qt::Key_P);
    QVERIFY(!bench.page->stack().view().isLive());
    QTest::keyClick(bench.page.get(), Qt::Key_P);
    QVERIFY(bench.page->stack().view().isLive());
    auto *window = bench.page->findChild<QComboBox *>(s("plotsWindow"));
    window->setCurrentIndex(2);
    Q_EMIT window->activated(2);
    QCOMPARE(bench.page->stack().view().window(), 2.0);
}

void TestPlotsPage::whatIsVisibleCanBeExported()
{
    PlotsBench bench;
    bench.pass(2.0, 60000.0);
    QTRY_VERIFY(bench.page->stack().view().range().second > plotKey(bench.workbench.time) - 0.1);
    QTemporaryDir directory;
    QVERIFY(bench.page->stack().exporter().exportTo(directory.filePath(s("plot.csv"))));
    QFile file(directory.filePath(s("plot.csv")));
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QByteArray table = file.readAll();
    QVERIFY2(table.contains("#5 velocity"), table.left(200));
    QVERIFY2(table.count('\n') > 150, QByteArray::number(table.count('\n')) + table.right(60));
}

void TestPlotsPage::theButtonExportsAndNothingElse()
{
    PlotsBench bench;
    QPushButton *found = nullptr;
    for (auto *button : bench.page->findChildren<QPushButton *>()) {
        if (button->text() == s("Export"))
            found = button;
    }
    QVERIFY(found);
    QStringList entries;
    QTimer::singleShot(0, bench.page.get(), [&entries] {
        auto *menu = qobject_cast<QMenu *>(QApplication::activePopupWidget());
        if (!menu)
            return;
        for (const QAction *action : menu->actions()) {
            if (!action->isSeparator())
                entries << action->text();
        }
        menu->close();
    });
    found->click();
    QTRY_VERIFY(!entries.isEmpty());
    QVERIFY2(entries.contains(s("Export samples…")) && entries.contains(s("Copy picture")),
        qPrintable(entries.join(QLatin1Char('|'))));
    for (const QString &entry : entries)
        QVERIFY2(entry.startsWith(s("Export")) || entry.startsWith(s("Copy")), qPrintable(entry));
}

void TestPlotsPage::withoutDevicesThePageSaysWhatToDo()
{
    FakeWorkbench workbench;
    Selection selection;
    ThemeSource theme{lightTheme()};
    PlotsPage page(workbench, selection, theme, nullptr);
    page.show();
    QCOMPARE(page.findChild<QStackedWidget *>()->currentIndex(), 0);
    workbench.shot.devices.push_back(tunableDrive(std::make_shared<Telemetry>(dmc60c().channels)));
    workbench.publish();
    QCOMPARE(page.findChild<QStackedWidget *>()->currentIndex(), 1);
    selection.select({1});
    QCOMPARE(page.traceCount(), 4U);
}

void TestPlotsPage::scrollingShowsWhatAFreshLookWouldShow()
{
    Recording recording{Instant(1000s)};
    const TelemetrySource kept(recording.telemetry(), channel("velocity"));
    std::vector<PlotPoint> scrolled;
    std::vector<PlotPoint> fresh;
    for (int i = 0; i < 40; ++i) {
        recording.run(0.21, i % 2 == 0 ? 60000.0 : 0.0);
        if (i % 7 == 3)
            recording.telemetry()->lost(channel("velocity"), 1);
        const double to = std::ceil(plotKey(recording.now()) * 100.0) / 100.0;
        kept.columns(to - 5.0, to, 200, scrolled);
        const TelemetrySource other(recording.telemetry(), channel("velocity"));
        other.columns(to - 5.0, to, 200, fresh);
        QCOMPARE(scrolled.size(), fresh.size());
        for (std::size_t p = 0; p < fresh.size(); ++p) {
            QCOMPARE(scrolled[p].key, fresh[p].key);
            QVERIFY(
                scrolled[p].value == fresh[p].value || (std::isnan(scrolled[p].value) && std::isnan(fresh[p].value)));
        }
    }
}

MB_WINDOW_TEST(TestPlotsPage);
#include "tst_plotspage.moc"
