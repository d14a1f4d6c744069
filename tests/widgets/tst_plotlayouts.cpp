// SPDX-License-Identifier: GPL-3.0-or-later
// Layouts of plots: what is kept of one, when, and what a page begins with.
#include "plotbench.h"
#include "support/windowtests.h"

#include <QDialog>
#include <QLineEdit>
#include <QMenu>

using namespace mb;
using namespace mb::test;

class TestPlotLayouts : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void layoutsComeBack();
    void aLayoutWaitsForItsDevices();
    void aFamilyCanBeginWithItsOwnLayout();
    void aLayoutThatCannotBeKeptIsTold();
    void aLayoutIsOfferedBeforeADiskHasIt();
    void aLayoutThatADiskHasIsWhatItSays();
    void theNextWindowBeginsWithWhatWasChangedAMomentAgo();
    void resetBringsTheUsualBack();
    void aChangeStandsWhileALayoutWaitsForADevice();
    void tracesOfALinkThatIsClosedComeBackWithIt();
    void aDerivedSignalThatWaitsForItsDevicesRebuildsNothing();
};

namespace {

void saveLayout(PlotBench &bench, QMenu &menu, const QString &name)
{
    bench.page->layoutBook().fillMenu(menu, *bench.page);
    menu.actions().constFirst()->trigger();
    auto *const dialog = bench.page->findChildren<QDialog *>().constLast();
    dialog->findChild<QLineEdit *>()->setText(name);
    dialog->accept();
    menu.clear();
}

} // namespace

void TestPlotLayouts::layoutsComeBack()
{
    PlotBench bench;
    const QTemporaryDir folder;
    bench.page->setLayoutFolder(folder.path());
    bench.page->addSignal({{2}, channel("velocity")});
    bench.page->removeSignal({{1}, channel("duty")});
    bench.board().setSecondAxis(bench.trace("#5 current").id, true);
    QVERIFY(bench.board().addDerived(s("sum"), s("counts/s"), s("d5_velocity + d7_velocity")));
    bench.board().moveToPane(bench.trace("sum").id, bench.board().paneOf(-1));
    bench.stack().view().setWindow(30.0);
    const PlotLayout layout = bench.page->layoutBook().current();
    const auto parsed = PlotLayout::fromJson(layout.toJson());
    QVERIFY(parsed && *parsed == layout);
    bench.page.reset(); // the end of the program
    bench.open();
    bench.page->setLayoutFolder(folder.path());
    QVERIFY(bench.page->layoutBook().current() == layout);
    QVERIFY(!PlotLayout::fromJson("{}"));
    QVERIFY(!PlotLayout::fromJson("{\"motorbench\":\"plot layout\",\"window\":-1}"));
    QVERIFY(bench.page->layoutBook().layouts().names().isEmpty()); // @last is nobody's name
}

void TestPlotLayouts::aLayoutWaitsForItsDevices()
{
    PlotBench bench;
    bench.page->addSignal({{2}, channel("velocity")});
    const PlotLayout layout = bench.page->layoutBook().current();
    const DeviceView second = bench.workbench.shot.devices.back();
    bench.page.reset();
    bench.workbench.shot.devices.pop_back();
    bench.open();
    bench.page->layoutBook().apply(layout);
    QCOMPARE(bench.page->traceCount(), std::size_t{4});
    bench.workbench.shot.devices.push_back(second);
    bench.workbench.publish();
    QCOMPARE(bench.page->traceCount(), std::size_t{5});
}

void TestPlotLayouts::aFamilyCanBeginWithItsOwnLayout()
{
    PlotBench bench;
    const QTemporaryDir folder;
    const PlotLayouts layouts(folder.path());
    PlotLayout layout;
    layout.traces = {{s("*"), s("temperature"), {}, false}};
    QVERIFY(layouts.save(PlotLayouts::familyName(s("dmc60c")), layout));
    bench.page->setLayoutFolder(folder.path());
    QCOMPARE(bench.page->traceCount(), std::size_t{1});
    QCOMPARE(bench.board().traces().front().style.name, s("#5 temperature"));
    bench.selection.select({2});
    QCOMPARE(bench.board().traces().front().style.name, s("#7 temperature"));
}

void TestPlotLayouts::aLayoutThatCannotBeKeptIsTold()
{
    PlotBench bench;
    const QTemporaryDir folder;
    QFile inTheWay(folder.filePath(s("plots")));
    QVERIFY(inTheWay.open(QIODevice::WriteOnly));
    bench.page->setLayoutFolder(folder.filePath(s("plots/layouts")));
    bench.page->addSignal({{2}, channel("velocity")});
    QVERIFY(bench.workbench.lines.empty());
    bench.page.reset(); // what is there is kept at the end of the program
    QCOMPARE(bench.workbench.lines.size(), std::size_t{1});
    QVERIFY(bench.workbench.lines.front().text.contains(s("plots")));
}

void TestPlotLayouts::aLayoutIsOfferedBeforeADiskHasIt()
{
    PlotBench bench;
    const QTemporaryDir folder;
    QFile inTheWay(folder.filePath(s("plots")));
    QVERIFY(inTheWay.open(QIODevice::WriteOnly));
    bench.page->setLayoutFolder(folder.filePath(s("plots/layouts"))); // that never has it
    bench.page->addSignal({{2}, channel("velocity")});
    const PlotLayout layout = bench.page->layoutBook().current();
    QMenu menu;
    saveLayout(bench, menu, s("mine"));
    bench.page->removeSignal({{2}, channel("velocity")});
    bench.page->layoutBook().fillMenu(menu, *bench.page);
    QCOMPARE(menu.actions().constLast()->text(), s("mine"));
    menu.actions().constLast()->trigger();
    QVERIFY(bench.page->layoutBook().current() == layout);
    bench.page->layoutBook().finish();
    menu.clear();
    bench.page->layoutBook().fillMenu(menu, *bench.page);
    QCOMPARE(menu.actions().constLast()->text(), s("Reset"));
}

void TestPlotLayouts::aLayoutThatADiskHasIsWhatItSays()
{
    PlotBench bench;
    const QTemporaryDir folder;
    bench.page->setLayoutFolder(folder.path());
    bench.page->addSignal({{2}, channel("velocity")});
    QMenu menu;
    saveLayout(bench, menu, s("mine"));
    bench.page->layoutBook().finish();
    PlotLayout other;
    other.traces = {{s("*"), s("temperature"), {}, false}};
    QVERIFY(PlotLayouts(folder.path()).save(s("mine"), other)); // another window does
    bench.page->layoutBook().fillMenu(menu, *bench.page);
    QCOMPARE(menu.actions().constLast()->text(), s("mine"));
    menu.actions().constLast()->trigger();
    QCOMPARE(bench.page->traceCount(), std::size_t{1});
}

void TestPlotLayouts::theNextWindowBeginsWithWhatWasChangedAMomentAgo()
{
    PlotBench bench;
    const QTemporaryDir folder;
    bench.page->setLayoutFolder(folder.path());
    bench.page->addSignal({{2}, channel("velocity")});
    const PlotLayout layout = bench.page->layoutBook().current();
    bench.page->layoutBook().finish();
    const auto before = std::move(bench.page); // as where somebody chooses another language
    bench.open();
    bench.page->setLayoutFolder(folder.path());
    QVERIFY(bench.page->layoutBook().current() == layout);
}

void TestPlotLayouts::resetBringsTheUsualBack()
{
    PlotBench bench;
    bench.page->addSignal({{2}, channel("velocity")});
    bench.pass(1.0, 100.0);
    bench.board().keepReferences();
    bench.page->layoutBook().reset();
    QCOMPARE(bench.page->traceCount(), std::size_t{4});
    QVERIFY(bench.board().references().empty());
    QVERIFY(!bench.board().isTouched());
}

void TestPlotLayouts::aChangeStandsWhileALayoutWaitsForADevice()
{
    PlotBench bench;
    const QTemporaryDir folder;
    bench.page->setLayoutFolder(folder.path());
    bench.page->addSignal({{2}, channel("velocity")});
    const DeviceView second = bench.workbench.shot.devices.back();
    bench.page.reset(); // the end of the program
    bench.workbench.shot.devices.pop_back();
    bench.open();
    bench.page->setLayoutFolder(folder.path());
    QCOMPARE(bench.page->traceCount(), std::size_t{4});
    bench.page->removeSignal({{1}, channel("duty")});
    bench.workbench.publish();
    QCOMPARE(bench.page->traceCount(), std::size_t{3});
    bench.page->addSignal({{1}, channel("temperature")});
    bench.workbench.publish();
    QCOMPARE(bench.page->traceCount(), std::size_t{4});
    bench.page.reset();
    bench.open();
    bench.page->setLayoutFolder(folder.path());
    QCOMPARE(bench.page->traceCount(), std::size_t{4});
    QCOMPARE(bench.trace("#5 temperature").style.unit, s("°C"));
    bench.workbench.shot.devices.push_back(second);
    bench.workbench.publish();
    QCOMPARE(bench.page->traceCount(), std::size_t{5});
    QCOMPARE(bench.trace("#7 velocity").style.unit, s("counts/s"));
}

void TestPlotLayouts::tracesOfALinkThatIsClosedComeBackWithIt()
{
    PlotBench bench;
    const QTemporaryDir folder;
    bench.page->setLayoutFolder(folder.path());
    bench.page->addSignal({{2}, channel("velocity")});
    bench.board().setSecondAxis(bench.trace("#5 current").id, true);
    const PlotLayout layout = bench.page->layoutBook().current();
    DeviceView first = bench.workbench.shot.devices.front();
    bench.workbench.shot.devices.erase(bench.workbench.shot.devices.begin());
    bench.workbench.publish();
    QCOMPARE(bench.page->traceCount(), std::size_t{1});
    QVERIFY(bench.page->layoutBook().current() == layout); // which is remembered
    first.id = {3};
    bench.workbench.shot.devices.push_back(first);
    bench.workbench.publish();
    QCOMPARE(bench.page->traceCount(), std::size_t{5});
    QVERIFY(bench.page->layoutBook().current() == layout);
    QVERIFY(bench.trace("#5 current").second);
    bench.selection.select({3});
    bench.page->layoutBook().reset(); // and are forgotten
    bench.workbench.publish();
    QCOMPARE(bench.page->layoutBook().current().traces.size(), std::size_t{4});
}

void TestPlotLayouts::aDerivedSignalThatWaitsForItsDevicesRebuildsNothing()
{
    PlotBench bench;
    bench.page->addSignal({{2}, channel("velocity")});
    QVERIFY(bench.board().addDerived(s("sum"), s("counts/s"), s("d5_velocity + d7_velocity")));
    const PlotLayout layout = bench.page->layoutBook().current();
    const DeviceView second = bench.workbench.shot.devices.back();
    bench.page.reset();
    bench.workbench.shot.devices.pop_back();
    bench.open();
    bench.page->layoutBook().apply(layout);
    QSignalSpy changed(&bench.board(), &PlotBoard::changed);
    for (int i = 0; i < 5; ++i)
        bench.workbench.publish();
    QCOMPARE(changed.count(), 0);
    QVERIFY(bench.page->layoutBook().current() == layout);
    bench.workbench.shot.devices.push_back(second);
    bench.workbench.publish();
    QCOMPARE(bench.page->traceCount(), std::size_t{6});
    QVERIFY(bench.page->layoutBook().current() == layout);
}

MB_WINDOW_TEST(TestPlotLayouts);
#include "tst_plotlayouts.moc"
