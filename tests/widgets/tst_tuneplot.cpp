// SPDX-License-Identifier: GPL-3.0-or-later
// The live plot of the page Tune: its units are those of the device now, its set-points those of the mode.
#include "support/windowtests.h"
#include "tunebench.h"
#include "widgets/control/tuneplot.h"

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

MB_WINDOW_TEST(TunePlotTest);
#include "tst_tuneplot.moc"
