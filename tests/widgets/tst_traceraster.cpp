// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/windowtests.h"
#include "widgets/plots/traceraster.h"

#include <QTest>
#include <cmath>
#include <random>

using namespace mb;

namespace {

constexpr int Width = 120;
constexpr int Height = 60;
constexpr QRect Clip(10, 5, Width, Height);
const QRgb Blank = qRgb(0, 0, 0);
const QRgb White = qRgb(255, 255, 255);

/// One second is a pixel column, one unit a row; value 0 is the lower edge.
PixelMap plainMap()
{
    PixelMap map;
    map.valueScale = -1.0;
    map.valueOffset = Height;
    return map;
}

QImage drawn(const std::vector<PlotPoint> &points, const PixelMap &map, const TraceStroke &stroke)
{
    QImage image(Clip.right() + 20, Clip.bottom() + 20, QImage::Format_RGB32);
    image.fill(Blank);
    TraceRaster().draw(image, Clip, points, map, stroke);
    return image;
}

/// How much of a pixel of the clip is covered: 0 … 1.
double cover(const QImage &image, int column, int row)
{
    return qGreen(image.pixel(Clip.left() + column, Clip.top() + row)) / 255.0;
}

double columnSum(const QImage &image, int column)
{
    double sum = 0.0;
    for (int row = 0; row < Height; ++row)
        sum += cover(image, column, row);
    return sum;
}

std::vector<PlotPoint> randomTrace(std::mt19937 &random, double perColumn)
{
    std::uniform_real_distribution<double> step(0.1, 2.0);
    std::uniform_real_distribution<double> value(-10.0, Height + 10.0);
    std::vector<PlotPoint> points;
    for (double key = -3.0; key < Width + 3.0; key += step(random) / perColumn) {
        if (random() % 20 == 0)
            points.push_back(PlotPoint::gap(key));
        else
            points.push_back({key, value(random)});
    }
    return points;
}

} // namespace

class TraceRasterTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void whatASampleReachesIsCovered_data();
    void whatASampleReachesIsCovered();
    void nothingIsDrawnAwayFromTheTrace_data() { whatASampleReachesIsCovered_data(); }
    void nothingIsDrawnAwayFromTheTrace();
    void aSpikeOfOneSampleIsDrawnWhole();
    void aGapStaysOpen();
    void aLineIsAsThickAsItsStroke_data();
    void aLineIsAsThickAsItsStroke();
    void aSteepLineHasNoHoles();
    void dashesTravelWithTheData();
    void anEdgeOfADashedTraceIsDashedToo();
    void aTraceThatMovesByAColumnLooksTheSame();
    void whatLiesOutsideOfThePaneIsNotTouched();
};

void TraceRasterTest::whatASampleReachesIsCovered_data()
{
    QTest::addColumn<double>("perColumn");
    QTest::addColumn<double>("width");
    QTest::newRow("sparse") << 0.2 << 1.5;
    QTest::newRow("a sample a column") << 1.0 << 1.5;
    QTest::newRow("dense") << 20.0 << 1.5;
    QTest::newRow("dense and thick") << 20.0 << 4.2;
    QTest::newRow("sparse and thick") << 0.2 << 4.2;
}

void TraceRasterTest::whatASampleReachesIsCovered()
{
    QFETCH(double, perColumn);
    QFETCH(double, width);
    std::mt19937 random(7);
    for (int round = 0; round < 20; ++round) {
        const auto points = randomTrace(random, perColumn);
        const QImage image = drawn(points, plainMap(), {White, width});
        for (const PlotPoint &point : points) {
            const double y = Height - point.value;
            if (!std::isfinite(point.value) || point.key < 0 || point.key >= Width || y < 1 || y >= Height - 1)
                continue;
            // The brush reaches at least 0.75 above and below: one of the rows that it lies in is half covered.
            const int row = static_cast<int>(y);
            QVERIFY2(cover(image, static_cast<int>(point.key), row) >= 0.5,
                qPrintable(QStringLiteral("%1 at %2").arg(point.value).arg(point.key)));
        }
    }
}

/// Against brute force: where no sample and no line between two of them is near, there is nothing.
void TraceRasterTest::nothingIsDrawnAwayFromTheTrace()
{
    QFETCH(double, perColumn);
    QFETCH(double, width);
    std::mt19937 random(11);
    const auto points = randomTrace(random, perColumn);
    const QImage image = drawn(points, plainMap(), {White, width});
    for (int column = 0; column < Width; ++column) {
        const double reach = width / 2 + 0.01;
        double top = 1e9;
        double bottom = -1e9;
        for (std::size_t i = 0; i + 1 < points.size(); ++i) {
            const PlotPoint &a = points[i];
            const PlotPoint &b = points[i + 1];
            if (!std::isfinite(a.value) || b.key < column - reach || a.key > column + 1 + reach)
                continue;
            const PlotPoint &end = std::isfinite(b.value) ? b : a;
            const double left = std::max(a.key, column - reach);
            const double right = std::min(end.key, column + 1 + reach);
            for (const double key : {left, right}) {
                const double part = end.key > a.key ? (key - a.key) / (end.key - a.key) : 0.0;
                const double y = Height - (a.value + std::clamp(part, 0.0, 1.0) * (end.value - a.value));
                top = std::min(top, y - reach);
                bottom = std::max(bottom, y + reach);
            }
        }
        for (int row = 0; row < Height; ++row) {
            if (row + 1 < top || row > bottom)
                QCOMPARE(cover(image, column, row), 0.0);
        }
    }
}

void TraceRasterTest::aSpikeOfOneSampleIsDrawnWhole()
{
    std::vector<PlotPoint> points;
    for (int i = 0; i < 12'000; ++i)
        points.push_back({i / 100.0, i == 5'055 ? 55.0 : 5.0});
    const QImage image = drawn(points, plainMap(), {White, 1.5});
    for (int row = 5; row < Height - 5; ++row)
        QCOMPARE(cover(image, 50, row), 1.0);
    QVERIFY(columnSum(image, 49) < 2.0 && columnSum(image, 51) < 2.0);
}

void TraceRasterTest::aGapStaysOpen()
{
    const QImage image
        = drawn({{10, 20}, {30.5, 20}, PlotPoint::gap(30.5), {60.5, 40}, {80, 40}}, plainMap(), {White, 1.5});
    for (int column = 31; column < 60; ++column)
        QCOMPARE(columnSum(image, column), 0.0);
    QVERIFY(columnSum(image, 20) > 1.0 && columnSum(image, 70) > 1.0);
}

void TraceRasterTest::aLineIsAsThickAsItsStroke_data()
{
    QTest::addColumn<double>("slope");
    QTest::addColumn<double>("width");
    for (const double slope : {0.0, 0.1, 0.3, 1.0}) {
        for (const double width : {1.0, 1.5, 2.2}) {
            QTest::addRow("slope %.1f, width %.1f", slope, width) << slope << width;
        }
    }
}

void TraceRasterTest::aLineIsAsThickAsItsStroke()
{
    QFETCH(double, slope);
    QFETCH(double, width);
    const QImage image = drawn({{10, 5.3}, {60, 5.3 + 50 * slope}}, plainMap(), {White, width});
    for (int column = 12; column < 50; ++column) {
        const double across = columnSum(image, column) / std::sqrt(1 + slope * slope);
        // A brush that reaches into the columns beside is made of whole columns.
        QVERIFY2(std::abs(across - width) < (width < 2 ? 0.03 : 0.12), qPrintable(QString::number(across)));
    }
}

void TraceRasterTest::aSteepLineHasNoHoles()
{
    const QImage image = drawn({{10, 2}, {22, 58}}, plainMap(), {White, 1.0});
    for (int row = 4; row < Height - 4; ++row) {
        double sum = 0.0;
        for (int column = 9; column < 24; ++column)
            sum += cover(image, column, row);
        QVERIFY2(sum > 0.9, qPrintable(QStringLiteral("row %1: %2").arg(row).arg(sum)));
    }
}

void TraceRasterTest::dashesTravelWithTheData()
{
    const std::vector<PlotPoint> points{{-100, 30}, {400, 30}};
    const TraceStroke dashed{White, 1.0, 6, 4};
    const QImage before = drawn(points, plainMap(), dashed);
    int on = 0;
    for (int column = 0; column < Width; ++column)
        on += columnSum(before, column) > 0.5 ? 1 : 0;
    QCOMPARE(on, Width * 6 / 10);
    PixelMap moved = plainMap();
    moved.keyOffset = -13; // 13 columns later
    const QImage after = drawn(points, moved, dashed);
    for (int column = 0; column < Width - 13; ++column)
        QCOMPARE(columnSum(after, column), columnSum(before, column + 13));
}

void TraceRasterTest::anEdgeOfADashedTraceIsDashedToo()
{
    for (const double edge : {40.5, 47.5}) { // where the pattern is drawn along time, and where it pauses
        const QImage image = drawn({{0, 5}, {edge, 5}, {edge, 55}, {119, 55}}, plainMap(), {White, 1.0, 6, 4});
        const double sum = columnSum(image, static_cast<int>(edge));
        QVERIFY2(sum > 25.0 && sum < 37.0, qPrintable(QString::number(sum)));
    }
}

void TraceRasterTest::aTraceThatMovesByAColumnLooksTheSame()
{
    std::mt19937 random(3);
    const auto points = randomTrace(random, 5.0);
    PixelMap moved = plainMap();
    moved.keyOffset = -1;
    const QImage before = drawn(points, plainMap(), {White, 1.5});
    const QImage after = drawn(points, moved, {White, 1.5});
    QCOMPARE(after.copy(Clip.adjusted(0, 0, -1, 0)), before.copy(Clip.adjusted(1, 0, 0, 0)));
}

void TraceRasterTest::whatLiesOutsideOfThePaneIsNotTouched()
{
    std::mt19937 random(5);
    QImage image = drawn(randomTrace(random, 5.0), plainMap(), {White, 4.2});
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x)
            QVERIFY(Clip.contains(x, y) || image.pixel(x, y) == Blank);
    }
    // A pane that is larger than the picture is not drawn at all.
    TraceRaster().draw(image, Clip.adjusted(0, 0, 200, 0), {{0, 1}, {9, 1}}, plainMap(), {});
}

MB_WINDOW_TEST(TraceRasterTest);
#include "tst_traceraster.moc"
