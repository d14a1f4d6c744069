// SPDX-License-Identifier: GPL-3.0-or-later
// Words and boxes in a plot leave what is measured in sight.
#include "support/utf8.h"
#include "support/windowtests.h"
#include "widgets/plots/curveplot.h"
#include "widgets/plots/fixedtrace.h"
#include "widgets/plots/plotcursors.h"
#include "widgets/plots/plotfoot.h"
#include "widgets/plots/plotlabels.h"
#include "widgets/plots/plotstack.h"
#include "widgets/plots/plotstrip.h"

#include <QTest>

using namespace mb;
using namespace mb::test;

class ClearCurvesTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void theLegendStandsAboveTheAxes();
    void theLegendTakesMoreLinesWhereItIsNarrow();
    void boxesOfTheCursorsHideNoCurveAndNoFlag();
    void eachStripHasItsOwnDifferences();
    void wordsOfATriggerStandWhereNoCurveIs();
    void aPlotWithoutTracesSaysNothingOfItsTime();
};

namespace {

std::vector<PlotPoint> stepAt(double edge, double before, double after)
{
    std::vector<PlotPoint> points;
    for (int i = 0; i <= 1000; ++i)
        points.push_back({i / 100.0, i / 100.0 < edge ? before : after});
    return points;
}

/// As many strips, and in the first a step and a line at zero.
struct Strips {
    ThemeSource theme{darkTheme()};
    PlotStack stack{theme};

    Strips()
    {
        stack.resize(720, 520);
        stack.show();
        add("velocity", TraceRole::Velocity, 0, 0.0, 60'000.0);
        add("other velocity", TraceRole::Temperature, 0, 0.0, 0.0);
        add("position", TraceRole::Position, 1, 0.0, 200'000.0);
        add("current", TraceRole::Current, 2, 0.0, 20.0);
        add("duty", TraceRole::Duty, 3, 0.0, 18.0);
        stack.view().setRange(0, 10);
        stack.refresh(0);
    }
    void add(const char *name, TraceRole role, int strip, double before, double after)
    {
        stack.strips().addTrace(
            {s(name), s("u"), role, strip}, std::make_shared<FixedTrace>(stepAt(5.0, before, after)));
    }
    [[nodiscard]] QRectF strip(int index) { return QRectF(stack.plot().axisRect(index)->rect()); }
};

} // namespace

void ClearCurvesTest::theLegendStandsAboveTheAxes()
{
    const ThemeSource theme(darkTheme());
    CurvePlot plot(theme, s("plot"));
    plot.resize(700, 400);
    plot.show();
    plot.setCurves({{s("one"), {}, {0, 1}, {0, 1}}, {s("two"), {}, {0, 1}, {1, 0}}});
    plot.plot().replot();
    QVERIFY(plot.plot().legend->visible());
    const QRect legend = plot.plot().legend->outerRect();
    const QRect axes = plot.plot().axisRect()->rect();
    QVERIFY2(legend.bottom() < axes.top(),
        qPrintable(s("legend ends at %1, axes begin at %2").arg(legend.bottom()).arg(axes.top())));
    QVERIFY2(axes.height() > 280, qPrintable(QString::number(axes.height())));
}

void ClearCurvesTest::theLegendTakesMoreLinesWhereItIsNarrow()
{
    const ThemeSource theme(darkTheme());
    CurvePlot plot(theme, s("plot"));
    plot.resize(900, 400);
    plot.show();
    std::vector<Curve> curves;
    for (int i = 0; i < 4; ++i)
        curves.push_back({s("DMC60C #%1 velocity").arg(i), {}, {0, 1}, {0, 1.0 * i}});
    plot.setCurves(curves);
    plot.plot().replot();
    const int wide = plot.plot().legend->outerRect().height();
    plot.resize(300, 400);
    plot.plot().replot();
    QVERIFY(plot.plot().legend->outerRect().height() > wide);
    QVERIFY(plot.plot().legend->outerRect().right() <= plot.plot().width());
}

void ClearCurvesTest::boxesOfTheCursorsHideNoCurveAndNoFlag()
{
    Strips strips;
    strips.stack.setCursorsShown(true);
    strips.stack.setCursorKeys(5.2, 7.6);
    strips.stack.refresh(0.1);
    strips.stack.plot().replot();
    const auto &boxes = strips.stack.strips().cursors().boxes();
    QCOMPARE(boxes.size(), 4U);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        const QRectF strip = strips.strip(static_cast<int>(i));
        QVERIFY2(strip.contains(boxes[i]), qPrintable(s("box %1 leaves its strip").arg(i)));
        const QCPAxis &keys = *strips.stack.plot().axisRect(static_cast<int>(i))->axis(QCPAxis::atBottom);
        for (const double cursor : {5.2, 7.6}) {
            const double x = keys.coordToPixel(cursor);
            QVERIFY2(x < boxes[i].left() || x > boxes[i].right(), qPrintable(s("box %1 hides a cursor").arg(i)));
        }
        const QCPAxis &values = *strips.stack.plot().axisRect(static_cast<int>(i))->axis(QCPAxis::atLeft);
        const double low = values.coordToPixel(0.0);
        QVERIFY2(
            i == 0 || !(boxes[i].top() < low && boxes[i].bottom() > low && boxes[i].left() < keys.coordToPixel(5.0)),
            qPrintable(s("box %1 hides its curve").arg(i)));
    }
}

void ClearCurvesTest::eachStripHasItsOwnDifferences()
{
    Strips strips;
    strips.stack.setCursorsShown(true);
    strips.stack.setCursorKeys(2.0, 7.0);
    strips.stack.refresh(0.1);
    const auto rows = strips.stack.readings().cursorRows();
    const auto stripOf = [&](const char *name) {
        const auto found = std::find_if(
            rows.begin(), rows.end(), [&](const PlotCursorRow &row) { return row.name.contains(s(name)); });
        return found == rows.end() ? -1 : found->strip;
    };
    QCOMPARE(stripOf("Δt"), 0);
    QCOMPARE(stripOf("other velocity"), 0);
    QCOMPARE(stripOf("position"), 1);
    QCOMPARE(stripOf("duty"), 3);
    QVERIFY(strips.stack.readings().cursorWords().join(s(" ")).contains(s("Δ position"))); // in words with its name
}

void ClearCurvesTest::wordsOfATriggerStandWhereNoCurveIs()
{
    const ThemeSource theme(darkTheme());
    PlotStack stack(theme);
    stack.resize(720, 200);
    stack.show();
    const int trace = stack.strips().addTrace(
        {s("velocity"), s("u"), TraceRole::Velocity, 0}, std::make_shared<FixedTrace>(stepAt(9.0, 34'000.0, 60'000.0)));
    stack.strips().addTrace(
        {s("other"), s("u"), TraceRole::Temperature, 0}, std::make_shared<FixedTrace>(stepAt(9.0, 0.0, 0.0)));
    stack.strips().setTrigger(PlotTrigger{trace, 30'000.0, s("trigger at 30 000")});
    stack.view().setRange(0, 10);
    stack.refresh(0);
    stack.plot().replot();
    const QCPAxisRect &rect = *stack.plot().axisRect(0);
    const auto words = stripWords(
        stack.strips().at(0).decor, rect, theme.theme().font(TextRole::Caption, stack.font()), theme.theme());
    QCOMPARE(words.size(), 1U);
    const double curve = rect.axis(QCPAxis::atLeft)->coordToPixel(34'000.0);
    QVERIFY2(words.front().place.top() > curve || words.front().place.bottom() < curve,
        qPrintable(s("words at %1 to %2 on a curve at %3")
                       .arg(words.front().place.top())
                       .arg(words.front().place.bottom())
                       .arg(curve)));
}

void ClearCurvesTest::aPlotWithoutTracesSaysNothingOfItsTime()
{
    const ThemeSource theme(darkTheme());
    PlotStack stack(theme);
    stack.resize(600, 300);
    stack.show();
    stack.view().setRange(0, 12);
    stack.refresh(0);
    QCOMPARE(stack.strips().foot()->left(), QString());
    Strips strips;
    QVERIFY(!strips.stack.strips().foot()->left().isEmpty());
}

MB_WINDOW_TEST(ClearCurvesTest);
#include "tst_clearcurves.moc"
