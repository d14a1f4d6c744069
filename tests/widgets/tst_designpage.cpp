// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/windowtests.h"
#include "tunebench.h"
#include "widgets/common/iconbutton.h"
#include "widgets/control/logslider.h"
#include "widgets/design/bodeplot.h"
#include "widgets/design/designpage.h"
#include "widgets/design/ownproposal.h"
#include "widgets/design/proposalcard.h"
#include "widgets/design/sweeppanel.h"
#include "widgets/plots/curveplot.h"

#include <QLabel>
#include <QTest>

using namespace mb;
using namespace mb::test;
using namespace mb::tuning;

namespace {

/// A report as an identification of the simulated drive gives it.
TuneReport identified()
{
    TuneReport report;
    report.result = TuneResult::Proposed;
    report.simulated = true;
    report.motor = MotorFound{};
    report.motor->line.gain = 350000.0;
    report.motor->pushes.tau = 0.12;
    report.motor->line.gainError = 9000.0;
    report.motor->pushes.tauError = 0.004;
    report.motor->pushes.delayError = 0.002;
    report.plant = {350000.0, 0.12, 0.03, 0.02};
    report.gates = {{"fit", say("the fit leaves 1.1 of what whole counts explain"), true}};
    for (const Aim aim : {Aim::Calm, Aim::Normal, Aim::Brisk}) {
        Proposal proposal;
        proposal.aim = aim;
        proposal.design = design(Mode::Velocity, report.plant, responseOf(Mode::Velocity, aim, report.plant), {});
        proposal.gains.made = proposal.design.gains;
        proposal.gains.rows = {{"slot0.p", 40000, 0.6}, {"slot0.i", 113, 0.0017}};
        proposal.gains.changes = {{named("slot0.p"), 40000 + static_cast<int>(aim)}};
        proposal.margins = marginsOf(Mode::Velocity, report.plant, proposal.gains.made);
        proposal.step = 60000.0;
        proposal.predicted = predictStep(Mode::Velocity, report.plant, proposal.gains.made, 0.0, 60000.0, 2.0);
        report.proposals.push_back(proposal);
    }
    return report;
}

struct DesignBench {
    FakeWorkbench workbench;
    Selection selection;
    ThemeSource theme{darkTheme()};
    Arming arming{workbench};
    Recording recording{workbench.time};
    std::unique_ptr<DesignPage> page;

    explicit DesignBench(double points = 10.0)
        : theme(darkTheme(points))
    {
        workbench.shot.devices.push_back(tunableDrive(recording.telemetry()));
        LinkView link;
        link.address = link.name = "sim:can";
        link.simulated = true;
        workbench.shot.links.push_back(link);
        selection.select({1});
        page = std::make_unique<DesignPage>(workbench, selection, arming, theme, nullptr);
        page->resize(1208, 760);
        page->show();
        QApplication::setActiveWindow(page.get());
    }
    void arm() { arming.arm({1}); }
    void finish(const Result<TuneReport> &report)
    {
        const auto finished = workbench.given<orders::RunTuning>().back().finished;
        finished(report);
    }
    [[nodiscard]] OwnProposal *own() { return page->findChild<OwnProposal *>(); }
    [[nodiscard]] QList<ProposalCard *> cards() { return page->findChildren<ProposalCard *>(); }
};

} // namespace

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
    void whatIsStoppedBeforeItHasAModelLeavesTheOneThatIsKnown();
    void cardsAreChosenByKeysAndShowTheirOwnLoop();
    void theKeysOrder();
    void anErrorLeavesThePageAsItWasAndArmed();
    void aGuardIsAStop();
    void aUnitInItsBootloaderIsNotTried();
    void theColumnScrollsBeforeItIsSqueezed();
    void wordsBelowACurveContinueOnTheNextLine();
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
    QVERIFY2(bench.own()->boundText().contains(boundWord("margin")), qPrintable(bench.own()->boundText()));
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

void TestDesignPage::whatIsStoppedBeforeItHasAModelLeavesTheOneThatIsKnown()
{
    DesignBench bench;
    bench.arm();
    bench.page->identify();
    bench.finish(identified());
    bench.page->autotune();
    TuneReport stopped;
    stopped.result = TuneResult::Stopped;
    stopped.stopReason = "interrupted";
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
    stopped.stopReason = "travel";
    stopped.evidence = say("20 001 counts from the start, 20 000 are allowed");
    bench.finish(stopped);
    QVERIFY(bench.arming.state() == LampState::Stopped);
    QVERIFY(!bench.page->status().mayRun);
}

void TestDesignPage::aUnitInItsBootloaderIsNotTried()
{
    DesignBench bench;
    bench.arm();
    bench.workbench.shot.devices[0].identity.state = DeviceState::Bootloader;
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
            QVERIFY2(label->height() >= label->minimumSizeHint().height(), qPrintable(label->text()));
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
