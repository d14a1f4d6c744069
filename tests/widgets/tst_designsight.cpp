// SPDX-License-Identifier: GPL-3.0-or-later
// What the Design page says and shows without being asked: the model in full, bounds before a motor turns, and all that is chosen from in sight.
#include "designbench.h"
#include "experiment/announcement.h"
#include "report/modelfigures.h"
#include "support/windowtests.h"
#include "widgets/common/devicetext.h"
#include "widgets/common/numberformat.h"
#include "widgets/design/adviserlist.h"
#include "widgets/design/designcolumn.h"
#include "widgets/design/designorders.h"
#include "widgets/design/modelpanel.h"
#include "widgets/design/proposallist.h"
#include "widgets/design/tuningsteps.h"

#include <QLabel>
#include <QPushButton>
#include <QScrollBar>

using namespace mb;
using namespace mb::test;
using namespace mb::tuning;

class TestDesignSight : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase();
    void theModelIsToldInTheWordsOfTheReport();
    void whatIsNotKnownOfAModelHasNoLine();
    void theArmedPageSaysDutySpeedAndTravelBeforeAnythingIsOrdered();
    void ofABoardTheAxisThatWasSelectedLastIsTunedAndNamed();
    void theNextPageKnowsTheModelAndWhatWasChosen();
    void eachStimulusIsSaidWhileItRuns();
    void theSetsAndTheSlidersAreInSightInTheSmallestWindow();
    void theChosenSetAndTheOrderThatProvesItAreInSightAtLargeText();
    void theNumberedStepsAreInSightInTheSmallestWindowAndOnlyWhyItWasKeptScrolls();
    void whyATuningFailedStandsAboveTheSteps();
    void gainsOfSetsThatAreNotChosenGiveWayToTheSlidersInALowWindow();
    void aModelThatIsNotBelievedIsNeverFolded();
    void whatIsInOrderTakesOneLineWhereThereIsLittleRoom();
    void whatIsHiddenBecauseItsModelIsNotBelievedIsNotProven();
};

namespace {

TuneReport inFull()
{
    TuneReport report = identified();
    report.motor->line.offset = 0.0123;
    report.motor->line.offsetError = 0.0045;
    report.motor->line.forward = 352'000.0;
    report.motor->line.reverse = 348'000.0;
    report.motor->restNoise = 0.37;
    report.motor->latency = 0.0137;
    report.profile = ProfileLimits{82'000.0, 491'000.0};
    return report;
}

QString wordsIn(const QWidget &widget)
{
    QStringList words;
    for (const QLabel *label : widget.findChildren<QLabel *>()) {
        if (label->isVisible())
            words << label->text();
    }
    return words.join(QLatin1Char('|'));
}

/// As the page is in a window of 1280×800 with the stripe of a simulated bench.
void makeSmall(DesignBench &bench)
{
    bench.page->resize(1047, 607);
    QCoreApplication::processEvents();
}

/// With a reason of some lines.
TuneReport ended(TuneResult result)
{
    TuneReport report = inFull();
    report.result = result;
    report.evidence = say(
        "the steps in both directions did what was predicted; the gains were written and read back; those that were "
        "proven first left more error, these leave 97.9 % of it; the unit stores them by itself within 15 s");
    report.proposed = report.proposals[1].gains;
    return report;
}

QLabel *labelWith(const QWidget &parent, const QString &text)
{
    for (QLabel *label : parent.findChildren<QLabel *>()) {
        if (label->isVisible() && label->text().contains(text))
            return label;
    }
    return nullptr;
}

/// What is rebuilt finds its room once it is shown.
void settleDown()
{
    for (int i = 0; i < 4; ++i)
        QCoreApplication::processEvents();
}

/// A tuning in the smallest window that came to this.
void endSmall(DesignBench &bench, TuneResult result)
{
    makeSmall(bench);
    bench.arm();
    bench.page->identify();
    bench.finish(ended(result));
    settleDown();
}

bool isSeenWhole(const QWidget *part)
{
    return part && part->visibleRegion().boundingRect() == part->rect();
}

/// Of the first gain, as a card has it in one line.
QString shortest(const Proposal &proposal)
{
    return formatSignificant(proposal.gains.rows.front().number, 4);
}

bool isInSight(const QWidget &part, const DesignColumn &column)
{
    const QRect place(part.mapTo(column.viewport(), QPoint()), part.size());
    return column.viewport()->rect().contains(place);
}

} // namespace

void TestDesignSight::initTestCase()
{
    dressAsTheProgram();
}

void TestDesignSight::theModelIsToldInTheWordsOfTheReport()
{
    DesignBench bench;
    bench.page->resize(1208, 1400);
    bench.arm();
    bench.page->identify();
    bench.finish(inFull());
    QCoreApplication::processEvents();
    const auto *const panel = bench.page->findChild<ModelPanel *>();
    const QString said = wordsIn(*panel);
    const auto figures = modelFigures(inFull(), [](const Message &message) { return messageText(message); });
    QCOMPARE(figures.size(), std::size_t(9));
    for (const ModelFigure &figure : figures)
        QVERIFY2(said.contains(figure.name + QLatin1Char('|')), qPrintable(figure.name));
    for (const char *word : {"1.23|± 0.45|", "352 000", "348 000", "0.37|counts", "13.7|ms", "491 000 counts/s²"}) {
        const QString plain
            = QString(said).replace(ThinSpace, QLatin1Char(' ')).replace(QChar(0x00A0), QLatin1Char(' '));
        QVERIFY2(plain.contains(QString::fromUtf8(word)), qPrintable(plain));
    }
}

void TestDesignSight::whatIsNotKnownOfAModelHasNoLine()
{
    DesignBench bench;
    bench.page->resize(1208, 1400);
    bench.arm();
    bench.page->identify();
    bench.finish(identified());
    QCoreApplication::processEvents();
    const QString said = wordsIn(*bench.page->findChild<ModelPanel *>());
    QVERIFY2(said.contains(QStringLiteral("Friction kS")), qPrintable(said));
    QVERIFY2(!said.contains(QStringLiteral("Noise")) && !said.contains(QStringLiteral("forwards")), qPrintable(said));
}

void TestDesignSight::theArmedPageSaysDutySpeedAndTravelBeforeAnythingIsOrdered()
{
    DesignBench bench;
    bench.arm();
    const auto *const steps = bench.page->findChild<TuningSteps *>();
    const QString pushes = messageText(textOf(extentOf(bench.page->findChild<ProposalList *>()->inForce())));
    QVERIFY2(wordsIn(*steps).contains(pushes), qPrintable(wordsIn(*steps)));
    QVERIFY2(pushes.contains(QStringLiteral("% duty")) && pushes.contains(QStringLiteral("counts from")),
        qPrintable(pushes));
    bench.page->identify();
    bench.finish(identified());
    const QString said = wordsIn(*steps);
    QVERIFY2(said.contains(pushes), qPrintable(said));
    QCOMPARE(said.count(QStringLiteral("counts from where it stands")), 2); // the steps of the proof have their own
    QVERIFY(bench.workbench.given<orders::RunTuning>().size() == 1);
}

void TestDesignSight::ofABoardTheAxisThatWasSelectedLastIsTunedAndNamed()
{
    DesignBench bench;
    bench.workbench.shot.devices.push_back(boardAt("sim:spi"));
    bench.selection.select({2}, 3);
    bench.selection.select({1});
    bench.selection.select({2}); // as on the page Tune
    bench.workbench.publish();
    QVERIFY2(bench.page->status().remedy.contains(QStringLiteral("Axis 3")), qPrintable(bench.page->status().remedy));
    bench.arming.arm({2});
    bench.page->autotune();
    const auto ordered = bench.workbench.given<orders::RunTuning>();
    QCOMPARE(ordered.size(), std::size_t{1});
    QCOMPARE(ordered.front().plan.axis, 3);
}

void TestDesignSight::theNextPageKnowsTheModelAndWhatWasChosen()
{
    DesignBench bench;
    bench.arm();
    bench.page->chooseLoop(Mode::Current);
    bench.page->identify();
    bench.finish(identified());
    bench.page->chooseAim(Aim::Brisk);
    bench.page = std::make_unique<DesignPage>(bench.workbench, bench.selection, bench.arming, bench.theme, nullptr);
    bench.page->show();
    QVERIFY(bench.page->report());
    QCOMPARE(bench.cards().size(), 3);
    bench.page->prove();
    const TunePlan plan = bench.workbench.given<orders::RunTuning>().back().plan;
    QVERIFY(plan.loop == Mode::Current);
    QVERIFY(plan.aim == Aim::Brisk);
}

void TestDesignSight::eachStimulusIsSaidWhileItRuns()
{
    DesignBench bench;
    bench.arm();
    bench.page->identify();
    const Message said = textOf({0.15, 52'000.0, 31'000.0});
    OperationView job;
    job.device = {1};
    job.status.log.push_back({{}, Severity::Caution, said});
    bench.workbench.shot.operations = {job};
    bench.workbench.publish();
    QVERIFY(wordsIn(*bench.page->findChild<TuningSteps *>()).contains(messageText(said)));
}

void TestDesignSight::theSetsAndTheSlidersAreInSightInTheSmallestWindow()
{
    DesignBench bench;
    makeSmall(bench);
    bench.arm();
    bench.page->identify();
    bench.finish(inFull());
    QCoreApplication::processEvents();
    const auto *const column = bench.page->findChild<DesignColumn *>();
    auto *const model = bench.page->findChild<ModelPanel *>();
    QVERIFY(model->isFolded());
    for (const ProposalCard *card : bench.cards())
        QVERIFY(isInSight(*card, *column));
    QVERIFY(isInSight(*bench.own(), *column));
    model->findChild<QPushButton *>()->click();
    QCoreApplication::processEvents();
    QVERIFY2(!model->isFolded(), "by hand it stays open");
    QVERIFY(column->verticalScrollBar()->maximum() > 0);
    model->findChild<QPushButton *>()->click();
    bench.page->resize(1208, 1400);
    QCoreApplication::processEvents();
    QVERIFY2(model->isFolded(), "and folded");
}

/// The page of a window of 1280×800 at 200 %, in units of its font.
void TestDesignSight::theChosenSetAndTheOrderThatProvesItAreInSightAtLargeText()
{
    DesignBench bench;
    bench.page->resize(408, 247);
    QCoreApplication::processEvents();
    bench.arm();
    bench.page->identify();
    bench.finish(inFull());
    for (const Aim aim : {Aim::Calm, Aim::Normal, Aim::Brisk}) {
        bench.page->chooseAim(aim);
        settleDown();
        const auto *const list = bench.page->findChild<ProposalList *>();
        const auto *const card = list->chosenCard();
        QVERIFY(card);
        const QString gains = shortest(*bench.page->chosen());
        const QLabel *const told = labelWith(*card, gains);
        QVERIFY2(told && isSeenWhole(told), qPrintable(gains));
    }
    const auto buttons = bench.page->findChildren<QPushButton *>();
    const auto prove = std::find_if(buttons.begin(), buttons.end(),
        [](const QPushButton *button) { return button->text() == DesignOrders::tr("Write and prove"); });
    QVERIFY(prove != buttons.end());
    QVERIFY(isSeenWhole(*prove));
    QVERIFY((*prove)->width() >= (*prove)->minimumSizeHint().width());
}

void TestDesignSight::theNumberedStepsAreInSightInTheSmallestWindowAndOnlyWhyItWasKeptScrolls()
{
    DesignBench bench;
    endSmall(bench, TuneResult::Kept);
    const auto &steps = *bench.page->findChild<TuningSteps *>();
    for (const char *words : {"Kept", "Write P, I", "Run 4 steps", "% duty", "Keep it in slot", "over ≤", "Else put",
             "Identify and Autotune push first"}) {
        const QLabel *const label = labelWith(steps, QString::fromUtf8(words));
        QVERIFY2(isSeenWhole(label), words);
    }
    QVERIFY(wordsIn(steps).contains(QStringLiteral("within 15 s"))); // told, wherever it stands
    QVERIFY(isSeenWhole(labelWith(*bench.page, QStringLiteral("Resolution"))));
    bench.page->resize(1208, 1400);
    settleDown();
    QVERIFY(wordsIn(steps).contains(QStringLiteral("every guard on")));
    QVERIFY(isSeenWhole(labelWith(steps, QStringLiteral("within 15 s"))));
}

void TestDesignSight::whyATuningFailedStandsAboveTheSteps()
{
    DesignBench bench;
    endSmall(bench, TuneResult::RolledBack);
    const auto &steps = *bench.page->findChild<TuningSteps *>();
    const QLabel *const why = labelWith(steps, QStringLiteral("within 15 s"));
    const QLabel *const first = labelWith(steps, QStringLiteral("Write P, I"));
    QVERIFY(isSeenWhole(why) && first);
    QVERIFY(why->mapTo(&steps, QPoint()).y() < first->mapTo(&steps, QPoint()).y());
}

void TestDesignSight::gainsOfSetsThatAreNotChosenGiveWayToTheSlidersInALowWindow()
{
    DesignBench bench;
    makeSmall(bench);
    bench.arm();
    bench.page->identify();
    bench.finish(inFull());
    bench.page->resize(1047, 530); // words of CJK take as much more room in a higher one
    settleDown();
    const auto *const column = bench.page->findChild<DesignColumn *>();
    QVERIFY(isInSight(*bench.own(), *column));
    const auto gainsOf = [](const ProposalCard &card) { return labelWith(card, QStringLiteral("P\u00A0")); };
    for (const ProposalCard *card : bench.cards())
        QCOMPARE(gainsOf(*card) != nullptr, card->aim() == Aim::Normal);
    bench.page->chooseAim(Aim::Calm);
    for (const ProposalCard *card : bench.cards())
        QCOMPARE(gainsOf(*card) != nullptr, card->aim() == Aim::Calm);
}

void TestDesignSight::aModelThatIsNotBelievedIsNeverFolded()
{
    DesignBench bench;
    makeSmall(bench);
    bench.arm();
    bench.page->identify();
    TuneReport doubtful = inFull();
    doubtful.gates.front().passed = false;
    bench.finish(doubtful);
    QCoreApplication::processEvents();
    QVERIFY(!bench.page->findChild<ModelPanel *>()->isFolded());
}

void TestDesignSight::whatIsInOrderTakesOneLineWhereThereIsLittleRoom()
{
    DesignBench bench;
    bench.page->resize(1208, 1400);
    bench.arm();
    bench.page->identify();
    bench.finish(identified());
    QCoreApplication::processEvents();
    const auto *const advisers = bench.page->findChild<AdviserList *>();
    const QString quiet = QStringLiteral("F and I give nothing back as overshoot");
    QVERIFY2(wordsIn(*advisers).contains(quiet), qPrintable(wordsIn(*advisers)));
    makeSmall(bench);
    QVERIFY2(!wordsIn(*advisers).contains(quiet), qPrintable(wordsIn(*advisers)));
    QVERIFY2(wordsIn(*advisers).contains(QStringLiteral("Resolution")), qPrintable(wordsIn(*advisers)));
}

void TestDesignSight::whatIsHiddenBecauseItsModelIsNotBelievedIsNotProven()
{
    DesignBench bench;
    bench.arm();
    bench.page->identify();
    bench.finish(identified());
    bench.page->chooseOwn(0.3, 1.6);
    QVERIFY(bench.page->chosen());
    bench.page->identify();
    TuneReport refused = identified();
    refused.result = TuneResult::Refused;
    refused.gates.front().passed = false;
    refused.proposals.clear();
    bench.finish(refused);
    QVERIFY(bench.cards().isEmpty() && !bench.own()->isVisible());
    QVERIFY(!bench.page->chosen());
    bench.page->prove();
    QCOMPARE(bench.workbench.given<orders::RunTuning>().size(), std::size_t(2));
}

MB_WINDOW_TEST(TestDesignSight);
#include "tst_designsight.moc"
