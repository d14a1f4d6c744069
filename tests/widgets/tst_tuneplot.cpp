// SPDX-License-Identifier: GPL-3.0-or-later
// The live plot of the page Tune: its units are those of the device now, its set-points those of the mode.
#include "recording/loadrecording.h"
#include "support/windowtests.h"
#include "tunebench.h"
#include "widgets/control/tuneplot.h"

#include <QComboBox>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>

using namespace mb;
using namespace mb::test;

namespace {

/// As a profile makes it, which is given while the page is open.
std::span<const Channel> inMillivolts()
{
    static const std::vector<Channel> table = [] {
        std::vector<Channel> rows(dmc60c().channels.begin(), dmc60c().channels.end());
        for (Channel &row : rows) {
            if (row.key == "current")
                row.unit = "mV";
        }
        return rows;
    }();
    return table;
}

const PlotTrace &traceOf(TunePlot &plot, TraceRole role)
{
    const auto &all = plot.stack().strips().traces();
    return std::find_if(all.begin(), all.end(), [role](const auto &one) {
        return one.second.style.role == role;
    })->second;
}

std::size_t pointsOf(const PlotTrace &trace, double from, double to)
{
    std::vector<PlotPoint> points;
    trace.source->columns(from, to, 1000, points);
    return points.size();
}

} // namespace

class TunePlotTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aUnitThatChangesIsTheUnitThatIsSaid();
    void setPointsOfAnotherModeStayAwayWhenItsMotorIsChosenAgain();
    void itsTableTellsTheTimeOfDayAndWhatIsMissing();
    void theLengthThatIsSaidIsThatOfTheAxis();
};

void TunePlotTest::aUnitThatChangesIsTheUnitThatIsSaid()
{
    TuneBench bench;
    bench.workbench.publish();
    QCOMPARE(traceOf(bench.page->plot(), TraceRole::Current).style.unit, QStringLiteral("A"));
    bench.recording.telemetry()->useTable(inMillivolts());
    bench.workbench.publish();
    QCOMPARE(traceOf(bench.page->plot(), TraceRole::Current).style.unit, QStringLiteral("mV"));
}

void TunePlotTest::setPointsOfAnotherModeStayAwayWhenItsMotorIsChosenAgain()
{
    TuneBench bench;
    const DeviceView first = bench.device();
    const DeviceView other = tunableDrive(std::make_shared<Telemetry>(dmc60c().channels), 2, 7);
    TunePlot plot(bench.workbench, bench.theme);
    plot.choose(first, Mode::Velocity);
    const double begun = plotKey(bench.recording.now());
    bench.recording.setCommanded(true);
    bench.pass(2.0, 5000.0);
    const double changed = plotKey(bench.workbench.presentOf(first.link));
    QVERIFY(pointsOf(traceOf(plot, TraceRole::Setpoint), begun, changed) > 0);
    plot.choose(first, Mode::Position);
    QCOMPARE(pointsOf(traceOf(plot, TraceRole::Setpoint), begun, changed - 0.1), std::size_t{0});
    plot.choose(other, Mode::Velocity);
    plot.choose(first, Mode::Position);
    QCOMPARE(pointsOf(traceOf(plot, TraceRole::Setpoint), begun, changed - 0.1), std::size_t{0});
}

void TunePlotTest::itsTableTellsTheTimeOfDayAndWhatIsMissing()
{
    TuneBench bench;
    bench.workbench.publish();
    bench.pass(0.5, 5000.0);
    bench.recording.telemetry()->lost(*bench.recording.telemetry()->find("velocity"), 3);
    bench.pass(0.5, 5000.0);
    PlotStack &stack = bench.page->plot().stack();
    const double end = plotKey(bench.recording.now());
    stack.view().setRange(end - 0.9, end);
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("seen.csv"));
    QVERIFY(stack.exporter().exportTo(path));
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QStringList lines = QString::fromUtf8(file.readAll()).split(QLatin1Char('\n'));
    const QString unixTime = QString::number(end - 0.9, 'f', 6);
    QVERIFY2(lines[0].startsWith(QStringLiteral("# time_s 0 is 1970-01-01T"))
            && lines[0].endsWith(QStringLiteral("(Unix %1)").arg(unixTime)),
        qPrintable(lines[0]));
    QVERIFY2(lines[1].startsWith(QStringLiteral("# loss: Velocity = 3 of ")), qPrintable(lines[1]));
    QVERIFY2(lines[2].startsWith(QStringLiteral("time_s,Velocity (counts/s)")), qPrintable(lines[2]));
    QVERIFY2(lines[3].startsWith(QStringLiteral("0.0")), qPrintable(lines[3]));
    const auto table = loadRecording(path.toStdString());
    QVERIFY(table);
    QCOMPARE((*table)->telemetry->gaps({0}, Instant::min(), Instant::max()).size(), std::size_t{1});
}

void TunePlotTest::theLengthThatIsSaidIsThatOfTheAxis()
{
    TuneBench bench;
    PlotView &view = bench.page->plot().stack().view();
    const auto *const window = bench.find<QComboBox>("Length of the time axis");
    QVERIFY(window);
    QCOMPARE(window->currentText(), QStringLiteral("last 10 s"));
    view.setWindow(30.0);
    QCOMPARE(window->currentText(), QStringLiteral("last 30 s"));
    view.zoom(0.2, {});
    QCOMPARE(window->currentText(), QString());
}

MB_WINDOW_TEST(TunePlotTest);
#include "tst_tuneplot.moc"
