// SPDX-License-Identifier: GPL-3.0-or-later
// The Tune page around experiments: what F5 asks for, what comes back, how two trials are compared.
#include "support/windowtests.h"
#include "trialbench.h"
#include "widgets/common/applytheme.h"
#include "widgets/common/numberformat.h"
#include "widgets/control/envelopepanel.h"
#include "widgets/control/gainspanel.h"
#include "widgets/control/tuneframe.h"

#include <QAbstractItemModelTester>
#include <QAction>
#include <QLineEdit>
#include <QMenu>
#include <QPointer>

using namespace mb;
using namespace mb::test;
using tuning::Trial;

class TestExperiments : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void oneKeyWritesWhatIsStagedAndRuns();
    void nothingRunsUnlessArmedAndInsideTheEnvelope();
    void aKindThatWouldLeaveTheEnvelopeCannotBeChosen();
    void aTimeThatIsFarTooLongIsRefusedAndNotLookedAt();
    void whatIsMeasuredIsShownBeforeTheMotorIsBack();
    void twoTrialsLieOverEachOtherWithTheirDifferenceInWords();
    void anotherStimulusIsNotDrawnOverB();
    void theGainsOfATrialComeBackAsEdits();
    void theListSortsFiltersStarsAndNotes();
    void aNoteThatIsBeingWrittenOutlivesTheEndOfATrial();
    void aGuardLatchesTheStopAndSaysItsName();
    void aPartOfAStepIsNotCalledBetterOrWorse();
    void whatIsNoDifferenceTellsTheSpreadThatHidesIt();
    void haltEndsATrialAndStaysArmed();
    void aModeWithoutALoopSendsOneToLive();
    void theJogKeyMovesForAsLongAsItIsHeld();
    void theJogKeyEndsWhateverElseIsHeldOrOpen();
    void tenThousandTrialsAreListedAtOnce();
    void everyControlHasAName();
    void thePlotKeepsAThirdOfThePageAtTwiceTheFont();
    void withoutRoomOnePartIsShownAtATime();
};

void TestExperiments::oneKeyWritesWhatIsStagedAndRuns()
{
    TrialBench bench;
    bench.choose(60'000.0, 4);
    type(bench.find<QLineEdit>("P"), "1.5");
    QTest::keyClick(bench.find<QLineEdit>("P"), Qt::Key_Return);
    bench.arm();
    QTest::keyClick(bench.page.get(), Qt::Key_F5);
    QCOMPARE(bench.workbench.given<orders::RunTrial>().size(), 1U);
    const tuning::ExperimentPlan plan = bench.workbench.given<orders::RunTrial>().back().plan;
    QCOMPARE(plan.to, 60'000.0);
    QCOMPARE(plan.repeat, 4);
    QVERIFY(plan.mode == Mode::Velocity);
    QCOMPARE(plan.gains.size(), 1U);
    QCOMPARE(plan.gains.front().raw, rawOf("slot0.p", 1.5));
    QVERIFY(plan.keep == tuning::Keep::WhenDone);
    QVERIFY(bench.arming.isMoving());
    QVERIFY(bench.workbench.given<orders::StartMotion>().empty());
    QTest::keyClick(bench.page.get(), Qt::Key_F5);
    QCOMPARE(bench.workbench.given<orders::RunTrial>().size(), 1U); // one at a time
    bench.finish(0.7);
    QVERIFY(bench.arming.isArmed({1}) && !bench.arming.isMoving()); // ready again
    QTest::keyClick(bench.page.get(), Qt::Key_F5);
    QCOMPARE(bench.workbench.given<orders::RunTrial>().size(), 2U);
}

void TestExperiments::nothingRunsUnlessArmedAndInsideTheEnvelope()
{
    TrialBench bench;
    bench.choose(60'000.0);
    QTest::keyClick(bench.page.get(), Qt::Key_F5);
    QVERIFY(bench.workbench.given<orders::RunTrial>().empty());
    QVERIFY2(problemOf(bench).startsWith(s("Not armed")), qPrintable(problemOf(bench)));
    bench.arm();
    auto *speed = bench.find<QLineEdit>("Envelope: Speed");
    QVERIFY(speed);
    speed->setText(s("50000"));
    Q_EMIT speed->textEdited(speed->text());
    QTest::keyClick(bench.page.get(), Qt::Key_F5);
    QVERIFY(bench.workbench.given<orders::RunTrial>().empty());
    QVERIFY2(problemOf(bench).contains(QStringLiteral("50\u202F000")), qPrintable(problemOf(bench)));
    speed->setText(s("70000"));
    Q_EMIT speed->textEdited(speed->text());
    QTest::keyClick(bench.page.get(), Qt::Key_F5);
    QCOMPARE(bench.workbench.given<orders::RunTrial>().size(), 1U);
    QCOMPARE(bench.workbench.given<orders::RunTrial>().back().plan.limits.speed, std::optional(70'000.0));
}

void TestExperiments::aKindThatWouldLeaveTheEnvelopeCannotBeChosen()
{
    TrialBench bench;
    auto *travel = bench.find<QLineEdit>("Envelope: Travel ±");
    auto *list = bench.find<QComboBox>("Stimulus");
    QVERIFY(travel && list);
    const auto mayChoose = [&](tuning::Profile kind) {
        return list->model()->flags(list->model()->index(static_cast<int>(kind), 0)).testFlag(Qt::ItemIsEnabled);
    };
    const auto allow = [&](const char *counts) {
        travel->setText(s(counts));
        Q_EMIT travel->textEdited(travel->text());
    };
    bench.choose(60'000.0);
    allow("90000000");
    for (const tuning::Profile kind : StimulusBar::kinds())
        QVERIFY(mayChoose(kind));
    allow("100000");                           // at 60 000 counts/s
    QVERIFY(mayChoose(tuning::Profile::Step)); // the chosen one is said to be wrong beside it
    QVERIFY(!mayChoose(tuning::Profile::Chirp));
    const QString why = list->itemData(static_cast<int>(tuning::Profile::Chirp), Qt::ToolTipRole).toString();
    QVERIFY2(why.contains(QStringLiteral("100\u202F000")), qPrintable(why));
    allow("90000000");
    QVERIFY(mayChoose(tuning::Profile::Chirp));
}

/// What a step would do is worked out while its time is typed: 10^60 s of it would never come to an end.
void TestExperiments::aTimeThatIsFarTooLongIsRefusedAndNotLookedAt()
{
    TrialBench bench;
    bench.choose(60'000.0);
    auto *bar = bench.page->findChild<StimulusBar *>();
    auto *time = bench.find<QLineEdit>("Time of the stimulus");
    QVERIFY(bar && time);
    const auto before = bar->choice().seconds;
    for (const char *typed : {"1e60", "99999999999999999999999999", "-0", "1e400"}) {
        time->setText(s(typed));
        Q_EMIT time->textEdited(time->text());
        QVERIFY2(!bar->fault().isEmpty(), typed);
        QCOMPARE(bar->choice().seconds, before);
    }
}

void TestExperiments::whatIsMeasuredIsShownBeforeTheMotorIsBack()
{
    TrialBench bench;
    bench.choose(60'000.0);
    bench.arm();
    bench.page->run();
    QCOMPARE(bench.metric(0, 2), QString(UnknownMark));
    const auto planned = bench.workbench.given<orders::RunTrial>().back();
    planned.measured(responseOf(planned.plan, 1, 0.5, bench.unit()));
    QCOMPARE(bench.metric(0, 2), s("16.3")); // the golden overshoot
    QVERIFY(bench.arming.isMoving());
    tuning::ExperimentPlan ofAnotherLoop = planned.plan;
    ofAnotherLoop.mode = Mode::Position;
    bench.page->trials().showMeasured(responseOf(ofAnotherLoop, 1, 0.9, bench.unit()));
    QCOMPARE(bench.metric(0, 2), s("16.3"));
}

void TestExperiments::twoTrialsLieOverEachOtherWithTheirDifferenceInWords()
{
    TrialBench bench(lightTheme(), QSize(1600, 800));
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
    QCOMPARE(trials.plot().stack().strips().traceCount(), 5); // twice velocity and duty, and the set-point
    QVERIFY(trials.metrics().chips().contains(s("SAT 8 %")));
    QVERIFY(trials.metrics().chips().contains(s("SIMULATED")));
    QVERIFY(trials.metrics().chips().filter(s("WINDUP")).size() == 1);
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
    QCOMPARE(bench.page->trials().plot().stack().strips().traceCount(), 3);
}

void TestExperiments::theGainsOfATrialComeBackAsEdits()
{
    TrialBench bench;
    bench.choose(60'000.0);
    bench.arm();
    bench.page->run();
    bench.finish(0.5); // with P 1.5
    auto &list = bench.page->trials().list();
    const QRect use = list.table().visualRect(list.model().index(0, TrialModel::Use));
    QVERIFY2(list.table().viewport()->rect().contains(use), "the column Use is in sight");
    QTest::mouseClick(list.table().viewport(), Qt::LeftButton, {}, use.center());
    QVERIFY(bench.workbench.given<orders::WriteParameters>().empty()); // staged, never written
    QCOMPARE(bench.page->column().gainsPanel().toWrite().size(), 2U);
    bench.page->run();
    QCOMPARE(bench.workbench.given<orders::RunTrial>().back().plan.gains.size(), 2U);
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

void TestExperiments::aNoteThatIsBeingWrittenOutlivesTheEndOfATrial()
{
    TrialBench bench;
    bench.choose(60'000.0);
    bench.arm();
    TrialModel &model = bench.page->trials().list().model();
    const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::Fatal);
    for (const double damping : {0.5, 0.9}) {
        bench.page->run();
        bench.finish(damping);
    }
    QTableView &table = bench.page->trials().list().table();
    table.edit(model.index(model.rowOf(1), TrialModel::Note));
    const QPointer<QLineEdit> editor = table.viewport()->findChild<QLineEdit *>();
    QTest::keyClicks(editor, s("with the belt "));
    bench.page->run();
    bench.finish(0.7);
    QVERIFY(editor && model.rowCount() == 3);
    QTest::keyClicks(editor, s("off"));
    QTest::keyClick(editor, Qt::Key_Return);
    QTRY_COMPARE(bench.workbench.book.find(1).note, std::string("with the belt off"));
    bench.workbench.book.remove(2, [](const Result<void> &) {});
    bench.workbench.book.find(3).note = "of another window";
    bench.page->trials().reload();
    QTRY_COMPARE(model.rowCount(), 2);
    QCOMPARE(model.at(0)->note, std::string("of another window"));
}

void TestExperiments::aGuardLatchesTheStopAndSaysItsName()
{
    TrialBench bench;
    bench.choose(60'000.0);
    bench.arm();
    bench.page->run();
    const auto planned = bench.workbench.given<orders::RunTrial>().back();
    Trial trial = responseOf(planned.plan, 1, 0.5, bench.unit());
    trial.reason = tuning::EndReason::Speed;
    trial.detail = say("speed 81000 counts/s is above 1.2 × 60000 counts/s");
    trial.flags = {"aborted"};
    planned.finished(trial);
    QVERIFY(bench.arming.state() == LampState::Stopped);
    QVERIFY2(problemOf(bench).contains(s("speed guard")), qPrintable(problemOf(bench)));
    bench.page->run();
    QCOMPARE(bench.workbench.given<orders::RunTrial>().size(), 1U);
}

void TestExperiments::aPartOfAStepIsNotCalledBetterOrWorse()
{
    TrialBench bench(lightTheme(), QSize(1600, 800));
    KeptTrial whole;
    whole.number = 1;
    whole.trial.metrics.peakCurrent = 20.0;
    whole.trial.metrics.rise = 0.1;
    KeptTrial part = whole;
    part.number = 2;
    part.trial.metrics.peakCurrent = 8.0;
    part.trial.metrics.rise.reset();
    part.trial.flags = {"aborted"};
    MetricsPanel &metrics = bench.page->trials().metrics();
    metrics.setTrials(&whole, &part, {});
    QCOMPARE(bench.metric(6, 3), s("\u221212.0"));
    QCOMPARE(bench.metric(3, 3), QString());
    metrics.setTrials(&part, &whole, {});
    QCOMPARE(bench.metric(6, 3), s("+12.0"));
}

void TestExperiments::whatIsNoDifferenceTellsTheSpreadThatHidesIt()
{
    TrialBench bench(lightTheme(), QSize(1280, 800));
    KeptTrial one;
    one.number = 1;
    one.trial.metrics.settle = 0.511;
    KeptTrial other = one;
    other.number = 2;
    other.trial.metrics.settle = 0.808;
    other.trial.errors.settle = 0.310;
    other.trial.repeat = 2;
    MetricsPanel panel(bench.theme);
    panel.setTrials(&one, &other, {});
    for (const int width : {200, 800}) {
        panel.resize(width, 600);
        panel.show();
        QTest::qWait(0);
        const QTableWidgetItem &settle = *panel.table().item(2, 3);
        QVERIFY2(settle.text().endsWith(s("= same ±310")), qPrintable(settle.text()));
        QCOMPARE(settle.toolTip(), s("+297 = same ±310"));
        QStringList words;
        for (const QLabel *label : panel.findChildren<QLabel *>())
            words << label->text();
        QCOMPARE(words.contains(s("± from 2 repeats")), panel.table().item(2, 2)->text().contains(s("±")));
    }
}

void TestExperiments::haltEndsATrialAndStaysArmed()
{
    TrialBench bench;
    bench.choose(60'000.0);
    bench.arm();
    bench.page->run();
    bench.page->halt();
    QCOMPARE(bench.workbench.given<orders::StopMotion>().size(), 1U);
    QVERIFY(bench.arming.isOnTrial()); // it still puts back what it has changed
    const auto planned = bench.workbench.given<orders::RunTrial>().back();
    Trial trial = responseOf(planned.plan, 1, 0.5, bench.unit());
    trial.reason = tuning::EndReason::Interrupted;
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
    QVERIFY(bench.workbench.given<orders::StartMotion>().empty()); // not armed
    QTest::keyRelease(bench.page.get(), Qt::Key_J);
    bench.arm();
    QTest::keyPress(bench.page.get(), Qt::Key_K);
    QCOMPARE(bench.workbench.given<orders::StartMotion>().size(), 1U);
    QVERIFY(bench.workbench.given<orders::StartMotion>().back().setPoint.mode == Mode::Duty);
    QCOMPARE(bench.workbench.given<orders::StartMotion>().back().setPoint.target, -0.08);
    QVERIFY(bench.workbench.given<orders::StopMotion>().empty());
    QTest::keyRelease(bench.page.get(), Qt::Key_K);
    QCOMPARE(bench.workbench.given<orders::StopMotion>().size(), 1U);
    QVERIFY(bench.arming.isArmed({1}) && !bench.arming.isMoving());
    QTest::keyPress(bench.page.get(), Qt::Key_J);
    bench.page->hide(); // nobody sees it any more
    QCOMPARE(bench.workbench.given<orders::StopMotion>().size(), 2U);
}

void TestExperiments::theJogKeyEndsWhateverElseIsHeldOrOpen()
{
    TrialBench bench;
    bench.arm();
    const auto stops = [&] { return bench.workbench.given<orders::StopMotion>().size(); };
    const auto hold = [&](Qt::Key key) {
        bench.page->setFocus();
        QTest::keyPress(bench.page.get(), key);
        return bench.arming.isMoving();
    };
    QVERIFY(hold(Qt::Key_J));
    QTest::keyRelease(bench.page.get(), Qt::Key_J, Qt::ControlModifier);
    QCOMPARE(stops(), 1U);
    QMenu menu;
    menu.addAction(QStringLiteral("Copy"));
    QVERIFY(hold(Qt::Key_K));
    menu.popup({});
    QTest::keyRelease(&menu, Qt::Key_K);
    QCOMPARE(stops(), 2U);
    menu.hide();
    QLineEdit elsewhere;
    QVERIFY(hold(Qt::Key_J));
    Q_EMIT qApp->focusChanged(bench.page.get(), &elsewhere);
    QCOMPARE(stops(), 3U);
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
    qInfo("10 000 trials listed and sorted in %lld ms", static_cast<long long>(time.elapsed()));
    QCOMPARE(list.model().rowCount(), 10'000);
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

/// The page of a window of 1280 × 800 and of 1440 × 900 beside the devices, at both fonts; whichever part of it is chosen first.
void TestExperiments::thePlotKeepsAThirdOfThePageAtTwiceTheFont()
{
    const QFont before = QApplication::font();
    for (const double size : {10.0, 20.0}) {
        QFont font = before;
        font.setPointSizeF(size);
        QApplication::setFont(font);
        applyTheme(*qApp, lightTheme(size));
        for (const QSize page : {QSize(816, 526), QSize(976, 626), QSize(1048, 580)}) {
            TrialBench bench(lightTheme(size), page);
            bench.workbench.publish();
            QCoreApplication::processEvents();
            bench.page->resize(page);           // live, its strips need more at twice the font
            QCOMPARE(bench.page->size(), page); // it asks for no more
            const QSize plot = bench.page->trials().plot().size();
            const double share = 1.0 * plot.width() * plot.height() / (page.width() * page.height());
            qInfo("%.0f pt, page %d x %d: plot %d x %d, %.0f %%", size, page.width(), page.height(), plot.width(),
                plot.height(), share * 100.0);
            QVERIFY(bench.page->trials().plot().isVisible());
            QVERIFY(size < 15.0 || share >= 1.0 / 3.0);
        }
    }
    QApplication::setFont(before);
    applyTheme(*qApp, lightTheme());
}

void TestExperiments::withoutRoomOnePartIsShownAtATime()
{
    TrialBench bench(lightTheme(), QSize(500, 320));
    bench.workbench.publish();
    TuneFrame &frame = bench.page->frame();
    QVERIFY(frame.isCompact());
    const auto seen = [&] {
        const TrialsView &trials = bench.page->trials();
        return std::array{bench.page->stimulus().isVisible(), bench.page->column().gainsPanel().isVisible(),
            bench.page->trials().plot().isVisible(), bench.page->trials().metrics().isVisible(),
            bench.page->trials().list().isVisible(), trials.isVisible()};
    };
    QVERIFY((seen() == std::array{false, false, true, false, false, true}));
    frame.show(TuneFrame::Part::Setup);
    QVERIFY((seen() == std::array{true, true, false, false, false, false}));
    frame.show(TuneFrame::Part::Metrics);
    QVERIFY((seen() == std::array{false, false, false, true, false, true}));
    frame.show(TuneFrame::Part::Trials);
    QVERIFY((seen() == std::array{false, false, false, false, true, true}));
    frame.show(TuneFrame::Part::Live);
    QVERIFY(bench.page->isLive());
    frame.show(TuneFrame::Part::Response);
    QVERIFY(!bench.page->isLive());
    bench.page->resize(1208, 760);
    QVERIFY(!frame.isCompact());
    QVERIFY((seen() == std::array{true, true, true, true, true, true}));
}

MB_WINDOW_TEST(TestExperiments);
#include "tst_experiments.moc"
