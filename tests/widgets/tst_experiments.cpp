// SPDX-License-Identifier: GPL-3.0-or-later
// The Tune page around experiments: what F5 asks for, what comes back, how two trials are compared.
#include "support/windowtests.h"
#include "tunehand.h"
#include "tuning/verdict.h"
#include "widgets/common/numberformat.h"
#include "widgets/control/envelopepanel.h"
#include "widgets/control/gainspanel.h"
#include "widgets/control/metricspanel.h"
#include "widgets/control/responseplot.h"
#include "widgets/control/stimulusbar.h"
#include "widgets/control/triallist.h"
#include "widgets/control/trialsview.h"
#include "widgets/plots/plotstack.h"

#include <QAction>
#include <QTableView>
#include <QTableWidget>

using namespace mb;
using namespace mb::test;
using tuning::Trial;

namespace {

/// What the engine would answer: a second-order step with this damping.
Trial responseOf(const tuning::ExperimentPlan &plan, std::int64_t number, double damping, const std::string &unit)
{
    Trial trial;
    trial.number = number;
    trial.unit = unit;
    trial.device = "sim:can/dmc60c:5";
    trial.simulated = true;
    trial.mode = plan.mode;
    trial.axis = plan.axis;
    trial.stimulus = *tuning::Stimulus::make(plan.profile, plan.from.value_or(0.0), plan.to, plan.seconds, 0.02);
    trial.repeat = plan.repeat;
    trial.envelope = {1e6, 1e6, 60.0, 0.55};
    trial.gains = {{"slot0.p", 1.0 + damping}, {"slot0.i", 0.003}};
    trial.reason = "done";
    trial.stopped = true;
    trial.holds = {{0.0, 1.0}};
    trial.returns = {{1.0, 2.0}};
    tuning::Signal velocity{"velocity", "counts/s", {}};
    tuning::Signal duty{"duty", "fraction", {}};
    constexpr double omega = 15.0;
    const double damped = omega * std::sqrt(1.0 - damping * damping);
    const auto step = [&](double t) {
        return t <= 0.0 ? 0.0
                        : 1.0
                - std::exp(-damping * omega * t)
                    * (std::cos(damped * t) + damping * omega / damped * std::sin(damped * t));
    };
    for (int i = -40; i < 400; ++i) {
        const double t = i * 0.005;
        velocity.trace.add(t, trial.stimulus.to * (step(t) - step(t - 1.0)));
        duty.trace.add(t, t < 0.0 ? 0.0 : t < 0.08 ? 0.55 : 0.3);
    }
    trial.signals = {velocity, duty};
    trial.metrics = tuning::readResponse(velocity.trace.part(-0.2, 1.0), trial.stimulus.to, 5.0).metrics;
    trial.metrics.saturated = 0.08;
    return trial;
}

/// The page in its first view, with a notebook.
struct TrialBench : TuneBench {
    TrialBench()
    {
        page->showLive(false);
        device().selector = "sim:can/dmc60c:5";
        device().liveness.heard = true;
        workbench.publish();
    }
    [[nodiscard]] std::string unit() { return tuning::unitOf(device().identity, device().selector, true); }
    void choose(double to, int repeat = 1)
    {
        StimulusChoice choice;
        choice.to = to;
        choice.repeat = repeat;
        page->chooseStimulus(Mode::Velocity, choice);
    }
    /// As the engine ends it: kept, then told.
    Trial finish(double damping)
    {
        const auto planned = workbench.plans.back();
        const Trial trial
            = responseOf(planned.plan, static_cast<std::int64_t>(workbench.plans.size()), damping, unit());
        KeptTrial kept;
        kept.number = *trial.number;
        kept.trial = trial;
        workbench.book.recorded[kept.number] = trial.signals;
        kept.trial.signals.clear();
        workbench.book.kept.push_back(kept);
        planned.finished(trial);
        QCoreApplication::processEvents();
        QCoreApplication::processEvents();
        return trial;
    }
    [[nodiscard]] QString metric(int row, int column)
    {
        return page->trials().metrics().table().item(row, column)->text();
    }
};

} // namespace

class TestExperiments : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void oneKeyWritesWhatIsStagedAndRuns();
    void nothingRunsUnlessArmedAndInsideTheEnvelope();
    void whatIsMeasuredIsShownBeforeTheMotorIsBack();
    void twoTrialsLieOverEachOtherWithTheirDifferenceInWords();
    void anotherStimulusIsNotDrawnOverB();
    void theGainsOfATrialComeBackAsEdits();
    void theListSortsFiltersStarsAndNotes();
    void aGuardLatchesTheStopAndSaysItsName();
    void haltEndsATrialAndStaysArmed();
    void aModeWithoutALoopSendsOneToLive();
    void theJogKeyMovesForAsLongAsItIsHeld();
    void tenThousandTrialsAreListedAtOnce();
    void everyControlHasAName();
    void thePlotKeepsAThirdOfThePageAtTwiceTheFont();
};

void TestExperiments::oneKeyWritesWhatIsStagedAndRuns()
{
    TrialBench bench;
    bench.choose(60'000.0, 4);
    type(bench.find<QLineEdit>("P"), "1.5");
    QTest::keyClick(bench.find<QLineEdit>("P"), Qt::Key_Return);
    bench.arm();
    QTest::keyClick(bench.page.get(), Qt::Key_F5);
    QCOMPARE(bench.workbench.plans.size(), 1U);
    const tuning::ExperimentPlan &plan = bench.workbench.plans.back().plan;
    QCOMPARE(plan.to, 60'000.0);
    QCOMPARE(plan.repeat, 4);
    QVERIFY(plan.mode == Mode::Velocity);
    QCOMPARE(plan.gains.size(), 1U);
    QCOMPARE(plan.gains.front().raw, rawOf("slot0.p", 1.5));
    QVERIFY(plan.keep == tuning::Keep::WhenDone);
    QVERIFY(bench.arming.isMoving());
    QVERIFY(bench.workbench.callsOf("startMotion").empty());
    QTest::keyClick(bench.page.get(), Qt::Key_F5);
    QCOMPARE(bench.workbench.plans.size(), 1U); // one at a time
    bench.finish(0.7);
    QVERIFY(bench.arming.isArmed({1}) && !bench.arming.isMoving()); // ready again
    QTest::keyClick(bench.page.get(), Qt::Key_F5);
    QCOMPARE(bench.workbench.plans.size(), 2U);
}

void TestExperiments::nothingRunsUnlessArmedAndInsideTheEnvelope()
{
    TrialBench bench;
    bench.choose(60'000.0);
    QTest::keyClick(bench.page.get(), Qt::Key_F5);
    QVERIFY(bench.workbench.plans.empty());
    QVERIFY2(problemOf(bench).startsWith(s("Not armed")), qPrintable(problemOf(bench)));
    bench.arm();
    auto *speed = bench.find<QLineEdit>("Envelope: Speed");
    QVERIFY(speed);
    speed->setText(s("50000"));
    Q_EMIT speed->textEdited(speed->text());
    QTest::keyClick(bench.page.get(), Qt::Key_F5);
    QVERIFY(bench.workbench.plans.empty());
    QVERIFY2(problemOf(bench).contains(s("50000")), qPrintable(problemOf(bench)));
    speed->setText(s("70000"));
    Q_EMIT speed->textEdited(speed->text());
    QTest::keyClick(bench.page.get(), Qt::Key_F5);
    QCOMPARE(bench.workbench.plans.size(), 1U);
    QCOMPARE(bench.workbench.plans.back().plan.limits.speed, std::optional(70'000.0));
}

void TestExperiments::whatIsMeasuredIsShownBeforeTheMotorIsBack()
{
    TrialBench bench;
    bench.choose(60'000.0);
    bench.arm();
    bench.page->run();
    QCOMPARE(bench.metric(0, 2), QString(UnknownMark));
    const auto planned = bench.workbench.plans.back();
    planned.measured(responseOf(planned.plan, 1, 0.5, bench.unit()));
    QCOMPARE(bench.metric(0, 2), s("16.3")); // the golden overshoot
    QVERIFY(bench.arming.isMoving());
}

void TestExperiments::twoTrialsLieOverEachOtherWithTheirDifferenceInWords()
{
    TrialBench bench;
    bench.choose(60'000.0);
    bench.arm();
    bench.page->run();
    bench.finish(0.5);
    bench.page->run();
    bench.finish(0.7);
    TrialsView &trials = bench.page->trials();
    QVERIFY(trials.a() && trials.b());
    QCOMPARE(trials.a()->number, 1);
    QCOMPARE(trials.b()->number, 2);
    QCOMPARE(bench.metric(0, 1), s("16.3"));
    QCOMPARE(bench.metric(0, 2), s("4.6"));
    QCOMPARE(bench.metric(0, 3), s("\u221211.7 ▼ better"));
    QVERIFY2(bench.metric(3, 3).endsWith(s("▲ slower")), qPrintable(bench.metric(3, 3)));
    QCOMPARE(trials.plot().stack().traceCount(), 5); // twice velocity and duty, and the set-point
    QVERIFY(trials.metrics().chips().contains(s("SAT 8 %")));
    QVERIFY(trials.metrics().chips().contains(s("SIMULATED")));
    QTest::keyClick(bench.page.get(), Qt::Key_B);
    QCOMPARE(trials.a()->number, 2);
    QCOMPARE(bench.metric(0, 3), s("+11.7 ▲ worse"));
}

void TestExperiments::anotherStimulusIsNotDrawnOverB()
{
    TrialBench bench;
    bench.choose(60'000.0);
    bench.arm();
    bench.page->run();
    bench.finish(0.5);
    bench.choose(30'000.0);
    bench.page->run();
    bench.finish(0.5);
    QVERIFY(!bench.page->trials().isComparable());
    QCOMPARE(bench.page->trials().plot().stack().traceCount(), 3);
}

void TestExperiments::theGainsOfATrialComeBackAsEdits()
{
    TrialBench bench;
    bench.choose(60'000.0);
    bench.arm();
    bench.page->run();
    bench.finish(0.5); // with P 1.5
    auto &list = bench.page->trials().list();
    list.table().selectRow(0);
    click(bench, "Use these gains");
    QVERIFY(bench.workbench.callsOf("writeParameters").empty()); // staged, never written
    QCOMPARE(bench.page->gainsPanel().toWrite().size(), 2U);
    bench.page->run();
    QCOMPARE(bench.workbench.plans.back().plan.gains.size(), 2U);
}

void TestExperiments::theListSortsFiltersStarsAndNotes()
{
    TrialBench bench;
    bench.choose(60'000.0);
    bench.arm();
    for (const double damping : {0.5, 0.9, 0.7}) {
        bench.page->run();
        bench.finish(damping);
    }
    auto &list = bench.page->trials().list();
    TrialModel &model = list.model();
    QCOMPARE(model.at(0)->number, 3);
    list.table().sortByColumn(TrialModel::Over, Qt::AscendingOrder);
    QCOMPARE(model.at(0)->number, 2);
    QCOMPARE(model.at(2)->number, 1);
    Q_EMIT model.starChosen(2, true);
    QTRY_COMPARE(model.countOf(TrialModel::Filter::Starred), 1);
    QVERIFY(bench.workbench.book.find(2).star);
    model.setFilter(TrialModel::Filter::Starred);
    QCOMPARE(model.rowCount(), 1);
    QVERIFY(model.setData(model.index(0, TrialModel::Note), s("calm"), Qt::EditRole));
    QCOMPARE(QString::fromStdString(bench.workbench.book.find(2).note), s("calm"));
    model.setFilter(TrialModel::Filter::All);
    QCOMPARE(model.rowCount(), 3);
}

void TestExperiments::aGuardLatchesTheStopAndSaysItsName()
{
    TrialBench bench;
    bench.choose(60'000.0);
    bench.arm();
    bench.page->run();
    const auto planned = bench.workbench.plans.back();
    Trial trial = responseOf(planned.plan, 1, 0.5, bench.unit());
    trial.reason = "speed";
    trial.detail = "speed 81000 counts/s is above 1.2 × 60000 counts/s";
    trial.flags = {"aborted"};
    planned.finished(trial);
    QVERIFY(bench.arming.state() == LampState::Stopped);
    QVERIFY2(problemOf(bench).contains(s("speed guard")), qPrintable(problemOf(bench)));
    bench.page->run();
    QCOMPARE(bench.workbench.plans.size(), 1U);
}

void TestExperiments::haltEndsATrialAndStaysArmed()
{
    TrialBench bench;
    bench.choose(60'000.0);
    bench.arm();
    bench.page->run();
    bench.page->halt();
    QCOMPARE(bench.workbench.callsOf("stopMotion").size(), 1U);
    QVERIFY(bench.arming.isOnTrial()); // it still puts back what it has changed
    const auto planned = bench.workbench.plans.back();
    Trial trial = responseOf(planned.plan, 1, 0.5, bench.unit());
    trial.reason = "interrupted";
    planned.finished(trial);
    QVERIFY(bench.arming.isArmed({1}) && !bench.arming.isMoving());
}

void TestExperiments::aModeWithoutALoopSendsOneToLive()
{
    TrialBench bench;
    bench.arm();
    bench.find<QAbstractButton>("Follow mode")->click();
    bench.arm();
    QVERIFY2(problemOf(bench).contains(s("Live drives it")), qPrintable(problemOf(bench)));
    bench.page->showLive(true);
    QVERIFY2(!problemOf(bench).contains(s("Live drives it")), qPrintable(problemOf(bench)));
}

void TestExperiments::theJogKeyMovesForAsLongAsItIsHeld()
{
    TrialBench bench;
    bench.page->setFocus();
    QTest::keyPress(bench.page.get(), Qt::Key_J);
    QVERIFY(bench.workbench.callsOf("startMotion").empty()); // not armed
    QTest::keyRelease(bench.page.get(), Qt::Key_J);
    bench.arm();
    QTest::keyPress(bench.page.get(), Qt::Key_K);
    QCOMPARE(bench.workbench.callsOf("startMotion").size(), 1U);
    QVERIFY(bench.workbench.callsOf("startMotion").back().setPoint.mode == Mode::Duty);
    QCOMPARE(bench.workbench.callsOf("startMotion").back().setPoint.target, -0.08);
    QVERIFY(bench.workbench.callsOf("stopMotion").empty());
    QTest::keyRelease(bench.page.get(), Qt::Key_K);
    QCOMPARE(bench.workbench.callsOf("stopMotion").size(), 1U);
    QVERIFY(bench.arming.isArmed({1}) && !bench.arming.isMoving());
    QTest::keyPress(bench.page.get(), Qt::Key_J);
    bench.page->hide(); // nobody sees it any more
    QCOMPARE(bench.workbench.callsOf("stopMotion").size(), 2U);
}

void TestExperiments::tenThousandTrialsAreListedAtOnce()
{
    TrialBench bench;
    tuning::ExperimentPlan plan;
    plan.to = 60'000.0;
    KeptTrial kept;
    kept.trial = responseOf(plan, 1, 0.5, bench.unit());
    kept.trial.signals.clear();
    std::vector<KeptTrial> many;
    for (int i = 1; i <= 10'000; ++i) {
        kept.number = i;
        kept.trial.metrics.settle = (i * 7919 % 10'007) / 1e4;
        many.push_back(kept);
    }
    auto &list = bench.page->trials().list();
    QElapsedTimer time;
    time.start();
    list.setTrials(many);
    list.table().sortByColumn(TrialModel::Settle, Qt::AscendingOrder);
    const qint64 spent = time.elapsed();
    qInfo("10 000 trials listed and sorted in %lld ms", static_cast<long long>(spent));
    QCOMPARE(list.model().rowCount(), 10'000);
    QVERIFY(spent <= 200);
}

void TestExperiments::everyControlHasAName()
{
    TrialBench bench;
    for (const auto *widget : bench.page->findChildren<QWidget *>()) {
        const bool control = qobject_cast<const QAbstractButton *>(widget) || qobject_cast<const QLineEdit *>(widget)
            || qobject_cast<const QComboBox *>(widget) || qobject_cast<const QAbstractItemView *>(widget);
        const bool inner = widget->objectName().startsWith(s("qt_")) || widget->inherits("QTableCornerButton")
            || widget->inherits("QHeaderView") || widget->inherits("QComboBoxListView");
        const auto *button = qobject_cast<const QAbstractButton *>(widget);
        const bool spoken = !widget->accessibleName().isEmpty() || (button && !button->text().isEmpty());
        if (control && !inner)
            QVERIFY2(spoken, qPrintable(QLatin1String(widget->metaObject()->className()) + widget->objectName()));
    }
}

void TestExperiments::thePlotKeepsAThirdOfThePageAtTwiceTheFont()
{
    const QFont before = QApplication::font();
    for (const double size : {10.0, 20.0}) {
        QFont font = before;
        font.setPointSizeF(size);
        QApplication::setFont(font);
        applyTheme(*qApp, lightTheme(size));
        TuneBench bench(lightTheme(size), size > 15.0 ? QSize(1800, 1200) : QSize(1208, 700));
        bench.page->showLive(false);
        bench.workbench.publish();
        QCoreApplication::processEvents();
        const QSize plot = bench.page->trials().plot().size();
        const double share = 1.0 * plot.width() * plot.height() / (bench.page->width() * bench.page->height());
        qInfo("%.0f pt: plot %d x %d, %.0f %% of the page", size, plot.width(), plot.height(), share * 100.0);
        if (size > 15.0)
            QVERIFY(share >= 1.0 / 3.0);
    }
    QApplication::setFont(before);
    applyTheme(*qApp, lightTheme());
}

MB_WINDOW_TEST(TestExperiments);
#include "tst_experiments.moc"
