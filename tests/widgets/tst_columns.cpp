// SPDX-License-Identifier: GPL-3.0-or-later
#include "spike.h"
#include "support/windowtests.h"
#include "widgets/plots/autorange.h"
#include "widgets/plots/columnpath.h"
#include "widgets/plots/fixedtrace.h"
#include "widgets/plots/plottickers.h"

#include <QTest>
#include <algorithm>
#include <cmath>

using namespace mb;
using test::flatWithSpike;

class ColumnsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void denseColumnsBecomeSpansAndSparseOnesLines();
    void spansOfNeighbouringColumnsTouch();
    void aGapTearsTheLine();
    void gapsAreIntervals();
    void valueBetweenPointsIsOnTheLine();
    void fixedTraceKeepsASpikeAndAtMostFourPointsPerColumn();
    void fixedTraceHandsOutTheNeighboursOfTheWindow();
    void theAxisGrowsAtOnceAndShrinksLate();
    void theAxisTakesRoundNumbersAndANearZero();
    void aConstantHasAnAxisToo();
    void labelsOfTimeThatAreSecondsSaySo();
};

void ColumnsTest::labelsOfTimeThatAreSecondsSaySo()
{
    TimeTicker ticker;
    QVector<double> ticks;
    QVector<QString> labels;
    const auto label = [&](double end) {
        ticker.generate({0.0, end}, QLocale::c(), QLatin1Char('g'), 6, ticks, nullptr, &labels);
        return labels.value(0);
    };
    QVERIFY(!label(60.0).isEmpty());
    QVERIFY(ticker.showsSeconds()); // from an origin
    ticker.setClock(WallClock{std::chrono::seconds(1'700'000'000), {}});
    QVERIFY(label(60.0).contains(QLatin1Char(':')));
    QVERIFY(!ticker.showsSeconds());
    QVERIFY(!label(2.0).contains(QLatin1Char(':')));
    QVERIFY(ticker.showsSeconds()); // of the minute
    QVERIFY(label(2.0).contains(QLatin1Char('.')));
    const QLocale before;
    QLocale::setDefault(QLocale(QLocale::German));
    const QString german = label(2.0);
    QLocale::setDefault(before);
    QVERIFY2(german.contains(QLatin1Char(',')), qPrintable(german));
}

void ColumnsTest::denseColumnsBecomeSpansAndSparseOnesLines()
{
    const PixelMap map{100, 0, -1, 200, 1};
    const ColumnPath sparse = columnPath({{0.0, 1}, {0.1, 2}, {0.2, 3}}, map);
    QCOMPARE(sparse.lines.size(), 1);
    QVERIFY(sparse.spans.isEmpty());
    std::vector<PlotPoint> dense;
    for (int i = 0; i < 400; ++i)
        dense.push_back({i / 400.0, i % 2 == 0 ? -50.0 : 50.0});
    const ColumnPath path = columnPath(dense, map);
    QCOMPARE(path.spans.size(), 100);
    QVERIFY(path.lines.isEmpty());
    QCOMPARE(path.spans.at(10).x1(), path.spans.at(10).x2());
}

void ColumnsTest::spansOfNeighbouringColumnsTouch()
{
    const PixelMap map{100, 0, 1, 0, 1};
    std::vector<PlotPoint> steep;
    for (int i = 0; i < 1000; ++i)
        steep.push_back({i / 1000.0, i * 3.0});
    const ColumnPath path = columnPath(steep, map);
    QCOMPARE(path.spans.size(), 100);
    for (int i = 1; i < path.spans.size(); ++i)
        QVERIFY(path.spans[i].y1() <= path.spans[i - 1].y2());
}

void ColumnsTest::aGapTearsTheLine()
{
    const PixelMap map{100, 0, -1, 200, 1};
    const ColumnPath path = columnPath({{0.0, 1}, {0.1, 2}, PlotPoint::gap(0.11), {0.4, 3}, {0.5, 4}}, map);
    QCOMPARE(path.lines.size(), 2);
    QCOMPARE(path.lines[0].last().x(), 10.0);
    QCOMPARE(path.lines[1].first().x(), 40.0);
}

void ColumnsTest::gapsAreIntervals()
{
    const std::vector<PlotPoint> points{{0, 1}, PlotPoint::gap(1), PlotPoint::gap(1.5), {2, 1}, PlotPoint::gap(3)};
    const auto gaps = gapsOf(points, 5);
    QCOMPARE(int(gaps.size()), 2);
    QCOMPARE(gaps[0], std::make_pair(1.0, 2.0));
    QCOMPARE(gaps[1], std::make_pair(3.0, 5.0));
}

void ColumnsTest::valueBetweenPointsIsOnTheLine()
{
    const std::vector<PlotPoint> points{{0, 0}, {1, 10}, PlotPoint::gap(1.2), {2, 4}};
    QCOMPARE(valueAt(points, 0.25), 2.5);
    QCOMPARE(valueAt(points, 1.0), 10.0);
    QVERIFY(std::isnan(valueAt(points, 1.6)));
    QVERIFY(std::isnan(valueAt(points, -0.1)));
    QVERIFY(std::isnan(valueAt(points, 2.1)));
}

void ColumnsTest::fixedTraceKeepsASpikeAndAtMostFourPointsPerColumn()
{
    const FixedTrace trace(flatWithSpike(100'000, 54'321, 9.0));
    std::vector<PlotPoint> points;
    trace.columns(0, 1, 300, points);
    QVERIFY(points.size() <= 4 * 300 + 2);
    QCOMPARE(valueRange(points, 0, 1)->second, 9.0);
    QVERIFY(std::is_sorted(
        points.begin(), points.end(), [](const PlotPoint &a, const PlotPoint &b) { return a.key < b.key; }));
}

void ColumnsTest::fixedTraceHandsOutTheNeighboursOfTheWindow()
{
    const FixedTrace trace({{0, 1}, {1, 2}, {2, 3}, {3, 4}});
    std::vector<PlotPoint> points;
    trace.columns(1.2, 1.8, 100, points);
    QCOMPARE(int(points.size()), 2);
    QCOMPARE(points.front().key, 1.0);
    QCOMPARE(points.back().key, 2.0);
}

void ColumnsTest::theAxisGrowsAtOnceAndShrinksLate()
{
    AutoRange range;
    const auto first = range.update(0, 100, 0);
    QVERIFY(first.lower <= 0 && first.upper >= 100);
    QCOMPARE(range.update(0, 90, 0.1), first);
    const auto grown = range.update(0, 900, 0.2);
    QVERIFY(grown.upper >= 900);
    QCOMPARE(range.update(0, 100, 1.0), grown);
    QCOMPARE(range.update(0, 100, 2.9), grown);
    QCOMPARE(range.update(0, 100, 3.1), first);
    // A short return of large values starts the wait anew.
    (void)range.update(0, 900, 4.0);
    (void)range.update(0, 100, 4.1);
    (void)range.update(0, 890, 5.9);
    QCOMPARE(range.update(0, 100, 6.2), grown);
}

void ColumnsTest::theAxisTakesRoundNumbersAndANearZero()
{
    QCOMPARE(AutoRange::fitted(10, 100).lower <= 0, true);
    const auto far = AutoRange::fitted(1000, 1010);
    QVERIFY(far.lower > 990 && far.upper < 1020);
    QCOMPARE(roundStep(0.7), 0.5);
    QCOMPARE(roundStep(25), 20.0);
    QCOMPARE(roundStep(1), 1.0);
}

void ColumnsTest::aConstantHasAnAxisToo()
{
    for (const double value : {0.0, 1500.0, -3e6, 1e-9}) {
        const auto range = AutoRange::fitted(value, value);
        QVERIFY(range.lower < value && range.upper > value);
    }
}

MB_WINDOW_TEST(ColumnsTest);
#include "tst_columns.moc"
