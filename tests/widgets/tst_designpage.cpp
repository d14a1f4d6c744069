// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/windowtests.h"
#include "tunebench.h"
#include "widgets/common/iconbutton.h"
#include "widgets/design/bodeplot.h"
#include "widgets/design/designpage.h"
#include "widgets/design/proposalcard.h"
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
    report.plant = {350000.0, 0.12, 0.03, 0.02};
    report.gates = {{"fit", "the fit leaves 1.1 of what whole counts explain", true}};
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
        const auto finished = workbench.tunings.back().finished;
        finished(report);
    }
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
    void whatIsStoppedBeforeItHasAModelLeavesTheOneThatIsKnown();
    void cardsAreChosenByKeysAndShowTheirOwnLoop();
    void theKeysOrder();
    void anErrorLeavesThePageAsItWasAndArmed();
    void aGuardIsAStop();
    void aUnitInItsBootloaderIsNotTried();
    void theColumnScrollsBeforeItIsSqueezed();
    void everyControlHasAName();
};

void TestDesignPage::nothingIsOrderedBeforeItIsArmed()
{
    DesignBench bench;
    bench.page->identify();
    bench.page->autotune();
    bench.page->prove();
    QVERIFY(bench.workbench.tunings.empty());
    QVERIFY(!bench.page->status().mayRun);
}

void TestDesignPage::identifyingProposesAndWritesNothing()
{
    DesignBench bench;
    bench.arm();
    bench.page->prove();
    QVERIFY2(bench.workbench.tunings.empty(), "there is nothing to prove yet");
    bench.page->identify();
    QCOMPARE(bench.workbench.tunings.size(), std::size_t(1));
    QVERIFY(bench.workbench.tunings[0].plan.propose);
    QVERIFY(bench.arming.isOnTrial());
    bench.page->identify();
    QCOMPARE(bench.workbench.tunings.size(), std::size_t(1));
    bench.finish(identified());
    QVERIFY(bench.page->report());
    QCOMPARE(bench.cards().size(), 3);
    QVERIFY(bench.arming.isArmed({1}));
    QVERIFY(bench.workbench.callsOf("writeParameters").empty());
}

void TestDesignPage::theChosenSetIsProvenFromTheModelThatIsKnown()
{
    DesignBench bench;
    bench.arm();
    bench.page->identify();
    bench.finish(identified());
    bench.page->chooseAim(Aim::Brisk);
    bench.page->prove();
    QCOMPARE(bench.workbench.tunings.size(), std::size_t(2));
    const TunePlan &plan = bench.workbench.tunings[1].plan;
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
    QVERIFY(bench.workbench.tunings[0].plan.loop == Mode::Current);
    TuneReport report = identified();
    report.loop = Mode::Current;
    report.motor->unit = "A per duty";
    report.motor->line.gain = 126.0;
    report.scale = TriedScale{1e-3, 1e-5, 1e-3, 9000.0, 0.02};
    bench.finish(report);
    bench.page->prove();
    QVERIFY(bench.workbench.tunings[1].plan.scale == report.scale);
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
    proof.evidence = "it overshot by 12 %, predicted were 0 %";
    bench.finish(proof);
    QVERIFY(bench.page->report()->result == TuneResult::RolledBack);
    QVERIFY(bench.page->report()->motor);
    QCOMPARE(bench.cards().size(), 3);
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
    QCOMPARE(bench.workbench.tunings.size(), std::size_t(3));
    QVERIFY(bench.workbench.tunings[2].plan.known == std::optional(identified().plant));
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
    QVERIFY2(bench.workbench.tunings.empty(), "a letter never turns a shaft");
    QTest::keyClick(bench.page.get(), Qt::Key_F6, Qt::ShiftModifier);
    QCOMPARE(bench.workbench.tunings.size(), std::size_t(1));
    bench.finish(identified());
    QTest::keyClick(bench.page.get(), Qt::Key_F5);
    QCOMPARE(bench.workbench.tunings.size(), std::size_t(2));
    bench.finish(identified());
    QTest::keyClick(bench.page.get(), Qt::Key_F6);
    QCOMPARE(bench.workbench.tunings.size(), std::size_t(3));
    QVERIFY(!bench.workbench.tunings[2].plan.known);
}

void TestDesignPage::anErrorLeavesThePageAsItWasAndArmed()
{
    DesignBench bench;
    bench.arm();
    bench.page->identify();
    bench.finish(fail(Fault::OutOfRange, "there is not enough room", "allow more travel"));
    QVERIFY(!bench.page->report());
    QVERIFY(bench.arming.isArmed({1}));
    QVERIFY(bench.workbench.callsOf("report").back().text.find("not enough room") != std::string::npos);
}

void TestDesignPage::aGuardIsAStop()
{
    DesignBench bench;
    bench.arm();
    bench.page->identify();
    TuneReport stopped;
    stopped.result = TuneResult::Stopped;
    stopped.stopReason = "travel";
    stopped.evidence = "20 001 counts from the start, 20 000 are allowed";
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
    QVERIFY(bench.workbench.tunings.empty());
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
