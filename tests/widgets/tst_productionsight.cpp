// SPDX-License-Identifier: GPL-3.0-or-later
// What production shows beside its verdict: what must hold before a unit, what comes next, how many are in the journal.
#include "model/registry.h"
#include "support/fakeworkbench.h"
#include "support/utf8.h"
#include "support/windowtests.h"
#include "widgets/common/numberformat.h"
#include "widgets/service/counttiles.h"
#include "widgets/service/journalcard.h"
#include "widgets/service/productionpage.h"
#include "widgets/service/unitchecks.h"
#include "widgets/service/verdictof.h"

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QListWidget>
#include <QTest>

using namespace mb;
using namespace mb::test;

namespace {

service::QueueRow sightRow(std::uint32_t id, service::RowState state, const char *serial)
{
    service::QueueRow row;
    row.id = id;
    row.state = state;
    row.visit.serial = serial;
    row.visit.time = 1000.0 + id;
    row.visit.seconds = 21.6;
    row.visit.from = "1.23";
    row.visit.to = "1.25";
    row.visit.parameters = 55;
    return row;
}

struct SightBench {
    FakeWorkbench workbench;
    ThemeSource theme{darkTheme()};
    std::unique_ptr<ProductionPage> page;

    SightBench()
    {
        LinkView link;
        link.address = "sim:can";
        link.name = "sim:can";
        link.state = LinkState::Open;
        workbench.shot.links.push_back(link);
        page = std::make_unique<ProductionPage>(workbench, families(), theme, nullptr);
        page->setSound(false);
        page->resize(1280, 748);
        page->show();
        QApplication::setActiveWindow(page.get());
    }
    void show(std::vector<service::QueueRow> rows, bool running = true) { workbench.serve(std::move(rows), running); }
};

} // namespace

class TestProductionSight : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void atTwiceTheFontKeysAndCountsStayInSight();
    void whatMustHoldBeforeAUnitIsShown();
    void aLinkThatIsNotOpenIsNamedBesideOneThatIs();
    void whatComesNextIsSaidWithTheVerdict();
    void aUnitThatWasCutOffIsNotHiddenByTheVerdictBeforeIt();
    void whatRunsWhileAnotherIsSetAsideIsSeenWhenItIsCutOff();
    void afterTheEndOfAQueueNoKeyIsSaidToTestAgain();
    void aUnitThatWentOnAfterACutIsTheLast();
    void aUnitThatFailedBeforeItsNumberIsSaidToHaveGotNoneThisTime();
    void unitsThatWaitForTheServerAreNotSaidToBeThere();
    void aSelfTestIsShownWithWhereItBegins();
    void whilePausedNoUnitIsSaidToStartByItself();
};

void TestProductionSight::atTwiceTheFontKeysAndCountsStayInSight()
{
    SightBench bench;
    auto &page = *bench.page;
    page.resize(1280, 490); // what a window of 1080 lines leaves, in units of twice the font
    QCoreApplication::processEvents();
    for (const QWidget *part :
        {static_cast<QWidget *>(page.findChild<CountTiles *>()),
            static_cast<QWidget *>(page.findChild<QCheckBox *>(s("sound"))), static_cast<QWidget *>(&page.verdict())}) {
        QVERIFY(part->isVisible());
        QVERIFY(page.rect().contains(QRect(part->mapTo(&page, QPoint()), part->size())));
    }
    QVERIFY(page.verdict().height() >= page.verdict().minimumSizeHint().height());
}

void TestProductionSight::whatMustHoldBeforeAUnitIsShown()
{
    SightBench bench;
    const auto &checks = *bench.page->findChild<UnitChecks *>();
    QVERIFY(checks.isVisible());
    QVERIFY2(checks.text().contains(s("sim:can is open")), qPrintable(checks.text()));
    QVERIFY(checks.text().contains(s("no unit answers yet")));
    QVERIFY(checks.text().contains(s("no motor turns")));
    DeviceView turning;
    turning.family = families().front();
    turning.link = "sim:can";
    turning.liveness.heard = true;
    turning.identity.edit().address = 5;
    turning.mayTurn = true;
    bench.workbench.shot.devices.push_back(turning);
    bench.workbench.publish();
    QVERIFY2(checks.text().contains(s("#5 may turn")), qPrintable(checks.text()));
    bench.workbench.shot.links.front().state = LinkState::Lost;
    bench.workbench.publish();
    QVERIFY2(checks.text().contains(s("no link is open")), qPrintable(checks.text()));
}

void TestProductionSight::aLinkThatIsNotOpenIsNamedBesideOneThatIs()
{
    SightBench bench;
    const auto &checks = *bench.page->findChild<UnitChecks *>();
    Q_EMIT bench.page->findChild<QComboBox *>()->activated(0);
    LinkView other = bench.workbench.shot.links.front();
    other.address = other.name = "sim:serial";
    bench.workbench.shot.links.front().state = LinkState::Lost;
    bench.workbench.shot.links.push_back(other);
    bench.workbench.publish();
    QVERIFY2(checks.text().contains(s("sim:can is not open")), qPrintable(checks.text()));
}

void TestProductionSight::whatComesNextIsSaidWithTheVerdict()
{
    SightBench bench;
    auto passed = sightRow(1, service::RowState::Passed, "A1");
    bench.show({passed});
    QCOMPARE(bench.page->verdict().verdict().next, s("Unplug, connect next"));
    QCOMPARE(bench.page->verdict().verdict().facts.front().note, s("it answers with it"));
    passed.visit.from = "1.25";
    bench.show({passed}, false);
    QVERIFY(!bench.page->verdict().verdict().hint.isEmpty());
    QCOMPARE(bench.page->verdict().verdict().facts.front().note, s("was there already"));
    passed.visit.unproved = true;
    bench.show({passed}, false);
    QCOMPARE(bench.page->verdict().verdict().facts.front().note, s("written, not proved"));
    bench.workbench.served.counts.passed = 3;
    bench.show({passed}, false);
    QVERIFY2(bench.page->findChild<JournalCard *>()->text().contains(s("3 units")),
        qPrintable(bench.page->findChild<JournalCard *>()->text()));
}

void TestProductionSight::aUnitThatWasCutOffIsNotHiddenByTheVerdictBeforeIt()
{
    SightBench bench;
    auto cut = sightRow(2, service::RowState::Skipped, "B2");
    cut.visit.id = "visit";
    cut.visit.cause = say("stopped before its motor turned");
    bench.show({sightRow(1, service::RowState::Passed, "A1"), cut}, false);
    const Verdict &verdict = bench.page->verdict().verdict();
    QCOMPARE(verdict.kind, Verdict::Kind::LeftOut);
    QCOMPARE(verdict.unit, s("B2"));
    QCOMPARE(verdict.cause, s("Stopped before its motor turned"));
    QVERIFY2(verdict.next.contains(s("F5")), qPrintable(verdict.next));
    auto *units = bench.page->findChild<QListWidget *>();
    QVERIFY2(units->item(0)->text().startsWith(s("B2 left out")), qPrintable(units->item(0)->text()));
    QTest::keyClick(bench.page.get(), Qt::Key_F8);
    QCOMPARE(bench.page->verdict().verdict().unit, QString());
}

void TestProductionSight::whatRunsWhileAnotherIsSetAsideIsSeenWhenItIsCutOff()
{
    SightBench bench;
    auto second = sightRow(2, service::RowState::Running, "B2");
    second.tries = 1;
    bench.show({sightRow(1, service::RowState::Failed, "A1"), second});
    QTest::keyClick(bench.page.get(), Qt::Key_F8);
    second.state = service::RowState::Skipped;
    second.visit.id = "visit";
    bench.show({sightRow(1, service::RowState::Failed, "A1"), second});
    QCOMPARE(bench.page->verdict().verdict().unit, s("B2"));
    QCOMPARE(bench.page->verdict().verdict().hint, QString()); // it starts by nothing but F5
    QTest::keyClick(bench.page.get(), Qt::Key_F8);
    QCOMPARE(bench.page->verdict().verdict().unit, QString());
    ++second.tries;
    bench.show({sightRow(1, service::RowState::Failed, "A1"), second});
    QCOMPARE(bench.page->verdict().verdict().unit, s("B2"));
    QTest::keyClick(bench.page.get(), Qt::Key_F8);
    second.visit.id = "in another queue"; // whose rows are counted from 1 again
    bench.show({second});
    QCOMPARE(bench.page->verdict().verdict().unit, s("B2"));
}

void TestProductionSight::afterTheEndOfAQueueNoKeyIsSaidToTestAgain()
{
    SightBench bench;
    bench.workbench.served.finishing = true;
    bench.show({sightRow(1, service::RowState::Failed, "A1")}, false);
    const Verdict &verdict = bench.page->verdict().verdict();
    QCOMPARE(verdict.next, s("Safe to unplug"));
    QCOMPARE(verdict.hint, s("Open a recipe, then Start")); // another page has begun it
    const ServiceView &served = bench.workbench.served;
    QCOMPARE(verdictOf(served, {}, *bench.page, true).next, s("Start serves it once more"));
}

void TestProductionSight::aUnitThatWentOnAfterACutIsTheLast()
{
    SightBench bench;
    auto first = sightRow(1, service::RowState::Failed, "A1"); // left out, and taken up again after the other
    first.visit.steps = {{service::Step::Preflight, 1000.0, true, {}}, {service::Step::Test, 1200.0, true, {}}};
    auto other = sightRow(2, service::RowState::Passed, "B2");
    other.visit.steps = {{service::Step::Proof, 1100.0, true, {}}};
    bench.show({first, other});
    QCOMPARE(bench.page->verdict().verdict().unit, s("A1"));
}

void TestProductionSight::aUnitThatFailedBeforeItsNumberIsSaidToHaveGotNoneThisTime()
{
    SightBench bench;
    service::RecipeMatter matter;
    matter.recipe.number.emplace();
    bench.workbench.served.matter = std::make_shared<const service::RecipeMatter>(std::move(matter));
    auto failed = sightRow(1, service::RowState::Failed, "A1");
    bench.show({failed});
    QCOMPARE(bench.page->verdict().verdict().hint, s("No number was written to it this time."));
    failed.visit.number = 7;
    bench.show({failed});
    QCOMPARE(bench.page->verdict().verdict().hint, QString());
}

void TestProductionSight::unitsThatWaitForTheServerAreNotSaidToBeThere()
{
    SightBench bench;
    bench.workbench.kept = {"postgresql://anna@bench-db/journal", "bench 2", 3, {}};
    bench.workbench.served.counts.passed = 3;
    bench.show({sightRow(1, service::RowState::Passed, "A1")});
    const QString text = bench.page->findChild<JournalCard *>()->text();
    QVERIFY2(text.contains(s("3 entries wait")) && !text.contains(s("3 units")), qPrintable(text));
}

void TestProductionSight::aSelfTestIsShownWithWhereItBegins()
{
    service::SelfTest test;
    test.loop = Mode::Velocity;
    test.from = -8000.0;
    test.to = 1500.0;
    const QString text = motionOf(test);
    QVERIFY2(text.contains(s("from ") + formatSignificant(-8000.0, 4) + s(" to ")), qPrintable(text));
}

void TestProductionSight::whilePausedNoUnitIsSaidToStartByItself()
{
    SightBench bench;
    bench.workbench.served.pausing = true;
    for (const bool any : {false, true}) {
        bench.show(any ? std::vector{sightRow(1, service::RowState::Passed, "A1")} : std::vector<service::QueueRow>());
        const QString &hint = bench.page->verdict().verdict().hint;
        QVERIFY2(hint.startsWith(s("Paused")), qPrintable(hint));
    }
}

MB_WINDOW_TEST(TestProductionSight);
#include "tst_productionsight.moc"
