// SPDX-License-Identifier: GPL-3.0-or-later
#include "designbench.h"
#include "support/windowtests.h"
#include "widgets/common/iconbutton.h"
#include "widgets/control/logslider.h"
#include "widgets/design/adviserlist.h"
#include "widgets/design/bodemarks.h"
#include "widgets/design/bodeplot.h"
#include "widgets/design/designpage.h"
#include "widgets/design/ownproposal.h"
#include "widgets/design/proposalcard.h"
#include "widgets/design/sweeppanel.h"
#include "widgets/parameters/editdesk.h"
#include "widgets/plots/curveplot.h"

#include <QLabel>
#include <QPushButton>
#include <QTest>

using namespace mb;
using namespace mb::test;
using namespace mb::tuning;

class TestDesignPage : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void nothingIsOrderedBeforeItIsArmed();
    void identifyingProposesAndWritesNothing();
    void theChosenSetIsProvenFromTheModelThatIsKnown();
    void aCurrentLoopIsDesignedInAmpereAndATriedScaleGoesWithItsModel();
    void aProofKeepsTheModelItStandsOn();
    void theSlidersDesignWithoutTheDeviceAndF5ProvesExactlyThat();
    void whatHoldsTheSlidersBackIsSaid();
    void anotherSlotHasTheSameProposalsUnderItsOwnKeys();
    void thePredictedStepHasTheBandOfTheErrors();
    void aFrequencyResponseIsAnnouncedMeasuredAndDrawnAsFarAsItIsTrusted();
    void aFrequencyResponseIsOfTheMotorThatWasMeasuredAndOfNoneThatWasStopped();
    void whatIsStoppedBeforeItHasAModelLeavesTheOneThatIsKnown();
    void cardsAreChosenByKeysAndShowTheirOwnLoop();
    void theKeysOrder();
    void anErrorLeavesThePageAsItWasAndArmed();
    void aGuardIsAStop();
    void aUnitInItsBootloaderIsNotTried();
    void theColumnScrollsBeforeItIsSqueezed();
    void wordsBelowACurveContinueOnTheNextLine();
    void advisersSayWhatIsToBeKnownOfTheSetAndStageWhatHelps();
    void whatWillHappenIsSaidBeforeAndWhatCameOfItAfter();
    void marginsStandAtTheirPlacesAndAreNotToldBeyondWhatWasMeasured();
    void everyControlHasAName();
};

void TestDesignPage::nothingIsOrderedBeforeItIsArmed()
{
    DesignBench bench;
    bench.page->identify();
    bench.page->autotune();
    bench.page->prove();
    QVERIFY(bench.workbench.given<orders::RunTuning>().empty());
    QVERIFY(!bench.page->status().mayRun);
}

void TestDesignPage::identifyingProposesAndWritesNothing()
{
    DesignBench bench;
    bench.arm();
    bench.page->prove();
    QVERIFY2(bench.workbench.given<orders::RunTuning>().empty(), "there is nothing to prove yet");
    bench.page->identify();
    QCOMPARE(bench.workbench.given<orders::RunTuning>().size(), std::size_t(1));
    QVERIFY(bench.workbench.given<orders::RunTuning>()[0].plan.propose);
    QVERIFY(bench.arming.isOnTrial());
    bench.page->identify();
    QCOMPARE(bench.workbench.given<orders::RunTuning>().size(), std::size_t(1));
    bench.finish(identified());
    QVERIFY(bench.page->report());
    QCOMPARE(bench.cards().size(), 3);
    QVERIFY(bench.arming.isArmed({1}));
    QVERIFY(bench.workbench.given<orders::WriteParameters>().empty());
}

void TestDesignPage::theChosenSetIsProvenFromTheModelThatIsKnown()
{
    DesignBench bench;
    bench.arm();
    bench.page->identify();
    bench.finish(identified());
    bench.page->chooseAim(Aim::Brisk);
    bench.page->prove();
    QCOMPARE(bench.workbench.given<orders::RunTuning>().size(), std::size_t(2));
    const TunePlan plan = bench.workbench.given<orders::RunTuning>()[1].plan;
    QVERIFY(plan.known == std::optional(identified().plant));
    QVERIFY(plan.aim == Aim::Brisk);
    QVERIFY(!plan.propose);
}

void TestDesignPage::aCurrentLoopIsDesignedInAmpereAndATriedScaleGoesWithItsModel()
{
    DesignBench bench;
    bench.arm();
    bench.page->chooseLoop(Mode::Current);
    bench.page->identify();
    QVERIFY(bench.workbench.given<orders::RunTuning>()[0].plan.loop == Mode::Current);
    TuneReport report = identified();
    report.loop = Mode::Current;
    report.motor->unit = "A per duty";
    report.motor->line.gain = 126.0;
    report.scale = TriedScale{1e-3, 1e-5, 1e-3, 9000.0, 0.02};
    bench.finish(report);
    bench.page->prove();
    QVERIFY(bench.workbench.given<orders::RunTuning>()[1].plan.scale == report.scale);
    bool told = false;
    for (const QLabel *label : bench.page->findChildren<QLabel *>())
        told = told || label->text() == QStringLiteral("A per duty");
    QVERIFY(told);
}

void TestDesignPage::aProofKeepsTheModelItStandsOn()
{
    DesignBench bench;
    bench.arm();
    bench.page->identify();
    bench.finish(identified());
    bench.page->prove();
    TuneReport proof;
    proof.result = TuneResult::RolledBack;
    proof.plant = identified().plant;
    proof.evidence = say("it overshot by 12 %, predicted were 0 %");
    bench.finish(proof);
    QVERIFY(bench.page->report()->result == TuneResult::RolledBack);
    QVERIFY(bench.page->report()->motor);
    QCOMPARE(bench.cards().size(), 3);
}

void TestDesignPage::theSlidersDesignWithoutTheDeviceAndF5ProvesExactlyThat()
{
    DesignBench bench;
    bench.arm();
    bench.page->identify();
    QVERIFY(bench.own() && !bench.own()->isVisible());
    bench.finish(identified());
    QVERIFY(bench.own()->isVisible());
    const double normal = bench.page->chosen()->gains.made.p;
    auto *const speed = bench.own()->findChild<LogSlider *>();
    QVERIFY(speed);
    speed->setFocus();
    for (int i = 0; i < 20; ++i)
        QTest::keyClick(speed, Qt::Key_Right);
    QVERIFY(bench.page->chosen()->gains.made.p > normal);
    QCOMPARE(bench.workbench.given<orders::RunTuning>().size(), std::size_t(1));
    const auto *const bode = bench.page->findChild<BodePlot *>();
    QVERIFY2(bode && bode->findChildren<CurvePlot *>().front()->note() == marginText(bench.page->chosen()->margins),
        "the plots follow");
    bench.page->prove();
    QCOMPARE(bench.workbench.given<orders::RunTuning>().size(), std::size_t(2));
    const TunePlan plan = bench.workbench.given<orders::RunTuning>().back().plan;
    QCOMPARE(plan.response.value_or(0.0), bench.own()->response());
    QCOMPARE(plan.ms.value_or(0.0), bench.own()->ms());
    QVERIFY(plan.known.has_value());
    bench.finish(identified());
    bench.page->chooseAim(Aim::Calm);
    bench.page->prove();
    QVERIFY2(!bench.workbench.given<orders::RunTuning>().back().plan.response, "a card is an aim again");
}

void TestDesignPage::whatHoldsTheSlidersBackIsSaid()
{
    DesignBench bench;
    bench.arm();
    bench.page->identify();
    bench.finish(identified());
    bench.page->chooseOwn(0.3, 1.6);
    QVERIFY2(bench.own()->boundText().isEmpty(), qPrintable(bench.own()->boundText()));
    bench.page->chooseOwn(0.005, 1.3);
    QVERIFY2(bench.own()->boundText().contains(QStringLiteral("margin")), qPrintable(bench.own()->boundText()));
    DesignBench quick;
    quick.arm();
    quick.page->identify();
    auto prompt = identified();
    prompt.plant = {350'000.0, 0.39, 0.0055, 0.02};
    quick.finish(prompt);
    quick.page->chooseOwn(0.005, 2.0);
    QVERIFY2(quick.own()->boundText().contains(QStringLiteral("largest error")), qPrintable(quick.own()->boundText()));
}

void TestDesignPage::anotherSlotHasTheSameProposalsUnderItsOwnKeys()
{
    DesignBench other;
    other.arm();
    other.page->chooseSlot(1);
    other.page->identify();
    auto ofSlotOne = identified();
    ofSlotOne.slot = 1;
    other.finish(ofSlotOne);
    other.page->chooseSlot(0);
    const auto first = other.page->chosen()->design.gains;
    QCOMPARE(other.page->chosen()->gains.rows.front().key.rfind("slot0.", 0), std::size_t{0});
    DesignBench bench;
    bench.arm();
    bench.page->identify();
    bench.finish(identified());
    bench.page->chooseSlot(1);
    QCOMPARE(bench.cards().size(), 3);
    QVERIFY(bench.page->chosen()->gains.rows.front().key.rfind("slot1.", 0) == 0);
    QVERIFY(bench.page->chosen()->design.gains == first);
    bench.page->prove();
    QCOMPARE(bench.workbench.given<orders::RunTuning>().back().plan.slot, 1);
}

void TestDesignPage::thePredictedStepHasTheBandOfTheErrors()
{
    DesignBench bench;
    bench.arm();
    bench.page->identify();
    bench.finish(identified());
    const auto plots = bench.page->findChildren<CurvePlot *>();
    const auto banded = std::find_if(plots.begin(), plots.end(),
        [](const CurvePlot *plot) { return !plot->curves().empty() && !plot->curves().front().low.isEmpty(); });
    QVERIFY(banded != plots.end());
    const Curve &predicted = (*banded)->curves().front();
    QCOMPARE(predicted.low.size(), predicted.x.size());
    double widest = 0.0;
    for (int i = 0; i < predicted.x.size(); ++i)
        widest = std::max(widest, predicted.high[i] - predicted.low[i]);
    QVERIFY(widest > 0.0);
}

void TestDesignPage::aFrequencyResponseIsAnnouncedMeasuredAndDrawnAsFarAsItIsTrusted()
{
    DesignBench bench;
    auto *const sweep = bench.page->findChild<SweepPanel *>();
    QVERIFY(sweep && !sweep->isVisible());
    bench.arm();
    bench.page->identify();
    bench.finish(identified());
    QVERIFY(sweep->isVisible());
    QVERIFY2(sweep->announcement().contains(QStringLiteral("counts/s")), qPrintable(sweep->announcement()));
    sweep->measure();
    QCOMPARE(bench.workbench.given<orders::RunSweep>().size(), std::size_t(1));
    QVERIFY(bench.arming.isOnTrial());
    sweep->measure();
    QCOMPARE(bench.workbench.given<orders::RunSweep>().size(), std::size_t(1));
    FrequencyResponse response;
    response.points = {{0.3, 340000.0, -10.0, 0.99, true}, {1.0, 280000.0, -37.0, 0.99, true},
        {3.0, 90000.0, -70.0, 0.5, false}, {5.0, 90000.0, -80.0, 0.95, true}};
    const auto finished = bench.workbench.given<orders::RunSweep>().back().finished;
    finished(response);
    const auto &curves = bench.page->findChild<BodePlot *>()->magnitude().curves();
    QCOMPARE(curves.size(), std::size_t(3));
    QVERIFY(curves.back().points);
    QCOMPARE(curves.back().x.size(), 2); // nothing beyond the first that is not to be trusted
    QVERIFY(!bench.arming.isOnTrial());
}

void TestDesignPage::aFrequencyResponseIsOfTheMotorThatWasMeasuredAndOfNoneThatWasStopped()
{
    DesignBench bench;
    bench.workbench.shot.devices.push_back(tunableDrive(bench.recording.telemetry(), 2, 7));
    auto *const sweep = bench.page->findChild<SweepPanel *>();
    const auto curves = [&bench] { return bench.page->findChild<BodePlot *>()->magnitude().curves().size(); };
    for (const std::uint32_t id : {2U, 1U}) {
        bench.selection.select({id});
        bench.arming.arm({id});
        bench.page->identify();
        bench.finish(identified());
    }
    const auto without = curves();
    FrequencyResponse response;
    response.points = {{0.3, 340000.0, -10.0, 0.99, true}, {1.0, 280000.0, -37.0, 0.99, true}};
    response.stopReason = EndReason::Travel;
    sweep->measure();
    const auto stopped = bench.workbench.given<orders::RunSweep>().back().finished;
    stopped(response);
    QCOMPARE(curves(), without);
    bench.arm();
    sweep->measure();
    QCOMPARE(bench.workbench.given<orders::RunSweep>().size(), std::size_t(2));
    bench.selection.select({2});
    response.stopReason = EndReason::None;
    const auto finished = bench.workbench.given<orders::RunSweep>().back().finished;
    finished(response);
    bench.workbench.publish();
    QCOMPARE(curves(), without);
    bench.selection.select({1});
    bench.workbench.publish();
    QCOMPARE(curves(), without + 1);
}

void TestDesignPage::whatIsStoppedBeforeItHasAModelLeavesTheOneThatIsKnown()
{
    DesignBench bench;
    bench.arm();
    bench.page->identify();
    bench.finish(identified());
    bench.page->autotune();
    TuneReport stopped;
    stopped.result = TuneResult::Stopped;
    stopped.stopReason = EndReason::Interrupted;
    bench.finish(stopped);
    bench.page->prove();
    QCOMPARE(bench.workbench.given<orders::RunTuning>().size(), std::size_t(3));
    QVERIFY(bench.workbench.given<orders::RunTuning>()[2].plan.known == std::optional(identified().plant));
}

void TestDesignPage::cardsAreChosenByKeysAndShowTheirOwnLoop()
{
    DesignBench bench;
    bench.arm();
    bench.page->identify();
    bench.finish(identified());
    auto *bode = bench.page->findChild<BodePlot *>();
    const QString normal = bode->magnitude().note();
    QVERIFY2(normal.contains(QStringLiteral("Ms 1.")), qPrintable(normal));
    QCOMPARE(bode->magnitude().curves().size(), std::size_t(2));
    ProposalCard *const calm = bench.cards().front();
    calm->setFocus();
    QTest::keyClick(calm, Qt::Key_Return);
    QVERIFY(bode->magnitude().note() != normal);
}

void TestDesignPage::theKeysOrder()
{
    DesignBench bench;
    bench.arm();
    QTest::keyClick(bench.page.get(), Qt::Key_I);
    QVERIFY2(bench.workbench.given<orders::RunTuning>().empty(), "a letter never turns a shaft");
    QTest::keyClick(bench.page.get(), Qt::Key_F6, Qt::ShiftModifier);
    QCOMPARE(bench.workbench.given<orders::RunTuning>().size(), std::size_t(1));
    bench.finish(identified());
    QTest::keyClick(bench.page.get(), Qt::Key_F5);
    QCOMPARE(bench.workbench.given<orders::RunTuning>().size(), std::size_t(2));
    bench.finish(identified());
    QTest::keyClick(bench.page.get(), Qt::Key_F6);
    QCOMPARE(bench.workbench.given<orders::RunTuning>().size(), std::size_t(3));
    QVERIFY(!bench.workbench.given<orders::RunTuning>()[2].plan.known);
}

void TestDesignPage::anErrorLeavesThePageAsItWasAndArmed()
{
    DesignBench bench;
    bench.arm();
    bench.page->identify();
    bench.finish(fail(Fault::OutOfRange, say("there is not enough room"), say("allow more travel")));
    QVERIFY(!bench.page->report());
    QVERIFY(bench.arming.isArmed({1}));
    QVERIFY(bench.workbench.lines.back().text.contains(QLatin1String("not enough room")));
}

void TestDesignPage::aGuardIsAStop()
{
    DesignBench bench;
    bench.arm();
    bench.page->identify();
    TuneReport stopped;
    stopped.result = TuneResult::Stopped;
    stopped.stopReason = EndReason::Travel;
    stopped.evidence = say("20 001 counts from the start, 20 000 are allowed");
    bench.finish(stopped);
    QVERIFY(bench.arming.state() == LampState::Stopped);
    QVERIFY(!bench.page->status().mayRun);
}

void TestDesignPage::aUnitInItsBootloaderIsNotTried()
{
    DesignBench bench;
    bench.arm();
    bench.workbench.shot.devices[0].identity.edit().state = DeviceState::Bootloader;
    Q_EMIT bench.workbench.changed();
    bench.page->identify();
    QVERIFY(bench.workbench.given<orders::RunTuning>().empty());
}

void TestDesignPage::theColumnScrollsBeforeItIsSqueezed()
{
    DesignBench bench;
    bench.page->resize(1048, 480);
    bench.arm();
    bench.page->identify();
    bench.finish(identified());
    QCoreApplication::processEvents();
    for (const ProposalCard *card : bench.cards()) {
        for (const QLabel *label : card->findChildren<QLabel *>())
            QVERIFY2(
                !label->isVisible() || label->height() >= label->minimumSizeHint().height(), qPrintable(label->text()));
    }
}

void TestDesignPage::wordsBelowACurveContinueOnTheNextLine()
{
    const ThemeSource theme(darkTheme(10));
    CurvePlot plot(theme, QStringLiteral("Step"));
    plot.resize(900, 300);
    plot.show();
    const QString note = QStringLiteral("a step of 386 510 counts/s · measured: 3.2 % over, settled after 509 ms");
    plot.setNote(note);
    const auto *const words = qobject_cast<QCPTextElement *>(plot.plot().plotLayout()->element(1, 0));
    QVERIFY(words);
    QCOMPARE(words->text(), note);
    plot.resize(320, 300);
    QCoreApplication::processEvents();
    const QStringList lines = words->text().split(QLatin1Char('\n'));
    QCOMPARE(lines.join(QStringLiteral(" · ")), note); // nothing is lost
    QCOMPARE(lines.size(), 2);
    for (const QString &line : lines)
        QVERIFY2(QFontMetrics(words->font()).horizontalAdvance(line) <= plot.width(), qPrintable(line));
    QCOMPARE(plot.note(), note);
    plot.setNote(
        QStringLiteral("What the gains will do appears here, before they are written, in a sentence of its own."));
    for (const QString &line : words->text().split(QLatin1Char('\n')))
        QVERIFY2(QFontMetrics(words->font()).horizontalAdvance(line) <= plot.width(), qPrintable(line));
}

void TestDesignPage::advisersSayWhatIsToBeKnownOfTheSetAndStageWhatHelps()
{
    DesignBench bench;
    DeviceView &device = bench.workbench.shot.devices[0];
    device.parameters.edit()[named("slot0.ramp").value].raw = 20; // 0.8 s to full duty
    auto *const advisers = bench.page->findChild<AdviserList *>();
    QVERIFY(advisers && !advisers->isVisible());
    bench.arm();
    bench.page->identify();
    bench.finish(identified());
    QVERIFY(advisers->isVisible());
    const auto says = [&](const QString &words) {
        const auto labels = advisers->findChildren<QLabel *>();
        return std::any_of(
            labels.begin(), labels.end(), [&](const QLabel *label) { return label->text().contains(words); });
    };
    for (const Cause cause :
        {Cause::FeedForward, Cause::Deadband, Cause::DerivativeNoise, Cause::Resolution, Cause::Ramp})
        QVERIFY2(says(placeText(cause)), qPrintable(placeText(cause)));
    QCOMPARE(advisers->findChildren<QPushButton *>().size(), 1);
    QVERIFY2(!says(QStringLiteral("least output helps")), "a velocity would never come to rest with one");
    advisers->findChildren<QPushButton *>().back()->click();
    const StagedEdits &edits = EditDesk::of(bench.workbench).editsOf(device);
    QCOMPARE(edits.count(), 1);
    QVERIFY2(bench.workbench.given<orders::WriteParameters>().empty(), "staged is not written");
    advisers->findChildren<QPushButton *>().back()->click();
    QCOMPARE(edits.count(), 0);
}

void TestDesignPage::whatWillHappenIsSaidBeforeAndWhatCameOfItAfter()
{
    DesignBench bench;
    bench.arm();
    bench.page->identify();
    bench.finish(identified());
    const auto said = [&] { return courseOf(bench); };
    QVERIFY2(said().contains(QStringLiteral("Write P, I to slot 1|")), qPrintable(said()));
    QVERIFY2(said().contains(QStringLiteral("Run 4 steps of 60")), qPrintable(said()));
    QVERIFY2(!said().contains(QStringLiteral("measured:")), qPrintable(said()));
    TuneReport proof = identified();
    proof.result = TuneResult::Kept;
    proof.proposed = proof.proposals[1].gains;
    proof.proof.resize(1);
    proof.measured.overshoot = 0.021;
    bench.finish(proof);
    QVERIFY2(said().contains(QStringLiteral("measured: over 2.1\u00A0%")), qPrintable(said()));
}

void TestDesignPage::marginsStandAtTheirPlacesAndAreNotToldBeyondWhatWasMeasured()
{
    const Margins margins{1.44, 4.0, 67.0, 4.0, 15.0};
    const auto words = [](const std::vector<CurveMark> &marks) {
        QStringList all;
        for (const CurveMark &mark : marks)
            all << mark.text;
        return all.join(QLatin1Char('|'));
    };
    const BodeMarks free = bodeMarks(margins, 0.0);
    QVERIFY2(
        words(free.magnitude).contains(QStringLiteral("GM 12.0 dB at 2.39 Hz")), qPrintable(words(free.magnitude)));
    QVERIFY2(words(free.phase).contains(QStringLiteral("PM 67° at 0.637 Hz")), qPrintable(words(free.phase)));
    const BodeMarks bounded = bodeMarks(margins, 2.0);
    QVERIFY2(words(bounded.magnitude).contains(QStringLiteral("GM –")), "of what was not measured nothing is told");
    QVERIFY(words(bounded.magnitude).contains(QStringLiteral("usable up to 2.0 Hz")));
}

void TestDesignPage::everyControlHasAName()
{
    DesignBench bench;
    bench.arm();
    bench.page->identify();
    bench.finish(identified());
    for (const QWidget *widget : bench.page->findChildren<QWidget *>()) {
        if (widget->focusPolicy() == Qt::NoFocus || !widget->isVisible())
            continue;
        const auto *button = qobject_cast<const QAbstractButton *>(widget);
        QVERIFY2(!widget->accessibleName().isEmpty() || (button && !button->text().isEmpty()),
            widget->metaObject()->className());
    }
}

MB_WINDOW_TEST(TestDesignPage);
#include "tst_designpage.moc"
