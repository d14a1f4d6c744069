// SPDX-License-Identifier: GPL-3.0-or-later
// How the parts of the Design page name and space what they show.
#include "designbench.h"
#include "support/windowtests.h"
#include "widgets/control/gainunits.h"
#include "widgets/control/tunechoices.h"
#include "widgets/design/adviserlist.h"
#include "widgets/design/bodeplot.h"
#include "widgets/design/designcolumn.h"
#include "widgets/plots/curvelegend.h"
#include "widgets/plots/curveplot.h"

#include <QLabel>

using namespace mb;
using namespace mb::test;
using namespace mb::tuning;

class TestDesignRoom : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase();
    void labelsOfALowPlotDoNotTouch_data();
    void labelsOfALowPlotDoNotTouch();
    void thePhaseOfALowPlotHasLabelsThatDoNotTouch();
    void theUnitOfXStandsInTheLineOfItsNumbers();
    void aBoundOfAPositionHasItsNameOfTheParameterTable();
    void whatAnAdviserWouldStageIsNamedAsInTheTableAndFitsItsColumn();
    void linesOfALegendStandCloserThanItsNames();
    void oneLineStandsAboveTheLimitsWhereThereIsNoSet();
    void gainsAreInTheTurnsOfTheShaftThatTuneHas();
};

namespace {

/// What its labels of y lack to stand clear of each other, px; at most 0 where none touches.
int overlapOfLabels(CurvePlot &plot)
{
    for (int i = 0; i < 4; ++i) // the spacing follows the layout
        QCoreApplication::processEvents();
    const QCPAxis &axis = *plot.plot().yAxis;
    const QVector<double> ticks = axis.tickVector();
    const int height = QFontMetrics(axis.tickLabelFont()).height();
    int most = -height;
    for (int i = 1; i < ticks.size(); ++i) {
        const double apart = std::abs(axis.coordToPixel(ticks[i]) - axis.coordToPixel(ticks[i - 1]));
        most = std::max(most, height - static_cast<int>(apart));
    }
    return most;
}

int seenLabels(const CurvePlot &plot)
{
    const QVector<double> ticks = const_cast<CurvePlot &>(plot).plot().yAxis->tickVector();
    const QCPRange range = const_cast<CurvePlot &>(plot).plot().yAxis->range();
    return static_cast<int>(
        std::count_if(ticks.begin(), ticks.end(), [&range](double tick) { return range.contains(tick); }));
}

} // namespace

void TestDesignRoom::initTestCase()
{
    dressAsTheProgram();
}

void TestDesignRoom::labelsOfALowPlotDoNotTouch_data()
{
    QTest::addColumn<int>("height");
    for (const int height : {70, 80, 95, 120, 200, 400})
        QTest::addRow("%d px", height) << height;
}

void TestDesignRoom::labelsOfALowPlotDoNotTouch()
{
    QFETCH(int, height);
    const ThemeSource theme(darkTheme());
    CurvePlot plot(theme, QStringLiteral("Step"));
    plot.resize(500, height);
    plot.show();
    Curve curve;
    curve.x = {0.0, 1.0};
    curve.y = {0.0, 400'000.0};
    plot.setCurves({curve});
    QVERIFY2(overlapOfLabels(plot) <= 0, qPrintable(QString::number(overlapOfLabels(plot))));
    QVERIFY(seenLabels(plot) >= 1);
}

void TestDesignRoom::thePhaseOfALowPlotHasLabelsThatDoNotTouch()
{
    const ThemeSource theme(darkTheme());
    BodePlot bode(theme);
    const TuneReport report = identified();
    const Proposal &proposal = report.proposals[1];
    bode.setLoop(Mode::Velocity, report.plant, proposal.gains.made, proposal.margins);
    bode.show();
    for (const int height : {190, 240, 300, 500}) {
        bode.resize(600, height);
        for (CurvePlot *plot : bode.findChildren<CurvePlot *>()) {
            QVERIFY2(overlapOfLabels(*plot) <= 0, qPrintable(plot->accessibleName() + QString::number(height)));
            QVERIFY2(seenLabels(*plot) >= 1, qPrintable(plot->accessibleName() + QString::number(height)));
        }
    }
    QCOMPARE(seenLabels(*bode.findChildren<CurvePlot *>().last()), 4); // every quarter turn where there is room
}

void TestDesignRoom::theUnitOfXStandsInTheLineOfItsNumbers()
{
    const ThemeSource theme(darkTheme());
    CurvePlot plot(theme, QStringLiteral("Step"));
    plot.resize(500, 200);
    plot.show();
    plot.setAxes(QStringLiteral("s"), QStringLiteral("counts"), false);
    Curve curve;
    curve.x = {0.0, 1.0};
    curve.y = {0.0, 400.0};
    plot.setCurves({curve});
    plot.setSurroundings({false, false, true, 78});
    plot.plot().replot();
    const int below = plot.plot().axisRect()->bottom();
    plot.setSurroundings({false, false, true, 78, true});
    plot.plot().replot();
    QVERIFY(plot.plot().axisRect()->bottom() > below + 10);
    const auto *const unit = [&plot] {
        for (int i = 0; i < plot.plot().itemCount(); ++i) {
            if (auto *const text = qobject_cast<QCPItemText *>(plot.plot().item(i));
                text && text->text() == QStringLiteral("s"))
                return text;
        }
        return static_cast<QCPItemText *>(nullptr);
    }();
    QVERIFY(unit && unit->visible());
    QVERIFY(unit->position->pixelPosition().x() > plot.plot().axisRect()->right() + 10);
}

void TestDesignRoom::aBoundOfAPositionHasItsNameOfTheParameterTable()
{
    DesignBench bench;
    bench.arm();
    bench.page->chooseLoop(Mode::Position);
    bench.page->identify();
    TuneReport report = identified();
    report.loop = Mode::Position;
    for (Proposal &proposal : report.proposals)
        proposal.gains.rows.push_back({"slot0.nominal_forward", 1234, 1234.0});
    bench.finish(report);
    bench.page->resize(1208, 1400);
    QCoreApplication::processEvents();
    QStringList words;
    for (const QLabel *label : bench.cards().front()->findChildren<QLabel *>())
        words << label->text();
    QVERIFY2(words.contains(QStringLiteral("Nominal forward")), qPrintable(words.join(QLatin1Char('|'))));
    QVERIFY2(words.filter(QStringLiteral("NOMINAL")).isEmpty(), qPrintable(words.join(QLatin1Char('|'))));
    QCOMPARE(words.filter(QStringLiteral("1\u202F234")).size(), 1); // its raw number is the same
    for (const QLabel *label : bench.cards().front()->findChildren<QLabel *>())
        QVERIFY2(!label->isVisible() || label->width() >= label->sizeHint().width(), qPrintable(label->text()));
}

void TestDesignRoom::whatAnAdviserWouldStageIsNamedAsInTheTableAndFitsItsColumn()
{
    DesignBench bench;
    bench.workbench.shot.devices[0].parameters.edit()[named("slot0.ramp").value].raw = 20;
    bench.arm();
    bench.page->identify();
    bench.finish(identified());
    bench.page->resize(1047, 607);
    QCoreApplication::processEvents();
    const auto *const advisers = bench.page->findChild<AdviserList *>();
    QStringList words;
    for (const QLabel *label : advisers->findChildren<QLabel *>())
        words << label->text();
    QVERIFY2(!words.filter(QStringLiteral("Ramp = ")).isEmpty(), qPrintable(words.join(QLatin1Char('|'))));
    const auto *const viewport = advisers->parentWidget()->parentWidget();
    QVERIFY2(advisers->parentWidget()->width() <= viewport->width(), "nothing is behind its right edge");
}

void TestDesignRoom::linesOfALegendStandCloserThanItsNames()
{
    const ThemeSource theme(darkTheme());
    CurveLegend legend(theme, {});
    legend.setEntries({{QStringLiteral("measured, forwards"), {}}, {QStringLiteral("measured, backwards"), {}}});
    const int one = legend.heightForWidth(1000);
    const int two = legend.heightForWidth(200);
    const int line = one - 14; // without the air around it
    QVERIFY2(two > one && two - one - line < 10, qPrintable(QString::number(two - one - line)));
}

void TestDesignRoom::oneLineStandsAboveTheLimitsWhereThereIsNoSet()
{
    DesignBench bench;
    QCoreApplication::processEvents();
    const auto *const column = bench.page->findChild<DesignColumn *>();
    int lines = 0;
    for (const QFrame *line : column->findChildren<QFrame *>()) {
        if (line->property("line").toBool() && line->isVisible()
            && line->parentWidget()->parentWidget() == column->viewport())
            ++lines;
    }
    QCOMPARE(lines, 1);
}

void TestDesignRoom::gainsAreInTheTurnsOfTheShaftThatTuneHas()
{
    DesignBench bench;
    bench.arm();
    bench.page->identify();
    bench.finish(identified());
    const auto same = [&bench](double counts) {
        const auto si = siGain(dmc60c(), dmc60c().parameters[named("slot0.p").value], Mode::Velocity, 0.6, counts);
        const auto labels = bench.cards().front()->findChildren<QLabel *>();
        return si && std::ranges::count(labels, si->text(), &QLabel::text) == 1;
    };
    QVERIFY2(!same(4096.0), "nobody has told them");
    TuneChoices choices(bench.workbench, bench.selection);
    choices.of(bench.workbench.device(0), 0).units.countsPerRevolution = 2000.0; // somebody told it there
    bench.workbench.publish();
    QVERIFY(same(2000.0));
}

MB_WINDOW_TEST(TestDesignRoom);
#include "tst_designroom.moc"
