// SPDX-License-Identifier: GPL-3.0-or-later
// What of the trials is in sight in a small window, which column sorts them, and how far the tuning of a loop has come.
#include "support/windowtests.h"
#include "trialbench.h"
#include "widgets/common/applytheme.h"
#include "widgets/common/numberformat.h"
#include "widgets/control/envelopepanel.h"
#include "widgets/control/tuneframe.h"
#include "widgets/control/tunesteps.h"

#include <QFileDialog>
#include <QHeaderView>

using namespace mb;
using namespace mb::test;

class TestTrialSight : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void theHeadThatSortsSaysSoBesideItsWord();
    void aColumnThatFitsIsShown();
    void theStepsSayWhatIsDoneAndWhatIsNext();
    void theSmallestWindowShowsTheCurrentAndKeepsTheResponseLarge();
    void aTrialThatIsForgottenIsNotLookedAtAnyMore();
    void theReportHasOnlyTrialsThatAreKept();
    void withoutAHeadThePlotSaysItselfWhatItsLinesAre();
    void theStepsAreWholeOrAway();
    void twoThatWereHeldForOtherTimesAreDrawnWithoutTheirReturns();
};

void TestTrialSight::theHeadThatSortsSaysSoBesideItsWord()
{
    TrialBench bench;
    auto &list = bench.page->trials().list();
    const auto head
        = [&list](int column) { return list.model().headerData(column, Qt::Horizontal, Qt::DisplayRole).toString(); };
    QCOMPARE(head(TrialModel::Number), s("trial ▼"));
    QCOMPARE(head(TrialModel::Settle), s("settle"));
    list.table().sortByColumn(TrialModel::Settle, Qt::AscendingOrder);
    QCOMPARE(head(TrialModel::Settle), s("settle ▲"));
    QCOMPARE(head(TrialModel::Number), s("trial"));
    QVERIFY(!list.table().horizontalHeader()->isSortIndicatorShown());
}

void TestTrialSight::aColumnThatFitsIsShown()
{
    TrialBench bench;
    bench.choose(60'000.0);
    bench.arm();
    bench.page->run();
    bench.finish(0.7);
    auto &list = bench.page->trials().list();
    QTableView &table = list.table();
    for (int width = 1400; width > 500; width -= 7) {
        list.resize(width, 300);
        QCoreApplication::processEvents();
        const int room = table.columnWidth(TrialModel::Note) - table.fontMetrics().horizontalAdvance(s("000000"));
        for (const int column : {TrialModel::Rise, TrialModel::Peak}) {
            if (table.isColumnHidden(column)) // three digits and their margins would have had room
                QVERIFY2(room < 110, qPrintable(s("%1: column %2, %3 free").arg(width).arg(column).arg(room)));
        }
    }
}

void TestTrialSight::theStepsSayWhatIsDoneAndWhatIsNext()
{
    TrialBench bench;
    const auto &steps = *bench.page->findChild<TuneSteps *>();
    QVERIFY(!steps.isHidden());
    QCOMPARE(steps.next(), static_cast<int>(TuneSteps::Direction));
    for (const auto wrong : {DirectionVerdict::Reversed, DirectionVerdict::NoMotion}) {
        bench.device().profile.edit().verdicts["direction"] = wrong;
        bench.workbench.publish();
        QVERIFY2(!steps.isDone(TuneSteps::Direction), toString(wrong).data());
    }
    bench.device().profile.edit().verdicts["direction"] = DirectionVerdict::Agrees;
    bench.choose(60'000.0);
    bench.arm();
    QTRY_VERIFY(steps.isDone(TuneSteps::Direction));
    QVERIFY(steps.isDone(TuneSteps::Envelope) == bench.page->findChild<EnvelopePanel *>()->missing().isEmpty());
    QVERIFY(steps.isDone(TuneSteps::Gains));
    QVERIFY(!steps.isDone(TuneSteps::Identify));
    QVERIFY(!steps.isDone(TuneSteps::Verify));
    bench.page->run();
    tuning::Trial trial = bench.finish(0.7); // with other gains than the device has
    bench.workbench.publish();
    QVERIFY(!steps.isDone(TuneSteps::Verify));
    KeptTrial pushed;
    pushed.number = 7;
    pushed.trial = trial;
    pushed.trial.mode = Mode::Duty;
    bench.workbench.book.kept.push_back(pushed);
    KeptTrial ran = bench.workbench.book.kept.front();
    ran.number = 8;
    ran.trial.gains.clear();
    for (const char *key : {"slot0.p", "slot0.i", "slot0.d", "slot0.f"}) {
        const auto index = named(key);
        const auto raw = (*bench.device().parameters)[index.value].raw;
        QVERIFY(raw);
        ran.trial.gains.emplace_back(key, std::get<double>(toValue(dmc60c().parameters[index.value], *raw)));
    }
    bench.workbench.book.kept.push_back(ran);
    bench.page->trials().reload();
    QTRY_COMPARE(bench.page->trials().list().identified(), 7);
    bench.workbench.publish();
    QVERIFY(steps.isDone(TuneSteps::Identify));
    QVERIFY(steps.isDone(TuneSteps::Verify));
    QVERIFY2(steps.toolTipOf(TuneSteps::Verify).contains(s("#8")), qPrintable(steps.toolTipOf(TuneSteps::Verify)));
    bench.page->form().choose(Mode::Duty, 0.1);
    QTRY_VERIFY(steps.isHidden());
}

/// The page as a window of 1280 x 800 leaves it, beside the devices.
void TestTrialSight::theSmallestWindowShowsTheCurrentAndKeepsTheResponseLarge()
{
    TrialBench bench(lightTheme(), QSize(1048, 600));
    bench.choose(60'000.0);
    bench.arm();
    bench.page->run();
    tuning::Trial trial = bench.finish(0.7);
    tuning::Signal current{"current", "A", {}};
    for (int i = -40; i < 400; ++i)
        current.trace.add(i * 0.005, i < 0 ? 0.0 : 20.0);
    bench.workbench.book.recorded[1].push_back(current);
    bench.page->trials().select(1);
    auto &plot = bench.page->trials().plot();
    QTRY_COMPARE(plot.stack().strips().all().size(), std::size_t(3));
    QVERIFY2(plot.width() >= 430, qPrintable(QString::number(plot.width())));
    const auto heightOf = [&plot](int strip) { return plot.stack().strips().at(strip).rect().height(); };
    QTRY_VERIFY2(heightOf(0) >= 2 * heightOf(2), qPrintable(s("%1 and %2").arg(heightOf(0)).arg(heightOf(2))));
    auto &metrics = bench.page->trials().metrics();
    for (int row = 0; row < metrics.table().rowCount(); ++row) {
        const QTableWidgetItem &name = *metrics.table().item(row, 0);
        const int needed = QFontMetrics(name.font()).horizontalAdvance(name.text()) + 14;
        QVERIFY2(needed <= metrics.table().columnWidth(0), qPrintable(name.text()));
    }
}

void TestTrialSight::aTrialThatIsForgottenIsNotLookedAtAnyMore()
{
    TrialBench bench;
    bench.choose(60'000.0);
    bench.arm();
    for (const double damping : {0.5, 0.7}) {
        bench.page->run();
        bench.finish(damping);
    }
    for (KeptTrial &kept : bench.workbench.book.kept)
        kept.time = 1.7e9;
    TrialsView &trials = bench.page->trials();
    trials.reload();
    QTRY_COMPARE(trials.b()->time, 1.7e9);
    bench.workbench.book.remove(2, [](const Result<void> &) {});
    trials.reload();
    QTRY_VERIFY(trials.b() && trials.b()->number == 1); // the newest that is left
    QCOMPARE(trials.b()->trial.signals.size(), 2U);
    bench.workbench.book.remove(1, [](const Result<void> &) {});
    trials.reload();
    QTRY_VERIFY(!trials.a() && !trials.b());
    QCOMPARE(bench.metric(0, 2), QString(UnknownMark));
}

void TestTrialSight::withoutAHeadThePlotSaysItselfWhatItsLinesAre()
{
    TrialBench bench;
    const auto names = [&bench] {
        QStringList all;
        for (const HeadEntry &entry : bench.page->trials().plot().stack().strips().at(0).decor.entries)
            all += entry.name;
        return all;
    };
    bench.choose(60'000.0);
    bench.arm();
    for (const double damping : {0.5, 0.7}) {
        bench.page->run();
        bench.finish(damping);
    }
    QVERIFY(names().isEmpty());   // they stand above
    bench.page->resize(640, 320); // one part at a time
    QVERIFY(bench.page->frame().isCompact());
    QCOMPARE(names(), (QStringList{s("A #1"), s("B #2"), s("set-point")}));
}

void TestTrialSight::theStepsAreWholeOrAway()
{
    TrialBench bench;
    bench.page->showLive(true); // which has a sentence beside them
    const auto *steps = bench.page->findChild<TuneSteps *>();
    for (int width = 560; width < 1300; width += 20) {
        bench.page->resize(width, 580);
        bench.workbench.publish();
        QCoreApplication::processEvents();
        QVERIFY2(
            steps->width() == 0 || steps->width() >= steps->sizeHint().width(), qPrintable(QString::number(width)));
    }
}

void TestTrialSight::theReportHasOnlyTrialsThatAreKept()
{
    TrialBench bench;
    bench.choose(60'000.0);
    bench.arm();
    bench.page->run();
    bench.finish(0.5);
    bench.page->run();
    const auto planned = bench.workbench.given<orders::RunTrial>().back();
    tuning::Trial lost = responseOf(planned.plan, 0, 0.7, bench.unit()); // the disk was full
    lost.number.reset();
    planned.finished(lost);
    QCOMPARE(bench.page->trials().b()->number, std::int64_t{0});
    QTest::keyClick(bench.page.get(), Qt::Key_P, Qt::ControlModifier);
    auto *const dialog = bench.page->findChild<QFileDialog *>();
    QVERIFY(dialog);
    Q_EMIT dialog->fileSelected(s("/nonexistent/a.html"));
    QCOMPARE(bench.workbench.book.wishes.back().trials, std::vector<std::int64_t>{1});
}

void TestTrialSight::twoThatWereHeldForOtherTimesAreDrawnWithoutTheirReturns()
{
    TrialBench bench(lightTheme(), QSize(1280, 800));
    tuning::ExperimentPlan plan;
    plan.mode = Mode::Velocity;
    plan.to = 60'000.0;
    KeptTrial one{1, 0.0, responseOf(plan, 1, 0.4, bench.unit()), false, {}};
    KeptTrial other{2, 0.0, responseOf(plan, 2, 0.7, bench.unit()), false, {}};
    ResponsePlot plot(bench.theme);
    plot.resize(600, 400);
    const auto lastKey = [&plot] {
        double last = 0.0;
        for (const auto &[id, trace] : plot.findChild<PlotStack *>()->strips().traces()) {
            std::vector<PlotPoint> points;
            trace.source->columns(-1.0, 10.0, 4000, points);
            last = points.empty() ? last : std::max(last, points.back().key);
        }
        return last;
    };
    plot.setTrials(bench.device().family, &one, &other, {});
    QVERIFY(lastKey() > 1.9); // both come back at the same time
    other.trial.holds = {{0.0, 0.8}};
    plot.setTrials(bench.device().family, &one, &other, {});
    QVERIFY2(
        lastKey() <= 1.0 && lastKey() > 0.9, qPrintable(QString::number(lastKey()))); // the longer one settles late
    other.trial.holds = {{0.0, 0.99}};
    plot.setTrials(bench.device().family, &one, &other, {});
    QVERIFY(lastKey() > 1.9);
}

MB_WINDOW_TEST(TestTrialSight);
#include "tst_trialsight.moc"
