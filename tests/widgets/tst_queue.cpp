// SPDX-License-Identifier: GPL-3.0-or-later
// The queue on the page Firmware: units are ticked, one order serves them, each row tells how far it is and what came of it.
#include "queuebench.h"
#include "support/windowtests.h"
#include "widgets/common/banner.h"
#include "widgets/common/iconbutton.h"
#include "widgets/firmware/pagemap.h"
#include "widgets/firmware/queuebar.h"
#include "widgets/firmware/unitsteps.h"
#include "widgets/firmware/updatelog.h"

#include <QAbstractItemModelTester>
#include <QAccessible>
#include <QCheckBox>
#include <QFile>
#include <QTableView>

using namespace mb;
using namespace mb::test;

class QueueTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void tickedUnitsAreServedAndNoOthers();
    void everyUnitOfTheFamilyByOneTick();
    void withoutRecipeOrTickNothingStarts();
    void eachRowTellsHowFarItIsAndWhatCameOfIt();
    void whatWasWrittenAndNotProvedIsNotCalledVerified();
    void theUnitBesideTheQueueIsTheChosenOrTheRunningOrTheLastOne();
    void pagesThatWereSentAgainAreThoseOfTheShownUnit();
    void whatMustNotBeCutIsShown();
    void unitsThatComeAndGoLeaveTheChosenOneChosen();
    void aUnitWhoseSelfTestTurnsItsMotorIsNotSafeToUnplug();
    void aBarIsWholeOnlyForAUnitThatPassed();
    void theLogTellsEveryUnit();
    void pauseSkipRetryAndCancelAreOrders();
    void aCutQueueIsOfferedAndGoneOnWith();
    void aCutQueueIsOfferedUntilItIsDismissed();
    void whatWasCutOffIsLookedForOnEveryLinkThatIsOpen();
    void simulatedUnitsAndRealOnesAreNotGoneOnWithTogether();
    void whatEndedIsSavedAsATable();
    void aRefusedStartIsSaid();
    void ticksAreForKeyboardAndReader();
    void whatStartsIsInSightWhereLittleIs();
    void thePageIsNoHigherThanItsWindow();
};

/// The page of a window of 1280×800 at twice the font, beside the devices.
void QueueTest::whatStartsIsInSightWhereLittleIs()
{
    QueueBench bench;
    bench.page->resize(395, 247);
    for (const bool queue : {false, true}) {
        bench.page->showQueue(queue);
        QCoreApplication::processEvents();
        bool seen = false;
        for (const auto *button : bench.page->findChildren<CommandButton *>()) {
            const QString text = button->text();
            if (!button->isVisible() || text != (queue ? QStringLiteral("Start") : QStringLiteral("Update")))
                continue;
            seen = true;
            const int end = button->mapTo(bench.page.get(), QPoint(0, button->height())).y();
            QVERIFY2(end < 247, qPrintable(text + QString::number(end)));
        }
        QVERIFY(seen);
    }
    QVERIFY(bench.board().table().viewport()->height() >= 60); // two units
}

void QueueTest::thePageIsNoHigherThanItsWindow()
{
    QueueBench bench;
    bench.page->resize(1048, 640);
    for (const bool queue : {true, false}) {
        bench.page->showQueue(queue);
        QCoreApplication::processEvents();
        QVERIFY2(bench.page->minimumSizeHint().height() < 560,
            qPrintable(QString::number(bench.page->minimumSizeHint().height())));
    }
}

void QueueTest::tickedUnitsAreServedAndNoOthers()
{
    QueueBench bench;
    const QAbstractItemModelTester tester(&bench.model());
    QVERIFY(bench.board().openImage(demoImage));
    QCOMPARE(bench.model().rowCount(), 3);
    bench.model().tick({1}, true);
    bench.model().tick({3}, true);
    QTest::keyClick(bench.page.get(), Qt::Key_F5);
    const auto begun = bench.workbench.given<orders::ServeUnits>();
    QCOMPARE(begun.size(), 1U);
    const orders::ServeUnits &plan = begun.front();
    QCOMPARE(plan.links, (std::vector<std::string>{"sim:can", "socketcan:can1"})); // buses side by side
    QVERIFY(plan.chosen == std::vector<DeviceId>({DeviceId{1}, DeviceId{3}}));
    QVERIFY(!plan.units);
    QCOMPARE(plan.matter->imageVersion, std::string("1.25"));
    QCOMPARE(plan.matter->recipe.family->key, std::string_view("dmc60c"));
}

void QueueTest::everyUnitOfTheFamilyByOneTick()
{
    QueueBench bench;
    QVERIFY(bench.board().openImage(demoImage));
    auto *every = bench.board().findChild<QCheckBox *>();
    QCOMPARE(every->text(), QStringLiteral("Every DMC60C"));
    every->click();
    QCOMPARE(bench.model().ticked().size(), 3U);
    QVERIFY(every->isChecked());
    bench.model().tick({2}, false);
    QVERIFY(!every->isChecked());
    every->click();
    every->click();
    QVERIFY(bench.model().ticked().empty());
}

void QueueTest::withoutRecipeOrTickNothingStarts()
{
    QueueBench bench;
    QVERIFY(!bench.board().canStart());
    QVERIFY(!bench.board().bar().start().isEnabled());
    QVERIFY(bench.board().openImage(demoImage));
    QVERIFY(!bench.board().canStart()); // nothing is ticked
    bench.board().start();
    QVERIFY(bench.workbench.given<orders::ServeUnits>().empty());
    bench.model().tick({1}, true);
    QVERIFY(bench.board().bar().start().isEnabled());
    bench.workbench.serve({bench.row(1, 1, RowState::Running)});
    QVERIFY(!bench.board().canStart()); // one runs
    QVERIFY(!bench.board().bar().start().toolTip().isEmpty());
}

void QueueTest::eachRowTellsHowFarItIsAndWhatCameOfIt()
{
    QueueBench bench;
    QVERIFY(bench.board().openImage(demoImage));
    QueueRow passed = bench.row(1, 1, RowState::Passed);
    passed.visit.to = "1.25";
    passed.visit.parameters = 55;
    passed.visit.seconds = 9.8;
    QueueRow running = bench.row(2, 2, RowState::Running);
    running.what = say("writing page");
    running.visit.step = service::Step::Firmware;
    running.done = 17;
    running.total = 28;
    QueueRow refused = bench.row(3, 3, RowState::Refused);
    refused.visit.cause = Message::verbatim("several units answer as number 9");
    QueueRow failed = bench.row(4, 77, RowState::Failed); // whose device is gone
    failed.visit.step = service::Step::Firmware;
    failed.visit.cause = Message::verbatim("no answer");
    failed.visit.device = "sim:can/dmc60c:12";
    bench.workbench.time += std::chrono::seconds(5);
    bench.workbench.serve({passed, running, refused, failed});
    QCOMPARE(bench.model().rowCount(), 4);
    QCOMPARE(bench.cell(0, QueueModel::Versions), QStringLiteral("1.23 → 1.25"));
    QVERIFY(bench.cell(0, QueueModel::Outcome).contains(QStringLiteral("55")));
    QCOMPARE(bench.model().index(0, QueueModel::Share).data(QueueModel::ShareRole).toInt(), 100);
    QCOMPARE(bench.model().index(1, QueueModel::Share).data(QueueModel::ShareRole).toInt(),
        33); // (0.5 + 0.5 + 10 · 17/28) of 21
    QVERIFY(bench.cell(1, QueueModel::Time).startsWith(QStringLiteral("5.0")));
    QVERIFY(bench.cell(2, QueueModel::Outcome).contains(QStringLiteral("number 9")));
    QVERIFY(bench.cell(3, QueueModel::StepNow).contains(QStringLiteral("Firmware")));
    QCOMPARE(bench.cell(3, QueueModel::Unit), QStringLiteral("#12"));
    QCOMPARE(bench.board().bar().headline(), QStringLiteral("Unit 4 of 4"));
    QVERIFY(bench.says(QStringLiteral("1 done · 1 failed · 1 refused")));
    QVERIFY(bench.says(QStringLiteral("about 5 s left"))); // 9.8 s on average, 5 of them are over
}

void QueueTest::whatWasWrittenAndNotProvedIsNotCalledVerified()
{
    QueueBench bench;
    QVERIFY(bench.board().openImage(demoImage));
    QueueRow passed = bench.row(1, 1, RowState::Passed);
    passed.visit.to = passed.visit.from;
    bench.workbench.serve({passed});
    QCOMPARE(bench.cell(0, QueueModel::StepNow), QStringLiteral("verified"));
    QCOMPARE(bench.cell(0, QueueModel::Outcome), QStringLiteral("already 1.23"));
    passed.visit.unproved = true;
    bench.workbench.serve({passed});
    QCOMPARE(bench.cell(0, QueueModel::StepNow), QStringLiteral("written, not proved"));
    QVERIFY(!bench.cell(0, QueueModel::Outcome).contains(QStringLiteral("already")));
}

void QueueTest::theUnitBesideTheQueueIsTheChosenOrTheRunningOrTheLastOne()
{
    QueueBench bench;
    const auto shown = [&bench] { return bench.board().steps().findChild<QLabel *>()->text(); };
    QVERIFY(bench.board().openImage(demoImage));
    QCOMPARE(shown(), QStringLiteral("No unit selected"));
    QueueRow first = bench.row(1, 1, RowState::Passed);
    bench.workbench.time += std::chrono::seconds(9);
    QueueRow second = bench.row(2, 2, RowState::Running);
    bench.workbench.serve({first, second});
    QCOMPARE(shown(), QStringLiteral("DMC60C #7"));
    second.state = RowState::Failed;
    bench.workbench.serve({first, second}, false); // the queue has ended
    QCOMPARE(shown(), QStringLiteral("DMC60C #7"));
    QVERIFY(bench.board().steps().again().isEnabled());
    bench.board().table().selectRow(0);
    QCOMPARE(shown(), QStringLiteral("DMC60C #5"));
    bench.board().table().selectRow(2); // was not served
    QCOMPARE(shown(), QStringLiteral("DMC60C #9"));
    QVERIFY(!bench.board().steps().again().isVisible());
}

void QueueTest::pagesThatWereSentAgainAreThoseOfTheShownUnit()
{
    QueueBench bench;
    QVERIFY(bench.board().openImage(demoImage));
    auto *map = bench.board().findChild<PageMap *>();
    const auto hasAmber = [&] {
        const QImage image = map->grab().toImage();
        for (int y = 0; y < image.height(); ++y) {
            for (int x = 0; x < image.width(); ++x) {
                if (image.pixelColor(x, y) == bench.theme.theme().caution)
                    return true;
            }
        }
        return false;
    };
    QueueRow first = bench.row(1, 1, RowState::Running);
    const auto pages = [](PartState state) {
        std::map<int, PartState> parts;
        for (int page = 0; page < 40; ++page)
            parts[page] = state;
        return parts;
    };
    first.parts = pages(PartState::Repeated);
    bench.workbench.serve({first});
    QVERIFY(hasAmber());
    first.parts = pages(PartState::Done);
    bench.workbench.serve({first});
    QVERIFY(hasAmber()); // it was sent again
    first.state = RowState::Passed;
    bench.workbench.time += std::chrono::seconds(9);
    QueueRow second = bench.row(2, 2, RowState::Running);
    second.parts = pages(PartState::Done);
    bench.workbench.serve({first, second});
    QVERIFY(!hasAmber());
}

void QueueTest::whatMustNotBeCutIsShown()
{
    QueueBench bench;
    QVERIFY(bench.board().openImage(demoImage));
    QueueRow running = bench.row(1, 1, RowState::Running);
    bench.workbench.serve({running});
    QVERIFY(bench.says(QStringLiteral("Safe to unplug: DMC60C #5")));
    running.mayInterrupt = false;
    bench.workbench.serve({running});
    QVERIFY(bench.says(QStringLiteral("Do not unplug: DMC60C #5")));
    QCOMPARE(bench.cell(0, QueueModel::Outcome), QStringLiteral("do not unplug"));
}

void QueueTest::unitsThatComeAndGoLeaveTheChosenOneChosen()
{
    QueueBench bench;
    QVERIFY(bench.board().openImage(demoImage));
    const std::vector<QueueRow> rows{bench.row(1, 1, RowState::Running), bench.row(2, 2, RowState::Failed)};
    bench.workbench.serve(rows);
    const auto selected = [&bench] { return bench.board().table().selectionModel()->selectedRows().value(0).row(); };
    bench.board().table().selectRow(1);
    bench.add(4, 11, "sim:can", "2103343A7B01");
    bench.workbench.publish();
    QCOMPARE(bench.board().steps().row(), 2U); // not the one that runs: what is skipped is the chosen one
    bench.board().table().selectRow(2);        // #9, which is not in the queue
    std::swap(bench.workbench.device(2), bench.workbench.device(3));
    bench.workbench.publish();
    QCOMPARE(selected(), 3);
    bench.workbench.serve({rows[0], rows[1], bench.row(3, 3, RowState::Waiting)}); // it is put on
    QCOMPARE(bench.board().steps().row(), 3U);
    bench.workbench.shot.devices.erase(bench.workbench.shot.devices.begin() + 3); // and taken off
    bench.workbench.publish();
    QCOMPARE(bench.board().steps().row(), 3U);
}

void QueueTest::aUnitWhoseSelfTestTurnsItsMotorIsNotSafeToUnplug()
{
    QueueBench bench;
    QVERIFY(bench.board().openImage(demoImage));
    QueueRow testing = bench.row(1, 1, RowState::Running);
    testing.visit.step = service::Step::Test;
    bench.workbench.served.waiting = 1;
    bench.workbench.serve({testing});
    QVERIFY(!bench.says(QStringLiteral("Safe to unplug")));
    QVERIFY(bench.says(QStringLiteral("Do not unplug: DMC60C #5")));
    QVERIFY(bench.says(QStringLiteral("as soon as Arm in the header is held")));
    QCOMPARE(bench.cell(0, QueueModel::Outcome), QStringLiteral("hold Arm in the header"));
    QTableView &table = bench.board().table();
    const int cell = table.columnWidth(QueueModel::Outcome);
    const int words = table.fontMetrics().horizontalAdvance(bench.cell(0, QueueModel::Outcome));
    QTRY_VERIFY2(words < cell - 8 || table.rowHeight(0) >= 2 * table.fontMetrics().height(), "cut");
    for (int column = 0; column < QueueModel::Outcome; ++column) {
        const int needed
            = table.fontMetrics().horizontalAdvance(bench.cell(0, static_cast<QueueModel::Column>(column)));
        QVERIFY2(
            needed < table.columnWidth(column) - 8, qPrintable(bench.cell(0, static_cast<QueueModel::Column>(column))));
    }
    bench.workbench.served.waiting = 0;
    bench.workbench.serve({testing});
    QVERIFY(!bench.says(QStringLiteral("Safe to unplug")));
    QVERIFY(bench.says(QStringLiteral("The self-test turns the motor.")));
    QCOMPARE(bench.cell(0, QueueModel::Outcome), QStringLiteral("do not unplug"));
    testing.state = RowState::Passed;
    bench.workbench.serve({testing}, false);
    QVERIFY(!bench.says(QStringLiteral("Do not unplug")));
}

void QueueTest::aBarIsWholeOnlyForAUnitThatPassed()
{
    QueueBench bench;
    QVERIFY(bench.board().openImage(demoImage));
    const auto shareAt = [&bench](service::Step step, int done, RowState state) {
        QueueRow row = bench.row(1, 1, state);
        row.visit.step = step;
        row.done = done;
        row.total = 31;
        ServiceView view;
        view.rows = {row};
        const auto &shot = bench.workbench.shot;
        const auto totals = totalsOf(view, bench.workbench.time).share;
        return std::pair(queueLines(view, shot, nullptr, {}, bench.workbench.time).front().done.value_or(-1), totals);
    };
    using service::Step;
    QVERIFY2(shareAt(Step::Firmware, 31, RowState::Running).first < 100, "nothing is compared or proven yet");
    QVERIFY(shareAt(Step::Firmware, 31, RowState::Running).second < 1.0);
    QVERIFY(shareAt(Step::Proof, 31, RowState::Running).first < 100);
    QVERIFY(shareAt(Step::Firmware, 31, RowState::Running).first <= shareAt(Step::Proof, 0, RowState::Running).first);
    QVERIFY(shareAt(Step::Firmware, 0, RowState::Running).first < shareAt(Step::Firmware, 20, RowState::Running).first);
    QVERIFY2(shareAt(Step::Proof, 31, RowState::Failed).first < 100, "a failure is no green bar");
    QCOMPARE(shareAt(Step::Done, 31, RowState::Passed).first, 100);
}

void QueueTest::theLogTellsEveryUnit()
{
    QueueBench bench;
    QVERIFY(bench.board().openImage(demoImage));
    QueueRow one = bench.row(1, 1, RowState::Running);
    QueueRow two = bench.row(2, 3, RowState::Running);
    const auto line = [](int second, const char *text) {
        return LogLine{Instant(std::chrono::seconds(second)), Severity::Info, Message::verbatim(text)};
    };
    one.log = std::make_shared<std::vector<LogLine>>(std::vector{line(1, "first"), line(3, "third")});
    two.log = std::make_shared<std::vector<LogLine>>(std::vector{line(2, "second")});
    bench.workbench.serve({one, two});
    QCOMPARE(bench.board().log().count(), 3);
    const QStringList lines = bench.board().log().text().split(QLatin1Char('\n'));
    QVERIFY(lines[0].contains(QStringLiteral("SERIAL1  first")));
    QVERIFY(lines[1].contains(QStringLiteral("SERIAL2  second")));
    QVERIFY(lines[2].contains(QStringLiteral("third")));
    bench.workbench.serve({one, two});
    QCOMPARE(bench.board().log().count(), 3); // nothing twice
}

void QueueTest::pauseSkipRetryAndCancelAreOrders()
{
    QueueBench bench;
    QVERIFY(bench.board().openImage(demoImage));
    QVERIFY(!bench.board().bar().cancel().isEnabled());
    QueueRow failed = bench.row(4, 2, RowState::Failed);
    bench.workbench.serve({bench.row(3, 1, RowState::Running), failed});
    bench.board().bar().pause().click();
    bench.workbench.served.pausing = true;
    Q_EMIT bench.workbench.serviceChanged();
    QCOMPARE(bench.board().bar().headline(), QStringLiteral("Pauses after this unit"));
    bench.board().bar().pause().click();
    const auto pauses = bench.workbench.given<orders::PauseService>();
    QCOMPARE(pauses.size(), 2U);
    QVERIFY(pauses[0].on && !pauses[1].on);
    bench.board().steps().skip().click(); // of the one that runs
    QCOMPARE(bench.workbench.given<orders::SkipUnit>().at(0).row, 3U);
    bench.board().table().selectRow(1);
    QVERIFY(!bench.board().steps().skip().isEnabled());
    bench.board().steps().again().click();
    QCOMPARE(bench.workbench.given<orders::RetryUnit>().at(0).row, 4U);
    bench.board().bar().retry().click();
    QCOMPARE(bench.workbench.given<orders::RetryFailedUnits>().size(), 1U);
    bench.board().bar().cancel().click();
    QCOMPARE(bench.workbench.given<orders::CancelService>().size(), 1U);
}

void QueueTest::aCutQueueIsOfferedAndGoneOnWith()
{
    QueueBench bench;
    auto *banner = bench.board().findChild<Banner *>();
    bench.workbench.visited.cut = {"run 7", 3, 1};
    QVERIFY(bench.board().openImage(demoImage));
    QVERIFY(banner->isVisible());
    QVERIFY(banner->cause().contains(QStringLiteral("3 done, 1 open")));
    bench.board().goOn();
    const auto begun = bench.workbench.given<orders::ServeUnits>();
    QCOMPARE(begun.size(), 1U);
    QCOMPARE(begun.front().run, std::string("run 7"));
    QVERIFY(begun.front().chosen && begun.front().chosen->empty()); // what was cut off only
    QCOMPARE(begun.front().links.size(), 2U);                       // wherever it hangs now
    bench.workbench.serve({bench.row(1, 1, RowState::Running)});
    QVERIFY(!banner->isVisible());
}

void QueueTest::aCutQueueIsOfferedUntilItIsDismissed()
{
    QueueBench bench;
    auto *banner = bench.board().findChild<Banner *>();
    bench.workbench.visited.cut = {"run 7", 3, 1};
    QVERIFY(bench.board().openImage(demoImage));
    bench.board().goOn();
    bench.workbench.given<orders::ServeUnits>().at(0).finished(fail(Fault::Timeout, say("can0 is not open")));
    QVERIFY2(banner->isVisible(), "nothing came of it");
    for (int round = 0; round < 2; ++round) { // cancelled, and gone on with, and cancelled again
        bench.board().goOn();
        bench.workbench.serve({bench.row(1, 1, RowState::Running)});
        QVERIFY(!banner->isVisible());
        bench.workbench.serve({bench.row(1, 1, RowState::Skipped)}, false);
        QVERIFY(banner->isVisible());
    }
    Q_EMIT banner->dismissed();
    QVERIFY(!banner->isVisible());
    bench.workbench.publish();
    QVERIFY(!banner->isVisible());
}

void QueueTest::whatWasCutOffIsLookedForOnEveryLinkThatIsOpen()
{
    QueueBench bench;
    bench.workbench.visited.cut = {"run 7", 0, 1};
    QVERIFY(bench.board().openImage(demoImage));
    bench.workbench.shot.devices.clear(); // the cut has left it dead
    bench.workbench.publish();
    bench.board().goOn();
    QCOMPARE(bench.workbench.given<orders::ServeUnits>().at(0).links,
        (std::vector<std::string>{"sim:can", "socketcan:can1"}));
}

void QueueTest::simulatedUnitsAndRealOnesAreNotGoneOnWithTogether()
{
    QueueBench bench;
    auto *banner = bench.board().findChild<Banner *>();
    bench.workbench.visited.cut = {"run 7", 0, 1, true};
    QVERIFY(bench.board().openImage(demoImage));
    QVERIFY2(!banner->isVisible(), "there is no simulated bench");
    bench.workbench.shot.links.front().simulated = true;
    bench.workbench.publish();
    QVERIFY(banner->isVisible());
    bench.board().goOn();
    bench.workbench.visited.cut = {"run 8", 0, 1};
    QVERIFY(bench.board().openImage(demoImage));
    bench.board().goOn();
    const auto begun = bench.workbench.given<orders::ServeUnits>();
    QCOMPARE(begun.at(0).links, std::vector<std::string>{"sim:can"});
    QCOMPARE(begun.at(1).links, std::vector<std::string>{"socketcan:can1"});
}

void QueueTest::whatEndedIsSavedAsATable()
{
    QueueBench bench;
    QVERIFY(bench.board().openImage(demoImage));
    QueueRow waiting = bench.row(2, 2, RowState::Waiting);
    waiting.visit.id.clear();
    bench.workbench.serve({bench.row(1, 1, RowState::Passed), waiting}, false);
    bench.board().save(QStringLiteral("queue.csv"));
    QCOMPARE(bench.workbench.visited.exported.size(), 1U);
    QVERIFY(bench.workbench.lines.back().text.contains(QStringLiteral("queue.csv")));
}

void QueueTest::aRefusedStartIsSaid()
{
    QueueBench bench;
    QVERIFY(bench.board().openImage(demoImage));
    bench.model().tick({1}, true);
    bench.board().start();
    bench.workbench.given<orders::ServeUnits>().at(0).finished(
        fail(Fault::Unsafe, say("units are served already"), say("end that first")));
    QVERIFY(bench.workbench.lines.back().text.contains(QStringLiteral("served already")));
}

void QueueTest::ticksAreForKeyboardAndReader()
{
    QueueBench bench;
    QVERIFY(bench.board().openImage(demoImage));
    bench.board().table().setCurrentIndex(bench.model().index(0, 0));
    QTest::keyClick(&bench.board().table(), Qt::Key_Space);
    QCOMPARE(bench.model().ticked().size(), 1U);
    QVERIFY(!bench.model().index(0, 0).data(Qt::AccessibleTextRole).toString().startsWith(QLatin1Char(',')));
    for (QWidget *widget : bench.board().findChildren<QWidget *>()) {
        const bool control = widget->inherits("QAbstractButton") || widget->inherits("QAbstractItemView");
        if (!control || !widget->isVisible() || widget->inherits("QTableCornerButton")
            || widget->inherits("QHeaderView"))
            continue;
        QVERIFY2(!QAccessible::queryAccessibleInterface(widget)->text(QAccessible::Name).isEmpty(),
            widget->metaObject()->className());
    }
}

MB_WINDOW_TEST(QueueTest);
#include "tst_queue.moc"
