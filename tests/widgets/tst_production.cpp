// SPDX-License-Identifier: GPL-3.0-or-later
// Production: unit after unit without a click, PASS or FAIL with cause and remedy, arming, a scanner as keyboard.
#include "model/registry.h"
#include "support/fakeworkbench.h"
#include "support/timers.h"
#include "support/utf8.h"
#include "support/windowtests.h"
#include "widgets/common/applytheme.h"
#include "widgets/common/holdbutton.h"
#include "widgets/service/counttiles.h"
#include "widgets/service/journalcard.h"
#include "widgets/service/productionpage.h"
#include "widgets/service/stationdialog.h"
#include "widgets/service/unitlist.h"
#include "widgets/service/verdictof.h"

#include <QApplication>
#include <QCheckBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>
#include <QTranslator>

using namespace mb;
using namespace mb::test;

namespace {

service::QueueRow rowOf(std::uint32_t id, service::RowState state, const char *serial)
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

struct ProductionBench {
    FakeWorkbench workbench;
    ThemeSource theme{darkTheme()};
    QTemporaryDir folder;
    std::unique_ptr<ProductionPage> page;

    ProductionBench()
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
    [[nodiscard]] bool open(const QByteArray &recipe)
    {
        QFile file(folder.filePath(s("recipe.json")));
        return file.open(QIODevice::WriteOnly) && file.write(recipe) > 0 && (file.close(), true)
            && page->openRecipe(file.fileName());
    }
    /// What was ordered of arming, oldest first.
    [[nodiscard]] std::vector<bool> armed() const
    {
        std::vector<bool> orders;
        for (const auto &order : workbench.given<orders::ArmService>())
            orders.push_back(order.on);
        return orders;
    }
    void show(std::vector<service::QueueRow> rows, bool running = true) { workbench.serve(std::move(rows), running); }
};

const QByteArray plain = R"({"recipe":1,"name":"drive-base rev C","family":"dmc60c"})";
const QByteArray moving
    = R"({"recipe":1,"name":"drive-base rev C","family":"dmc60c","test":{"loop":"velocity","to":1500,
"limits":{"travel":50000,"speed":2000,"duty":0.3},"accept":{"overshoot":0.4}}})";

} // namespace

class TestProduction : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void oneClickServesUnitAfterUnit();
    void theVerdictIsTheUnitThatRunsOrEndedLast();
    void aFailureSaysCauseAndRemedyAndCanBeTestedAgain();
    void whatIsSetAsideMakesRoom();
    void armingShowsFirstWhatWillMove();
    void leavingDisarms();
    void aScannerIsAKeyboard();
    void aMistakeInARecipeIsSaidWithItsLine();
    void aShiftIsCountedInFigures();
    void aUnitThatHadEverythingIsNoWork();
    void theHeadNamesTheRecipeOfTheVerdict();
    void aSmallPageKeepsItsVerdict();
    void theJournalOfTheStationIsChosenAndItsServerFollowed();
    void whatEndedItIsSaidInTheLanguageOfTheWindow();
    void whatEndedItIsSaidBeforeTheLastVerdict();
    void aSelfTestThatRunsIsWatchedOverThoughAFailHasDisarmed();
    void soundCanBeSwitchedOff();
    void aUnitThatWaitsForArmingSaysSo();
    void pictures();
};

void TestProduction::oneClickServesUnitAfterUnit()
{
    ProductionBench bench;
    bench.page->start();
    QVERIFY(bench.workbench.given<orders::ServeUnits>().empty()); // without a recipe
    QVERIFY(bench.open(plain));
    bench.page->start();
    const auto begun = bench.workbench.given<orders::ServeUnits>();
    QCOMPARE(begun.size(), 1U);
    QCOMPARE(begun.front().links, std::vector<std::string>{"sim:can"});
    QCOMPARE(begun.front().units, std::optional(0)); // as they are put on, until it is ended
    QCOMPARE(begun.front().matter->recipe.name, std::string("drive-base rev C"));
}

void TestProduction::theVerdictIsTheUnitThatRunsOrEndedLast()
{
    ProductionBench bench;
    QCOMPARE(bench.page->verdict().verdict().kind, Verdict::Kind::Waiting);
    auto working = rowOf(1, service::RowState::Running, "A1");
    working.what = say("Page 12");
    working.done = 12;
    working.total = 30;
    bench.show({working});
    QCOMPARE(bench.page->verdict().verdict().kind, Verdict::Kind::Working);
    QCOMPARE(bench.page->verdict().verdict().share, 0.4);
    auto passed = rowOf(1, service::RowState::Passed, "A1");
    passed.visit.number = 36;
    bench.show({passed});
    const Verdict &verdict = bench.page->verdict().verdict();
    QCOMPARE(verdict.kind, Verdict::Kind::Passed);
    QCOMPARE(verdict.unit, s("A1"));
    QCOMPARE(verdict.number, s("#36"));
    QCOMPARE(verdict.facts.front().value, s("1.23 → 1.25"));
    QVERIFY(!verdict.next.isEmpty());
    bench.show({passed, rowOf(2, service::RowState::Running, "B2")});
    QCOMPARE(bench.page->verdict().verdict().unit, s("B2"));
    auto *units = bench.page->findChild<QListWidget *>();
    QCOMPARE(units->count(), 2);
    QVERIFY(units->item(0)->text().startsWith(s("B2"))); // newest first
}

void TestProduction::aFailureSaysCauseAndRemedyAndCanBeTestedAgain()
{
    ProductionBench bench;
    auto failed = rowOf(7, service::RowState::Failed, "A1");
    failed.visit.cause = Message::verbatim("friction 0.61 V, at most 0.4");
    failed.visit.remedy = Message::verbatim("free the shaft");
    bench.show({failed});
    const Verdict &verdict = bench.page->verdict().verdict();
    QCOMPARE(verdict.kind, Verdict::Kind::Failed);
    QCOMPARE(verdict.cause, s("Friction 0.61 V, at most 0.4")); // sentences
    QCOMPARE(verdict.remedy, s("Free the shaft"));
    QVERIFY2(verdict.next.contains(s("F5")) && verdict.next.contains(s("F8")), qPrintable(verdict.next));
    bench.workbench.served.running = false;
    bench.show({failed, rowOf(8, service::RowState::Skipped, "B2")});
    QVERIFY(bench.page->verdict().verdict().next.contains(s("F5")));
    auto *units = bench.page->findChild<QListWidget *>();
    QVERIFY(units->item(0)->text().startsWith(s("A1"))); // what was left out is none of the last ten
    QTest::keyClick(bench.page.get(), Qt::Key_F5);
    QCOMPARE(bench.workbench.given<orders::RetryUnit>().at(0).row, 7U);
}

void TestProduction::whatIsSetAsideMakesRoom()
{
    ProductionBench bench;
    bench.show({rowOf(7, service::RowState::Failed, "A1")});
    QTest::keyClick(bench.page.get(), Qt::Key_F8);
    QCOMPARE(bench.page->verdict().verdict().kind, Verdict::Kind::Waiting);
    bench.show({rowOf(7, service::RowState::Failed, "A1"), rowOf(8, service::RowState::Passed, "B2")});
    QCOMPARE(bench.page->verdict().verdict().unit, s("B2"));
}

void TestProduction::armingShowsFirstWhatWillMove()
{
    ProductionBench bench;
    QVERIFY(bench.open(plain));
    QVERIFY(bench.page->armButton().isHidden()); // nothing moves
    QVERIFY2(
        bench.open(moving), qPrintable(bench.workbench.lines.empty() ? QString() : bench.workbench.lines.back().text));
    QVERIFY(!bench.page->armButton().isHidden());
    QVERIFY(bench.page->armButton().isHoldNeeded());
    bool said = false;
    for (const auto *label : bench.page->findChildren<QLabel *>())
        said = said || (label->text().contains(s("30")) && label->text().contains(s("50")));
    QVERIFY(said);
    bench.show({});
    Q_EMIT bench.page->armButton().activated();
    QCOMPARE(bench.armed(), std::vector<bool>{true});
    bench.workbench.served.mayTurn = MayTurn::Every;
    Q_EMIT bench.workbench.serviceChanged();
    QTRY_VERIFY(bench.workbench.given<orders::RenewService>().size() > 1);
    Q_EMIT bench.page->armButton().activated();
    QCOMPARE(bench.armed(), (std::vector<bool>{true, false}));
}

void TestProduction::leavingDisarms()
{
    ProductionBench bench;
    bench.page->hide();
    QCOMPARE(bench.armed(), std::vector<bool>{false});
}

void TestProduction::aScannerIsAKeyboard()
{
    ProductionBench bench;
    bench.show(
        {rowOf(3, service::RowState::Failed, "2103343A7B2E"), rowOf(4, service::RowState::Skipped, "2103343A7B2F")});
    bench.page->setFocus();
    QTest::keyClicks(bench.page.get(), s("2"));
    auto *serial = bench.page->findChild<QLineEdit *>();
    QCOMPARE(serial->text(), s("2"));
    QTest::keyClicks(serial, s("103343A7B2F"));
    QTest::keyClick(serial, Qt::Key_Return);
    QCOMPARE(bench.workbench.given<orders::RetryUnit>().at(0).row, 4U);
    QVERIFY(serial->text().isEmpty());
}

void TestProduction::aMistakeInARecipeIsSaidWithItsLine()
{
    ProductionBench bench;
    QVERIFY(!bench.open("{\"recipe\":1,\n\"name\":\"x\",\n\"colour\":3}"));
    QVERIFY2(bench.workbench.lines.back().text.contains(s("3")), qPrintable(bench.workbench.lines.back().text));
}

/// 27 units that took 21.6 s each and began every 90 s.
std::vector<service::QueueRow> aShift()
{
    std::vector<service::QueueRow> rows;
    for (std::uint32_t i = 0; i < 27; ++i) {
        auto row = rowOf(i + 1, service::RowState::Passed, "2103343A7B00");
        row.visit.serial = "2103343A7B" + std::to_string(10 + i);
        row.visit.time = 1.7e9 + 90.0 * i;
        row.visit.number = static_cast<int>(10 + i);
        rows.push_back(row);
    }
    rows[20].state = service::RowState::Failed;
    rows[20].visit.number.reset();
    rows[20].visit.cause = Message::verbatim("friction 0.61 V, at most 0.4");
    rows[20].visit.remedy = Message::verbatim("Free the shaft and test again, or put it in the red box");
    return rows;
}

void TestProduction::aShiftIsCountedInFigures()
{
    ProductionBench bench;
    bench.workbench.served.counts = {26, 1, 0};
    bench.show(aShift());
    const QStringList texts = bench.page->findChild<CountTiles *>()->texts();
    QCOMPARE(texts.mid(0, 3), (QStringList{s("26 passed"), s("1 failed"), s("0 refused before start")}));
    QVERIFY2(texts.at(3).startsWith(s("21.6")), qPrintable(texts.at(3)));
    QCOMPARE(texts.at(4), s("41 units an hour")); // 27 in 26 × 90 s + 21.6 s
    auto few = aShift();
    few.resize(3);
    bench.show(few);
    QVERIFY(!bench.page->findChild<CountTiles *>()->texts().at(4).contains(QRegularExpression(s("\\d"))));
}

void TestProduction::aUnitThatHadEverythingIsNoWork()
{
    auto rows = aShift();
    ServiceView before;
    before.rows.assign(rows.begin(), rows.end());
    auto current = rowOf(100, service::RowState::Passed, "A1");
    current.visit.outcome = service::Outcome::Passed;
    current.visit.time = 1.7e9 - 5000.0;
    current.visit.seconds = 0.5;
    current.visit.from = current.visit.to;
    current.visit.parameters.reset();
    rows.push_back(current);
    ServiceView after;
    after.rows.assign(rows.begin(), rows.end());
    QCOMPARE(unitsAnHour(after), unitsAnHour(before));
    QCOMPARE(meanSeconds(after), meanSeconds(before));
    rows.back().visit.parameters = 55; // those were written and read back
    after.rows.assign(rows.begin(), rows.end());
    QVERIFY(meanSeconds(after) != meanSeconds(before));
}

void TestProduction::theHeadNamesTheRecipeOfTheVerdict()
{
    ProductionBench bench;
    const auto named = [&bench](const QString &name) {
        const auto labels = bench.page->findChildren<QLabel *>();
        return std::any_of(labels.begin(), labels.end(),
            [&name](const QLabel *label) { return label->isVisible() && label->text() == name; });
    };
    const auto start = [&bench] {
        const auto buttons = bench.page->findChildren<QPushButton *>();
        return *std::find_if(buttons.begin(), buttons.end(),
            [](const QPushButton *button) { return button->text() == s("Start") || button->text() == s("End"); });
    };
    QVERIFY(named(s("No recipe yet")));
    QVERIFY(!start()->isEnabled());
    service::RecipeMatter others;
    others.recipe.name = "firmware of the queue";
    others.recipe.firmware = service::FirmwareRule{"/somewhere/dmc60c-1.25.hex", {}};
    others.imageVersion = "1.25";
    others.imageHash = "9f2a41c7d0";
    others.recipe.test = service::SelfTest{};
    others.recipe.test->to = 1500.0;
    others.recipe.test->accept.push_back({});
    others.recipe.test->accept.back().key = "peak_current";
    bench.workbench.served.matter = std::make_shared<const service::RecipeMatter>(others);
    bench.show({rowOf(1, service::RowState::Passed, "A1")}, false);
    QVERIFY(named(s("firmware of the queue")));
    QVERIFY(named(s("dmc60c-1.25.hex · version 1.25 · sha 9f2a41c7")));
    QVERIFY(named(s("velocity, peak current"))); // in words, not by its key
    const auto *motion = bench.page->findChild<QLabel *>(s("motion"));
    QVERIFY(motion->isVisible()
        && motion->text().startsWith(s("The self-test turns the motor: velocity to"))); // before anybody arms it
    QVERIFY(!named(s("No recipe yet")));
    QVERIFY(!start()->isEnabled());
    QVERIFY(bench.open(plain));
    QVERIFY(named(s("drive-base rev C")));
    QVERIFY(bench.page->verdict().verdict().unit.isEmpty()); // it was of another recipe
    QVERIFY(start()->isEnabled());
}

void TestProduction::whatEndedItIsSaidInTheLanguageOfTheWindow()
{
    class Words : public QTranslator {
        bool isEmpty() const override { return false; }
        QString translate(const char *, const char *source, const char *, int) const override
        {
            return qstrcmp(source, "all numbers are used up, the highest is %1") == 0 ? s("keine Nummer mehr bis %1")
                                                                                      : QString();
        }
    } words;
    QVERIFY(QCoreApplication::installTranslator(&words));
    ProductionBench bench;
    const Message cause = say("all numbers are used up, the highest is %1", 63);
    bench.workbench.served.trouble = Error{Fault::OutOfRange, cause, Message::verbatim("x")}.message();
    bench.show({}, false);
    const QString said = bench.page->verdict().verdict().cause;
    QCoreApplication::removeTranslator(&words);
    QCOMPARE(said, s("keine Nummer mehr bis 63; x"));
}

void TestProduction::whatEndedItIsSaidBeforeTheLastVerdict()
{
    ProductionBench bench;
    bench.workbench.served.trouble = Message::verbatim("the disk is full");
    bench.show({rowOf(1, service::RowState::Passed, "A1"), rowOf(2, service::RowState::Skipped, "B2")}, false);
    QCOMPARE(bench.page->verdict().verdict().cause, s("the disk is full"));
}

void TestProduction::aSelfTestThatRunsIsWatchedOverThoughAFailHasDisarmed()
{
    ProductionBench bench;
    QVERIFY(bench.open(moving));
    bench.workbench.served.mayTurn = MayTurn::WhatTurns;
    bench.show({rowOf(1, service::RowState::Running, "A1")});
    QTRY_VERIFY(!bench.workbench.given<orders::RenewService>().empty());
    bench.workbench.served.mayTurn = MayTurn::Nothing;
    bench.show({});
    const auto before = bench.workbench.given<orders::RenewService>().size();
    passTimers(std::chrono::milliseconds(300));
    QCOMPARE(bench.workbench.given<orders::RenewService>().size(), before);
}

void TestProduction::soundCanBeSwitchedOff()
{
    ProductionBench bench;
    std::vector<int> tones;
    QObject::connect(
        bench.page.get(), &ProductionPage::sounded, bench.page.get(), [&tones](int times) { tones.push_back(times); });
    auto *box = bench.page->findChild<QCheckBox *>();
    QCOMPARE(box->accessibleName(), s("Sound with every verdict"));
    const auto end = [&bench](service::Outcome outcome) {
        service::Visit visit;
        visit.outcome = outcome;
        Q_EMIT bench.workbench.unitEnded(visit);
    };
    const auto announce = [&bench](bool on) {
        bench.workbench.served.announced = on ? 1 : 0;
        bench.show({rowOf(1, service::RowState::Running, "A1")});
    };
    box->setChecked(true);
    end(service::Outcome::Passed);
    end(service::Outcome::Failed);
    announce(true);
    announce(true); // the same three seconds
    QCOMPARE(tones, (std::vector<int>{1, 3, 2}));
    announce(false);
    box->setChecked(false);
    end(service::Outcome::Failed);
    announce(true);
    QCOMPARE(tones.size(), std::size_t(3));
}

void TestProduction::aUnitThatWaitsForArmingSaysSo()
{
    ProductionBench bench;
    auto row = rowOf(1, service::RowState::Running, "A1");
    row.visit.step = service::Step::Test;
    row.what = say("waits until the station is armed");
    bench.workbench.served.waiting = 1;
    bench.show({row});
    const Verdict &verdict = bench.page->verdict().verdict();
    QCOMPARE(verdict.step, s("waits until the station is armed"));
    QCOMPARE(verdict.next, s("Hold Arm to go on"));
    QVERIFY(bench.page->verdict().accessibleDescription().contains(s("Hold Arm to go on")));
    bench.workbench.served.waiting = 0;
    bench.show({row});
    QVERIFY(bench.page->verdict().verdict().next != s("Hold Arm to go on"));
}

void TestProduction::aSmallPageKeepsItsVerdict()
{
    ProductionBench bench;
    QVERIFY(bench.page->findChild<UnitList *>()->isVisible());
    bench.page->resize(600, 380);
    QVERIFY(!bench.page->findChild<UnitList *>()->isVisible());
    QVERIFY(bench.page->verdict().isVisible());
    QTRY_VERIFY2(bench.page->verdict().height() >= 120, qPrintable(QString::number(bench.page->verdict().height())));
    QVERIFY(bench.page->rect().contains(bench.page->verdict().geometry()));
    bench.page->resize(1280, 748);
    QVERIFY(bench.page->findChild<UnitList *>()->isVisible());
}

void TestProduction::theJournalOfTheStationIsChosenAndItsServerFollowed()
{
    ProductionBench bench;
    auto *card = bench.page->findChild<JournalCard *>();
    QVERIFY2(card->text().startsWith(s("On this computer")), qPrintable(card->text()));
    QTest::mouseClick(card->findChild<QPushButton *>(), Qt::LeftButton);
    auto *dialog = card->findChild<StationDialog *>();
    QVERIFY(dialog && dialog->isVisible());
    dialog->server().setText(s("ftp://bench-db"));
    dialog->station().setText(s(" bench 2 "));
    dialog->accept();
    bench.workbench.given<orders::KeepJournal>().at(0).finished(
        fail(Fault::Usage, Message::verbatim("no address of a server")));
    QVERIFY(dialog->isVisible()); // what is wrong is said, and nothing has changed
    QVERIFY(dialog->mistake().contains(s("no address")));
    dialog->server().setText(s("postgresql://anna@bench-db/journal"));
    dialog->accept();
    QVERIFY(dialog->isVisible()); // until it is so
    const auto chosen = bench.workbench.given<orders::KeepJournal>().at(1);
    QCOMPARE(chosen.server, std::string("postgresql://anna@bench-db/journal"));
    QCOMPARE(chosen.station, std::string("bench 2"));
    chosen.finished({});
    QVERIFY(!dialog->isVisible());
    bench.workbench.kept = {chosen.server, chosen.station, 0, {}};
    Q_EMIT bench.workbench.serviceChanged();
    QCOMPARE(card->text(), s("PostgreSQL, bench-db/journal\nstation bench 2"));
    bench.workbench.kept.waiting = 3;
    bench.workbench.kept.trouble = Message::verbatim("the server does not answer");
    Q_EMIT bench.workbench.serviceChanged();
    QVERIFY2(card->text().contains(s("3 entries wait for the server: the server does not answer")),
        qPrintable(card->text()));
    bench.show({});
    QVERIFY(!card->findChild<QPushButton *>()->isEnabled()); // not while units are served
}

void TestProduction::pictures()
{
    const QString folder = qEnvironmentVariable("MOTORBENCH_PICTURES");
    if (folder.isEmpty())
        QSKIP("pictures for looking at: only where MOTORBENCH_PICTURES names a folder");
    for (const bool dark : {true, false}) {
        ProductionBench bench;
        bench.theme.setTheme(dark ? darkTheme() : lightTheme());
        applyTheme(*qApp, bench.theme.theme());
        QVERIFY(bench.open(moving));
        bench.page->resize(1440, 820);
        bench.workbench.served.counts = {26, 1, 0};
        auto rows = aShift();
        rows.back().visit.test
            = {{"resistance", 0.094, 0.080, 0.110, true, false}, {"overshoot", 0.02, {}, 0.4, true, true}};
        bench.show(rows);
        const QString name = folder + QLatin1Char('/') + s(dark ? "dark" : "light");
        QVERIFY(bench.page->grab().save(name + s("-pass.png")));
        rows.resize(21);
        bench.show(rows);
        QVERIFY(bench.page->grab().save(name + s("-fail.png")));
        bench.page->resize(1280, 700);
        QVERIFY(bench.page->grab().save(name + s("-fail-1280.png")));
        bench.page->resize(640, 400);
        QTRY_VERIFY(!bench.page->findChild<UnitList *>()->isVisible());
        QCoreApplication::processEvents();
        QVERIFY(bench.page->grab().save(name + s("-small.png")));
    }
}

MB_WINDOW_TEST(TestProduction);
#include "tst_production.moc"
